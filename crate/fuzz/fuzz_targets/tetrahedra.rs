//! Distances and paths inside of small meshes of tetrahedra of any kind.
#![no_main]

use arbitrary::Arbitrary;
use heatwalk::VertexId;
use heatwalk_fuzz::distances::ROUNDING;
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_fuzz::soups::AnyTetSoup;
use heatwalk_volume::{TetMesh, TetPoint, VolumeMethod, VolumeOptions, VolumeSolver};

#[derive(Arbitrary, Debug)]
struct Question {
    soup: AnyTetSoup,
    source: u8,
    from: u8,
}

libfuzzer_sys::fuzz_target!(|question: Question| {
    let mesh = match TetMesh::build(&question.soup.0) {
        Ok(mesh) => mesh,
        Err(error) => return check_sentence(&error.to_string()),
    };
    let vertex = |number: u8| VertexId(u32::from(number) % mesh.vertex_count() as u32);
    let (source, from) = (vertex(question.source), vertex(question.from));
    let mut solver = VolumeSolver::new(mesh);
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        let distance = match solver.distance(&[source], &VolumeOptions::by(method)) {
            Ok(distance) => distance,
            Err(error) => {
                check_sentence(&error.to_string());
                continue;
            }
        };
        let mesh = solver.mesh();
        let place = mesh.position(source);
        let largest = distance.values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        for (number, &value) in distance.values.iter().enumerate() {
            let is_reached = mesh.components()[number] == mesh.components()[source.0 as usize];
            assert!(value >= 0.0 && value.is_finite() == is_reached, "{value} at vertex {number}");
            let straight = mesh.position(VertexId(number as u32)).distance(place);
            if method == VolumeMethod::March {
                assert!(value >= straight - ROUNDING * largest, "{value} is less than the straight line of {straight}");
            }
        }
        match solver.path(&distance, TetPoint::Vertex(from)) {
            Ok(path) => assert!(path.length.is_finite() && path.points.iter().all(|point| point.is_finite())),
            Err(error) => check_sentence(&error.to_string()),
        }
    }
});
