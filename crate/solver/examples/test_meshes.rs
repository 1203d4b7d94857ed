//! Writes the meshes of the tests that have exact distances, for `node tools/test-data.mjs`.
//!
//! `cargo run -p heatwalk --example test_meshes -- FOLDER`

#[path = "../tests/common/meshes.rs"]
mod meshes;

use std::error::Error;
use std::fs;
use std::path::Path;

use heatwalk::Surface;
use heatwalk_model::io;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("give a folder")?;
    for name in meshes::NAMES {
        let mesh = meshes::mesh(name);
        let surface = Surface::build(&mesh)?;
        let is_welded = surface.positions().as_slice() == mesh.positions
            && surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).eq(mesh.triangles.iter().copied());
        assert!(is_welded, "{name}: the distances belong to the vertices of the input");
        let distances = vec![0.0; mesh.positions.len()];
        fs::write(Path::new(&folder).join(format!("{name}.ply")), io::write::distance_ply(&mesh, &distances))?;
    }
    Ok(())
}
