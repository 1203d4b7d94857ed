//! Files as the readers take them, and what has to be true of all that they give.

use std::collections::HashSet;

use heatwalk::{Soup, Surface};
use heatwalk_model::Model;
use heatwalk_model::io::{self, Budget};
use heatwalk_volume::TetMesh;

use crate::budget::within_budget;

/// Triangles of which a surface is built: what a reader repeats would take most of the time.
const BUILT: usize = 500;
/// Seconds after the beginning of a clip.
const MOMENT: f64 = 0.4;

/// Reads a mesh or points. All that the file refers to is the file itself, by any name.
pub fn mesh(name: &str, bytes: &[u8]) {
    let read = within_budget(2 * bytes.len(), || {
        let budget = Budget::of_file(bytes.len());
        io::read_mesh_or_points_within(&budget, name, bytes, &|_| budget.admit(bytes.to_vec()).ok())
    });
    io::upward(name, bytes);
    match read {
        Ok(model) => check_model(&model),
        Err(error) => check_sentence(&error.to_string()),
    }
}

/// Reads tetrahedra, and the surface of the same file. What the file refers to is `other`.
pub fn tetrahedra(name: &str, bytes: &[u8], other: &[u8]) {
    let both = bytes.len() + other.len();
    let read = within_budget(both, || heatwalk_volume::io::read(name, bytes, &|_| Some(other.to_vec())));
    match read {
        Ok(file) => {
            let vertices = file.soup.positions.len();
            assert!(file.soup.tetrahedra.iter().flatten().all(|&corner| (corner as usize) < vertices));
            if file.soup.tetrahedra.len() <= BUILT
                && let Err(error) = TetMesh::build(&file.soup)
            {
                check_sentence(&error.to_string());
            }
        }
        Err(error) => check_sentence(&error.to_string()),
    }
    match within_budget(both, || heatwalk_volume::io::read_surface(name, bytes, &|_| Some(other.to_vec()))) {
        Ok(soup) => check_soup(&soup),
        Err(error) => check_sentence(&error.to_string()),
    }
}

/// # Panics
/// Where a model refers to what it does not have, or cannot be selected from, moved or packed.
pub fn check_model(model: &Model) {
    let (soup, appearance) = (&model.soup, &model.appearance);
    check_soup(soup);
    let is_plain = appearance.seams.vertices.is_empty();
    let rows = if is_plain { soup.positions.len() } else { appearance.seams.vertices.len() };
    for (what, count) in [
        ("texture coordinates", appearance.texcoords.len()),
        ("colors", appearance.colors.len()),
        ("normals", appearance.normals.len()),
    ] {
        assert!(count == 0 || count == rows, "{count} {what} of {rows} rows");
    }
    if !is_plain {
        assert!(appearance.seams.corners.len() == soup.triangles.len(), "rows of each corner");
        assert!(appearance.seams.corners.iter().flatten().all(|&row| (row as usize) < rows));
    }
    for run in &appearance.runs {
        assert!(run.triangles.end <= soup.triangles.len());
        assert!(run.material.is_none_or(|material| material < appearance.materials.len()));
    }
    let packed = model.packed();
    let unpacked = Model::unpacked(&packed).expect("what was packed can be unpacked");
    assert!(unpacked.packed() == packed, "a packed model is the model");
    if soup.triangles.len() <= BUILT && !soup.parts.is_empty() {
        let first = model.select(&[0]).expect("the first part");
        check_soup(&first.soup);
    }
    for clip in 0..model.motion.clips().len().min(2) {
        let posed = model.posed(clip, MOMENT).expect("a moment of a clip");
        assert_eq!(posed.soup.positions.len(), soup.positions.len());
    }
}

fn check_soup(soup: &Soup) {
    let (vertices, triangles) = (soup.positions.len(), soup.triangles.len());
    assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < vertices), "a corner without a vertex");
    assert!(soup.attributes.iter().all(|attribute| attribute.values.len() == vertices), "values of each vertex");
    let mut taken = HashSet::new();
    for part in &soup.parts {
        for triangle in part.triangles() {
            assert!(triangle < triangles, "a part of triangles that there are not");
            assert!(taken.insert(triangle), "a triangle in two parts");
        }
    }
    assert!(soup.polygons.iter().all(|polygon| polygon.start < polygon.end && polygon.end <= triangles));
    assert!(soup.polygons.is_sorted_by(|a, b| a.end <= b.start), "polygons follow each other");
    if triangles <= BUILT
        && let Err(error) = Surface::build(soup)
    {
        check_sentence(&error.to_string());
    }
}

/// # Panics
/// Where an error has nothing to say, or says more than a person would read.
pub fn check_sentence(sentence: &str) {
    assert!(!sentence.is_empty() && sentence.len() < 2000, "{} letters: {sentence:.300}", sentence.len());
}
