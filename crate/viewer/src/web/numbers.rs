//! From flat numbers to vectors and their arrays.

use glam::{Vec3, Vec4};
use heatwalk_bake::{CONTACT_SIZE, Hierarchy, OCCLUSION_SIZE, Shade};
use js_sys::{Float32Array, Int8Array, Uint8Array, Uint16Array, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;

use super::properties::properties;
use crate::appearance::{MeshAppearance, MeshRun};
use crate::error::Error;
use crate::inner::InnerTriangles;
use crate::mesh::{MeshArrays, MeshPose};
use crate::patch::PatchArrays;
use crate::punctual::PunctualLight;
use crate::section::SectionArrays;
use crate::style::Finish;

#[wasm_bindgen(typescript_custom_section)]
const DRAWN: &str = "
/** Triangles to draw: `#D × 3` positions and unit normals, `#F × 3` indices, and the arrays of their hierarchy. */
export interface DrawnMesh {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  order: Uint32Array;
  boxes: Float32Array;
  /** `#D × 4`: two sets of texture coordinates; empty for none. */
  texcoords: Float32Array;
  /** `#D × 4`: linear RGBA, 65535 for 1; empty for none. */
  colors: Uint16Array;
  /** Three numbers a run of triangles of one material: its first triangle, the one after its last, and the material. */
  runs: Uint32Array;
}

/** Triangles inside of a solid: `#N × 3` positions and unit normals, `#T × 3` indices. */
export interface DrawnTriangles {
  positions: Float32Array;
  normals: Float32Array;
  /** `#N`, in the unit of the field's values. */
  values: Float32Array;
  triangles: Uint32Array;
}

/** What closes a cut; its values are Infinity where unreachable, and may be empty: no field. */
export interface DrawnSection {
  mesh: DrawnTriangles;
  /** `#N × 4`, the direction in which the values grow, 127 for a unit; empty where the values are. */
  tangents: Int8Array;
}

/** What a surface keeps off the light around it. */
export interface DrawnShade {
  contact: Uint8Array;
  occlusion: Uint8Array;
}
";

#[wasm_bindgen]
extern "C" {
    /// An object of JavaScript's with arrays.
    #[wasm_bindgen(typescript_type = "DrawnMesh")]
    pub type DrawnMesh;

    /// Triangles inside of a solid.
    #[wasm_bindgen(typescript_type = "DrawnTriangles")]
    pub type DrawnTriangles;

    /// The same with directions.
    #[wasm_bindgen(typescript_type = "DrawnSection")]
    pub type DrawnSection;

    /// Another one.
    #[wasm_bindgen(typescript_type = "DrawnShade")]
    pub type DrawnShade;
}

properties! {
    DrawnMesh {
        positions: Float32Array,
        normals: Float32Array,
        triangles: Uint32Array,
        order: Uint32Array,
        boxes: Float32Array,
        texcoords: Float32Array,
        colors: Uint16Array,
        runs: Uint32Array,
    }
}

properties! {
    DrawnTriangles {
        positions: Float32Array,
        normals: Float32Array,
        values: Float32Array,
        triangles: Uint32Array,
    }
}

properties! {
    DrawnSection {
        mesh: DrawnTriangles,
        tangents: Int8Array,
    }
}

properties! {
    DrawnShade {
        contact: Uint8Array,
        occlusion: Uint8Array,
    }
}

pub(super) fn shade(given: &DrawnShade) -> Result<Shade, Error> {
    let (contact, occlusion) = (given.contact().to_vec(), given.occlusion().to_vec());
    let found = contact.len() + occlusion.len();
    let expected = CONTACT_SIZE.pow(2) + 4 * OCCLUSION_SIZE.pow(3);
    Shade::from_arrays(contact, occlusion).ok_or(Error::WrongLength { what: "texels of the shade", expected, found })
}

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

/// Takes an array over in groups of numbers, without a copy.
fn groups<N: bytemuck::Pod, T: bytemuck::Pod>(what: &'static str, numbers: Vec<N>) -> Result<Vec<T>, Error> {
    let (found, group) = (numbers.len(), size_of::<T>() / size_of::<N>());
    let expected = found / group * group;
    bytemuck::allocation::try_cast_vec(numbers).map_err(|_| Error::WrongLength { what, expected, found })
}

pub(super) fn mesh_arrays(mesh: &DrawnMesh) -> Result<MeshArrays, Error> {
    let triangles: Vec<[u32; 3]> = groups("triangle indices", mesh.triangles().to_vec())?;
    let (order, boxes) = (mesh.order().to_vec(), mesh.boxes().to_vec());
    let found = order.len();
    let hierarchy = Hierarchy::from_arrays(order, groups("boxes", boxes)?, triangles.len());
    Ok(MeshArrays {
        positions: groups("positions", mesh.positions().to_vec())?,
        normals: groups("normals", mesh.normals().to_vec())?,
        appearance: appearance(mesh)?,
        hierarchy: hierarchy.ok_or(Error::WrongLength { what: "hierarchy", expected: triangles.len(), found })?,
        triangles,
    })
}

pub(super) fn patch_arrays(mesh: &DrawnMesh) -> Result<PatchArrays, Error> {
    Ok(PatchArrays {
        positions: groups("positions", mesh.positions().to_vec())?,
        normals: groups("normals", mesh.normals().to_vec())?,
        triangles: groups("triangle indices", mesh.triangles().to_vec())?,
        appearance: appearance(mesh)?,
    })
}

pub(super) fn mesh_pose(positions: &Float32Array, normals: &Float32Array) -> Result<MeshPose, Error> {
    let (positions, normals) = (positions.to_vec(), normals.to_vec());
    Ok(MeshPose { positions: groups("posed positions", positions)?, normals: groups("posed normals", normals)? })
}

pub(super) fn appearance(mesh: &DrawnMesh) -> Result<MeshAppearance, Error> {
    let runs: Vec<[u32; 3]> = groups("material runs", mesh.runs().to_vec())?;
    Ok(MeshAppearance {
        texcoords: groups("texture coordinates", mesh.texcoords().to_vec())?,
        colors: groups("vertex colors", mesh.colors().to_vec())?,
        runs: runs.into_iter().map(|[first, end, material]| MeshRun { triangles: first..end, material }).collect(),
    })
}

pub(super) fn inner_triangles(given: &DrawnTriangles) -> Result<InnerTriangles, Error> {
    Ok(InnerTriangles {
        positions: groups("positions", given.positions().to_vec())?,
        normals: groups("normals", given.normals().to_vec())?,
        values: given.values().to_vec(),
        triangles: groups("triangle indices", given.triangles().to_vec())?,
    })
}

pub(super) fn section(given: &DrawnSection) -> Result<SectionArrays, Error> {
    Ok(SectionArrays {
        mesh: inner_triangles(&given.mesh())?,
        tangents: groups("tangents", given.tangents().to_vec())?,
    })
}

/// Planes of four numbers each.
pub(super) fn planes(numbers: &[f32]) -> Result<Vec<Vec4>, Error> {
    let (planes, rest) = numbers.as_chunks::<4>();
    if !rest.is_empty() {
        let expected = 4 * (planes.len() + 1);
        return Err(Error::WrongLength { what: "planes of the cut", expected, found: numbers.len() });
    }
    Ok(planes.iter().copied().map(Vec4::from_array).collect())
}

/// Lights of twelve numbers each: the four of each field in turn.
pub(super) fn lights(numbers: &[f32]) -> Result<Vec<PunctualLight>, Error> {
    const NUMBERS: usize = 12;
    let (rows, rest) = numbers.as_chunks::<NUMBERS>();
    if !rest.is_empty() {
        let expected = (rows.len() + 1) * NUMBERS;
        return Err(Error::WrongLength { what: "lights", expected, found: numbers.len() });
    }
    if let Some(index) = rows.iter().position(|row| !row.iter().all(|number| number.is_finite())) {
        return Err(Error::NotFinite { what: "lights", index });
    }
    let part = |row: &[f32], at: usize| Vec4::from_slice(&row[4 * at..]);
    Ok(rows.iter().map(|row| PunctualLight { place: part(row, 0), axis: part(row, 1), color: part(row, 2) }).collect())
}
