//! Tetrahedra inside of small surfaces of any kind.
#![no_main]

use std::num::NonZeroUsize;

use arbitrary::Arbitrary;
use heatwalk::{Surface, go_on};
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_fuzz::soups::AnySoup;
use heatwalk_volume::TetMesh;
use heatwalk_volume::fill::{Resolution, Solid};

/// Cells along the longest side, at most.
const MOST_CELLS: u8 = 12;

#[derive(Arbitrary, Debug)]
struct Filling {
    soup: AnySoup,
    cells: u8,
}

libfuzzer_sys::fuzz_target!(|filling: Filling| {
    let soup = filling.soup.0;
    let Ok(surface) = Surface::build(&soup) else { return };
    let cells = Resolution::Cells(f64::from(filling.cells % (MOST_CELLS + 1)));
    let filled = Solid::new(&soup, &surface, NonZeroUsize::MIN).and_then(|solid| {
        let estimate = solid.estimate(cells)?;
        assert!(estimate.cells >= 1.0);
        solid.fill(cells, &mut go_on)
    });
    match filled {
        Ok(filled) => {
            assert!(filled.soup.positions.iter().all(|position| position.is_finite()));
            TetMesh::build(&filled.soup).expect("tetrahedra that fill are a mesh");
        }
        Err(error) => check_sentence(&error.to_string()),
    }
});
