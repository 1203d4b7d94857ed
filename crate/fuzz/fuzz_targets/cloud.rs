//! Surfaces between points without faces.
#![no_main]

use std::num::NonZeroUsize;

use arbitrary::Arbitrary;
use glam::DVec3;
use heatwalk::Surface;
use heatwalk_cloud::Cloud;
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_fuzz::soups::AnySoup;

#[derive(Arbitrary, Debug)]
struct Points {
    /// Its triangles are not looked at.
    soup: AnySoup,
    normals: Option<Vec<[i8; 3]>>,
}

libfuzzer_sys::fuzz_target!(|given: Points| {
    let points = given.soup.0.positions;
    let normals = given.normals.map(|mut normals| {
        normals.resize(points.len(), [0; 3]);
        normals.into_iter().map(|normal| DVec3::from(normal.map(f64::from))).collect::<Vec<_>>()
    });
    let count = points.len();
    match Cloud::join_oriented("any", points, normals.as_deref().unwrap_or_default(), NonZeroUsize::MIN) {
        Ok(Cloud { soup, report }) => {
            assert_eq!((report.points, soup.positions.len()), (count, count));
            assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < count));
            if let Err(error) = Surface::build(&soup) {
                check_sentence(&error.to_string());
            }
        }
        Err(error) => check_sentence(&error.to_string()),
    }
});
