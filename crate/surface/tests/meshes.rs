//! Real files of several exporters, in the folder that the environment variable HEATWALK_MESHES names.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::PathBuf;

use heatwalk_surface::Soup;
use heatwalk_surface::io;
use heatwalk_surface::{Error, Result};

fn folder(name: &str) -> PathBuf {
    let meshes = std::env::var_os("HEATWALK_MESHES").expect("HEATWALK_MESHES names the folder of the meshes");
    PathBuf::from(meshes).join(name)
}

fn read(folder: &std::path::Path, name: &str) -> Result<Soup> {
    let bytes = fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    io::read(name, &bytes, &|uri| fs::read(folder.join(uri)).ok())
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn table_1_has_the_triangles_of_the_study() {
    let folder = folder("table1");
    for (name, part, triangles) in [
        ("high_genus.off", "high_genus", 3328),
        ("bague.off", "bague", 5304),
        ("cow.off", "cow", 5804),
        ("triceratops.off", "triceratops", 5660),
        ("sphere3.glb", "Sphere", 6912),
        ("hemisphere.glb", "Sphere", 3456),
        ("skull.glb", "obj", 12200),
        ("maze.glb", "road2", 5120),
        ("horse.off", "horse", 39996),
        ("dragon.glb", "Box01", 20388),
    ] {
        let soup = read(&folder, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let found = soup.parts.iter().find(|found| found.name.starts_with(part));
        let found = found.unwrap_or_else(|| panic!("{name} has the parts {:?}", soup.parts));
        assert_eq!(found.triangles.len(), triangles, "{name}");
    }
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn exact_meshes_are_read() {
    let folder = folder("exact");
    for (name, vertices, triangles) in [
        ("cow.off", 2904, 5804),
        ("spot.off", 2930, 5856),
        ("bunny.off", 14290, 28576),
        ("half_sphere.off", 2051, 4000),
        ("horse_97k.off", 48485, 96966),
    ] {
        let soup = read(&folder, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!((soup.positions.len(), soup.triangles.len()), (vertices, triangles), "{name}");
    }
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn gltf_files_are_read_or_refused_by_name() {
    let folder = folder("gltf");
    for (name, triangles) in [("fox.glb", 576), ("torus.gltf", 3072), ("spot.glb", 5856), ("spot_quantize.glb", 5856)] {
        let soup = read(&folder, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(soup.triangles.len(), triangles, "{name}");
    }
    for name in ["BoxDraco.gltf", "DracoSparseMesh.gltf", "dense_sphere.glb", "spot_draco.glb"] {
        let error = read(&folder, name).unwrap_err();
        assert!(matches!(&error, Error::Unsupported { feature, .. } if feature.contains("draco")), "{name}: {error}");
    }
    for name in ["BoxMeshopt.glb", "BoxMeshopt.gltf", "spot_meshopt.glb"] {
        let error = read(&folder, name).unwrap_err();
        assert!(matches!(&error, Error::Unsupported { feature, .. } if feature.contains("meshopt")), "{name}: {error}");
    }
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn quantised_and_plain_encodings_agree() {
    let folder = folder("gltf");
    let (plain, quantised) = (read(&folder, "spot.glb").unwrap(), read(&folder, "spot_quantize.glb").unwrap());
    let size = plain.positions.iter().map(|position| position.length()).fold(0.0, f64::max);
    // gltf-transform keeps 14 bits over the largest side, 2 · 0.859: half a step along each axis.
    let bound = 0.75_f64.sqrt() * 2.0 * size / f64::from(1 << 14);
    let centroids = |soup: &Soup| {
        let mut sum = glam::DVec3::ZERO;
        soup.triangles.iter().flatten().for_each(|&corner| sum += soup.positions[corner as usize]);
        sum / (3 * soup.triangles.len()) as f64
    };
    assert_eq!(plain.positions.len(), quantised.positions.len());
    assert!(centroids(&plain).distance(centroids(&quantised)) < bound);
    for &position in &quantised.positions {
        let nearest = plain.positions.iter().map(|other| other.distance(position)).fold(f64::INFINITY, f64::min);
        assert!(nearest < bound, "{position} is {nearest} from the nearest vertex");
    }
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn the_fox_stands_in_its_rest_pose() {
    let folder = folder("gltf");
    let fox = read(&folder, "fox.glb").unwrap();
    let lower = fox.positions.iter().copied().reduce(glam::DVec3::min).unwrap();
    let upper = fox.positions.iter().copied().reduce(glam::DVec3::max).unwrap();
    // Its accessor's bounds: the rest pose of this file is its bind pose, but for rounding in f32.
    assert!((lower.y - -0.1217).abs() < 0.5 && (upper.y - 78.907).abs() < 0.5, "{lower} {upper}");
    assert!((upper.z - lower.z - 154.7).abs() < 1.0, "{lower} {upper}");
}
