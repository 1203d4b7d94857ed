//! GIFTI (Harwell et al., "GIFTI Surface Data Format", version 1.0): surfaces of brains (`.surf.gii`), whose arrays are text, base64, packed or not, or
//! bytes of another file, of either order. Coordinates are millimeters, in the data space of the file; a transform from there to
//! another space is not applied, as in other programs.

mod document;

use glam::DVec3;
use heatwalk_surface::{Soup, Unit};

use self::document::Array;
use super::budget::Budget;
use super::format::Format;
use super::reader::{Reporter, Resources};
use super::scalar::whole;
use super::xml;
use crate::error::{Error, Result};
use crate::model::Model;

const GIFTI: Reporter = Reporter("GIFTI");

pub(super) const FORMAT: Format = Format {
    extensions: &["gii"],
    is: has_header,
    read: |budget, name, bytes, resources| read(budget, name, bytes, resources).map(Model::from),
    upward: Some(DVec3::Z),
};

fn has_header(bytes: &[u8]) -> bool {
    xml::has_root(bytes, b"<GIFTI")
}

fn read(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    let contents = document::read(budget, bytes, resources)?;
    let points = only(&contents.arrays, "POINTSET")?;
    let triangles = only(&contents.arrays, "TRIANGLE")?;
    let mut positions = budget.list(points.rows)?;
    positions.extend(points.numbers.chunks_exact(3).map(DVec3::from_slice));
    let mut corners = budget.list(triangles.rows)?;
    for (triangle, row) in triangles.numbers.chunks_exact(3).enumerate() {
        let mut vertices = [0; 3];
        for (vertex, &number) in vertices.iter_mut().zip(row) {
            let place = || format!("face {triangle}");
            let index = whole(number).ok_or_else(|| {
                GIFTI.at(
                    place(),
                    format!("vertex {number} is no index, which is whole and not negative; repair the file"),
                )
            })?;
            if index >= positions.len() as u64 {
                return Err(GIFTI.no_vertex(place(), index, positions.len(), 0));
            }
            *vertex = index as u32;
        }
        corners.push(vertices);
    }
    Ok(Soup { unit: Some(Unit::Millimeter), ..Soup::single(name, positions, corners) })
}

/// The array of rows of three numbers that has this intent.
fn only<'a>(arrays: &'a [Array], intent: &str) -> Result<&'a Array> {
    let mut found = arrays.iter().filter(|array| array.intent == intent);
    let Some(array) = found.next() else {
        let problem = "there is no surface in it; give the file of points and triangles (.surf.gii)";
        return Err(GIFTI.at("document", problem));
    };
    if found.next().is_some() {
        let (feature, remedy) = ("several surfaces in one file".to_owned(), "save each by itself".to_owned());
        return Err(Error::Unsupported { format: "GIFTI", feature, remedy });
    }
    if array.columns != 3 {
        let problem =
            format!("the array {intent} has rows of {} numbers in place of 3; save the file again", array.columns);
        return Err(GIFTI.at("document", problem));
    }
    Ok(array)
}
