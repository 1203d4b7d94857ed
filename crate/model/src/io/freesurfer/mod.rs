//! Surfaces of FreeSurfer (`MRISwriteTriangularFile`, `MRISread`): triangles, and quadrilaterals of former versions, which are cut as FreeSurfer
//! cuts them. All numbers have the most significant byte first. Coordinates are millimeters around the center of the volume ("surface
//! RAS"), as other programs read them; what follows the triangles says where that is, and lengths need it not.

mod annotation;
mod bytes;

use glam::DVec3;
use heatwalk_surface::{Soup, Unit};

use self::bytes::{Bytes, FREESURFER};
use super::budget::Budget;
use super::format::Format;
use crate::error::Result;
use crate::model::Model;

pub use annotation::read as read_annotation;

/// First bytes of files of triangles.
const TRIANGLES: [u8; 3] = [0xFF, 0xFF, 0xFE];
/// Of files of quadrilaterals with coordinates of 16 bits, in hundredths; other kinds of files begin with them, too.
const QUADS_OF_INTEGERS: [u8; 3] = [0xFF, 0xFF, 0xFF];
/// Of files of quadrilaterals with coordinates of 32 bits.
const QUADS: [u8; 3] = [0xFF, 0xFF, 0xFD];

pub const FORMAT: Format = Format {
    extensions: &["inflated", "orig", "pial", "smoothwm", "sphere", "white"],
    is: |bytes| bytes.starts_with(&TRIANGLES) || bytes.starts_with(&QUADS),
    read: |budget, name, bytes, _| read(budget, name, bytes).map(Model::from),
    upward: Some(DVec3::Z),
};

fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let mut bytes = Bytes::new(bytes);
    let (positions, triangles) = match bytes.take()? {
        TRIANGLES => triangles(budget, &mut bytes)?,
        QUADS => quads(budget, &mut bytes, 4)?,
        QUADS_OF_INTEGERS => quads(budget, &mut bytes, 2)?,
        _ => {
            let problem = "it does not begin as a surface of FreeSurfer does; save it again, in binary form";
            return Err(FREESURFER.at("byte 0", problem));
        }
    };
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&missing) = corners.iter().find(|&&corner| corner as usize >= positions.len()) {
            return Err(FREESURFER.no_vertex(format!("face {triangle}"), missing.into(), positions.len(), 0));
        }
    }
    Ok(Soup { unit: Some(Unit::Millimeter), ..Soup::single(name, positions, triangles) })
}

type Mesh = (Vec<DVec3>, Vec<[u32; 3]>);

fn triangles(budget: &Budget, bytes: &mut Bytes) -> Result<Mesh> {
    // Who made it when, and an empty line.
    bytes.skip_line()?;
    bytes.skip_line()?;
    let counts = [bytes.take()?, bytes.take()?].map(u32::from_be_bytes);
    bytes.require(counts[0].into(), 12)?;
    let mut positions = budget.list(counts[0] as usize)?;
    for _ in 0..counts[0] {
        positions.push(bytes.position(4)?);
    }
    bytes.require(counts[1].into(), 12)?;
    let mut triangles = budget.list(counts[1] as usize)?;
    for _ in 0..counts[1] {
        triangles.push([bytes.take()?, bytes.take()?, bytes.take()?].map(u32::from_be_bytes));
    }
    Ok((positions, triangles))
}

/// With coordinates of so many bytes.
fn quads(budget: &Budget, bytes: &mut Bytes, width: usize) -> Result<Mesh> {
    let counts = [bytes.index()?, bytes.index()?];
    bytes.require(counts[0].into(), 3 * width)?;
    let mut positions = budget.list(counts[0] as usize)?;
    for _ in 0..counts[0] {
        positions.push(bytes.position(width)?);
    }
    bytes.require(counts[1].into(), 12)?;
    let mut triangles = budget.list(2 * counts[1] as usize)?;
    for _ in 0..counts[1] {
        let [a, b, c, d] = [bytes.index()?, bytes.index()?, bytes.index()?, bytes.index()?];
        triangles.extend(if a % 2 == 0 { [[a, b, d], [c, d, b]] } else { [[a, b, c], [a, c, d]] });
    }
    Ok((positions, triangles))
}
