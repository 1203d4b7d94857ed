//! Tetrahedra inside of surfaces.

use std::fs;

use heatwalk_volume::{io, shapes};

use crate::{folder, json, refused, succeed};

#[test]
fn a_closed_surface_is_filled_and_written() {
    let folder = folder("fill");
    for name in ["a.msh", "a.vtu"] {
        let answer = json(&folder, &["fill", "torus.ply", "--resolution", "24", "--output", name]);
        let file = io::read(name, &fs::read(folder.join(name)).unwrap(), &|_| None).unwrap();
        assert_eq!(answer["tetrahedra"], file.soup.tetrahedra.len());
        assert_eq!(answer["tetrahedron_vertices"], file.soup.positions.len());
        let [volume, expected] = ["volume", "surface_volume"].map(|key| answer[key].as_f64().unwrap());
        assert!((volume / expected - 1.0).abs() < 0.02, "{volume} {expected}");
        assert!(answer["dihedral_angles"][0].as_f64().unwrap() > 9.3);
        assert!(answer["timings_ms"]["fill"].is_number());
        assert_eq!((&answer["cells"], &answer["holes"]), (&24.0.into(), &0.into()));
    }
    let count = json(&folder, &["fill", "torus.ply", "--tetrahedra", "5000"])["tetrahedra"].as_f64().unwrap();
    assert!((count / 5000.0 - 1.0).abs() < 0.1, "{count}");
    let sentence = succeed(&folder, &["fill", "torus.ply", "--resolution", "24"]);
    assert!(sentence.contains("tetrahedra over") && sentence.contains("the surface encloses"), "{sentence}");
}

#[test]
fn what_cannot_be_filled_is_refused() {
    let folder = folder("fill_refused");
    fs::write(folder.join("full.msh"), io::write::msh(&shapes::pierced_cube(0.4, 2, 0.0), None)).unwrap();
    for (arguments, hint) in [
        (&["fill", "torus.ply"][..], "--resolution"),
        (&["fill", "torus.ply", "--resolution", "0"], "from 1 to 1024"),
        (&["fill", "torus.ply", "--resolution", "8", "--tetrahedra", "9"], "cannot be used"),
        (&["fill", "torus.ply", "--resolution", "8", "--output", "a.obj"], ".vtu"),
        (&["fill", "grid.ply", "--resolution", "8"], "a hole of 40 edges"),
        (&["fill", "full.msh", "--resolution", "8"], "full.msh holds tetrahedra already"),
        (&["fill", "shape:cave", "--resolution", "8"], "holds tetrahedra already"),
    ] {
        let line = refused(&folder, arguments);
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
}
