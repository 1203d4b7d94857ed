//! Small meshes that lie in the repository or are made in code, and have exact distances beside them: see
//! `tests/data/README.md`.

use glam::DVec3;
use heatwalk::Soup;
use heatwalk_model::io;
use heatwalk_shapes as shapes;

/// Closed and scanned; with a boundary; of many handles; modelled; and of slivers.
pub const NAMES: [&str; 5] = ["bunny", "hemisphere", "high_genus", "triceratops", "slivers"];

/// How much flatter than its torus the mesh of slivers is.
const SQUEEZE: f64 = 0.02;

/// The mesh of one of the [`NAMES`].
pub fn mesh(name: &str) -> Soup {
    match name {
        "bunny" => io::read("bunny.ply", include_bytes!("../data/bunny.ply"), &|_| None).expect("a readable mesh").soup,
        // Part 1 is the stand.
        "hemisphere" => shapes::hemisphere(20).select(&[0]).expect("a part"),
        "high_genus" => shapes::high_genus(0.12),
        "triceratops" => shapes::triceratops(0.06),
        "slivers" => {
            let mut soup = shapes::torus(1.0, 0.4, 60, 25);
            soup.positions.iter_mut().for_each(|position| *position *= DVec3::new(1.0, 1.0, SQUEEZE));
            soup
        }
        _ => panic!("there is no mesh {name}"),
    }
}
