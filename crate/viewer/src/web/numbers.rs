//! From flat numbers to vectors and their arrays.

use glam::Vec3;

use crate::error::Error;
use crate::mesh::MeshArrays;
use crate::style::Finish;

pub(super) fn finish(what: &'static str, numbers: &[f32]) -> Result<Finish, Error> {
    let &[metalness, roughness, glow] = numbers else {
        return Err(Error::WrongLength { what, expected: 3, found: numbers.len() });
    };
    Ok(Finish { metalness, roughness, glow })
}

pub(super) fn points(what: &'static str, numbers: &[f32]) -> Result<Vec<Vec3>, Error> {
    let (triples, rest) = numbers.as_chunks::<3>();
    if rest.is_empty() {
        Ok(triples.iter().copied().map(Vec3::from_array).collect())
    } else {
        Err(Error::WrongLength { what, expected: 3 * triples.len(), found: numbers.len() })
    }
}

pub(super) fn color(what: &'static str, numbers: &[f32]) -> Result<Vec3, Error> {
    <[f32; 3]>::try_from(numbers).map(Vec3::from_array).map_err(|_| Error::WrongLength {
        what,
        expected: 3,
        found: numbers.len(),
    })
}

/// Takes an array over as triples, without a copy.
fn triples<N: bytemuck::Pod, T: bytemuck::Pod>(what: &'static str, numbers: Vec<N>) -> Result<Vec<T>, Error> {
    let found = numbers.len();
    bytemuck::allocation::try_cast_vec(numbers).map_err(|_| Error::WrongLength { what, expected: found / 3 * 3, found })
}

pub(super) fn mesh_arrays(positions: Vec<f32>, normals: Vec<f32>, triangles: Vec<u32>) -> Result<MeshArrays, Error> {
    Ok(MeshArrays {
        positions: triples("positions", positions)?,
        normals: triples("normals", normals)?,
        triangles: triples("triangle indices", triangles)?,
    })
}
