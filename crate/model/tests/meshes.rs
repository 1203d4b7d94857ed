//! Real files of several exporters, in the folder that the environment variable HEATWALK_MESHES names.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::PathBuf;

use heatwalk_model::{Result, io};
use heatwalk_surface::Soup;

fn folder(name: &str) -> PathBuf {
    let meshes = std::env::var_os("HEATWALK_MESHES").expect("HEATWALK_MESHES names the folder of the meshes");
    PathBuf::from(meshes).join(name)
}

fn read(folder: &std::path::Path, name: &str) -> Result<Soup> {
    let bytes = fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    io::read(name, &bytes, &|uri| fs::read(folder.join(uri)).ok()).map(|model| model.soup)
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
        assert_eq!(found.len(), triangles, "{name}");
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
fn gltf_files_are_read_compressed_or_not() {
    let folder = folder("gltf");
    for (name, triangles) in [
        ("fox.glb", 576),
        ("torus.gltf", 3072),
        ("spot.glb", 5856),
        ("spot_quantize.glb", 5856),
        ("spot_draco.glb", 5856),
        ("spot_meshopt.glb", 5856),
        ("BoxMeshopt.glb", 12),
        ("BoxMeshopt.gltf", 12),
        ("DracoSparseMesh.gltf", 102),
        ("dense_sphere.glb", 30720),
    ] {
        let soup = read(&folder, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(soup.triangles.len(), triangles, "{name}");
    }
}

#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn all_encodings_of_a_surface_agree() {
    let folder = folder("gltf");
    let plain = read(&folder, "spot.glb").unwrap();
    let size = plain.positions.iter().map(|position| position.length()).fold(0.0, f64::max);
    // gltf-transform keeps 14 bits over the largest side, 2 · 0.859: half a step along each axis.
    let bound = 0.75_f64.sqrt() * 2.0 * size / f64::from(1 << 14);
    let nearest = |position: glam::DVec3| {
        let distances = plain.positions.iter().map(|other| other.distance(position)).enumerate();
        distances.min_by(|(_, a), (_, b)| a.total_cmp(b)).unwrap()
    };
    // A triangle from its least corner on, so that only its orientation counts.
    let sorted = |triangles: Vec<[u32; 3]>| {
        let mut triangles: Vec<[u32; 3]> = triangles
            .into_iter()
            .map(|mut triangle| {
                let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap();
                triangle.rotate_left(least);
                triangle
            })
            .collect();
        triangles.sort_unstable();
        triangles
    };
    for name in ["spot_quantize.glb", "spot_meshopt.glb", "spot_draco.glb"] {
        let coded = read(&folder, name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(plain.positions.len(), coded.positions.len(), "{name}");
        let known: Vec<u32> = coded
            .positions
            .iter()
            .map(|&position| {
                let (vertex, distance) = nearest(position);
                assert!(distance < bound, "{name}: {position} is {distance} from the nearest vertex");
                vertex as u32
            })
            .collect();
        let triangles = coded.triangles.iter().map(|triangle| triangle.map(|corner| known[corner as usize])).collect();
        assert!(sorted(triangles) == sorted(plain.triangles.clone()), "{name} has other triangles");
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
