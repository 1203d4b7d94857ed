//! Meshes of others with exact distances by another program, in the folder that HEATWALK_MESHES names.

use std::path::{Path, PathBuf};

use heatwalk::{Element as _, InputVertex};
use heatwalk_model::io;
use libtest_mimic::Failed;

use crate::device::{BOUNDS, Device, compare, solved, surface};

/// Meshes, each with a vertex of the input that distances are from.
const FIELDS: [(&str, usize); 5] =
    [("cow", 1452), ("spot", 0), ("half_sphere", 1025), ("bunny", 7145), ("horse_97k", 24242)];

pub fn errors_of_large_meshes_are_small(device: &Device) -> Result<(), Failed> {
    let meshes = std::env::var_os("HEATWALK_MESHES").ok_or("HEATWALK_MESHES names the folder of the large meshes")?;
    let folder = PathBuf::from(meshes).join("exact");
    for (name, source) in FIELDS {
        let mesh = folder.join(format!("{name}.off"));
        let surface = surface(&io::read(&mesh.to_string_lossy(), &std::fs::read(&mesh)?, &|_| None)?.soup);
        let vertex = surface.require_vertex(InputVertex::from_index(source))?;
        let (values, progress) = solved(&mut device.field(&surface)?, &[vertex])?;
        println!("{name}: {} faces, {} rounds", surface.face_count(), progress.rounds);
        let known = numbers(&folder.join(format!("{name}.src{source}.npy")))?;
        let pairs = surface.vertices_of_inputs().iter().zip(known);
        let pairs = pairs.filter_map(|(vertex, exact)| Some((values[(*vertex)?.index()], exact)));
        let (values, exact): (Vec<f64>, Vec<f64>) = pairs.unzip();
        compare(&values, &exact, surface.mean_edge(), BOUNDS)?;
    }
    Ok(())
}

/// One-dimensional float64 array: ten bytes of magic, version and header length, a header, then the values.
fn numbers(path: &Path) -> Result<Vec<f64>, Failed> {
    let npy = std::fs::read(path)?;
    let header = u16::from_le_bytes([npy[8], npy[9]]) as usize;
    let values = npy[10 + header..].chunks_exact(8);
    Ok(values.map(|chunk| f64::from_le_bytes(chunk.try_into().expect("eight bytes"))).collect())
}
