//! Files of distances.

use glam::DVec3;
use heatwalk::Soup;
use heatwalk_bindings::{Failure, Resource, Result, resources};
use heatwalk_curves::write;
use heatwalk_model::{Model, io};
use wasm_bindgen::prelude::*;

use crate::files::FileUnit;

/// A file of distances, one a vertex: "csv", "npy", "ply" or "glb", or "weights.ply" with vertex colors. `positions` are `#V × 3`,
/// `triangles` `#F × 3`. All lengths are told in this unit.
///
/// # Errors
/// For another kind of file.
#[wasm_bindgen]
pub fn distance_file(
    kind: &str,
    positions: &[f64],
    triangles: &[u32],
    distances: &[f64],
    unit: FileUnit,
) -> Result<Vec<u8>> {
    let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
    let soup = Soup::single("surface", positions, triangles.as_chunks().0.to_vec());
    distances_in(kind, soup.into(), distances, unit)
}

/// The same of some parts of a mesh file, with its materials where the kind of file has these. `resource` gives the bytes of files
/// that it refers to.
///
/// # Errors
/// As reading the file has.
#[wasm_bindgen]
pub fn distance_file_of(
    kind: &str,
    name: &str,
    bytes: &[u8],
    resource: &Resource,
    parts: &[u32],
    distances: &[f64],
    unit: FileUnit,
) -> Result<Vec<u8>> {
    let file = io::read(name, bytes, &resources(resource))?;
    let parts: Vec<usize> = parts.iter().map(|&part| part as usize).collect();
    distances_in(kind, file.chosen(&parts)?, distances, unit)
}

fn distances_in(kind: &str, mut model: Model, distances: &[f64], unit: FileUnit) -> Result<Vec<u8>> {
    if model.soup.positions.len() != distances.len() {
        return Err(Failure::misuse("there is not one distance for each vertex of the file"));
    }
    let FileUnit { scale, unit } = unit;
    let distances: Vec<f64> = distances.iter().map(|distance| scale * distance).collect();
    let distances = distances.as_slice();
    model.soup.positions.iter_mut().for_each(|position| *position *= scale);
    Ok(match kind {
        "csv" => io::write::distance_csv(&[(&write::column("distance", unit), distances)]),
        "npy" => io::write::distance_npy(distances),
        "ply" => write::with_ply_comment(io::write::distance_ply(&model.soup, distances), unit),
        "weights.ply" => write::with_ply_comment(io::write::weights_ply(&model.soup, distances), unit),
        "glb" => io::write::distance_glb(&model, distances),
        _ => return Err(Failure::misuse("there is no such file of distances")),
    })
}
