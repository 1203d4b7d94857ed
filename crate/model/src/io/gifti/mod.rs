//! GIFTI (Harwell et al., "GIFTI Surface Data Format", version 1.0): surfaces of brains (`.surf.gii`), whose arrays are text, base64, packed or not, or
//! bytes of another file, of either order. Coordinates are millimeters, in the data space of the file; a transform from there to
//! another space is not applied, as in other programs.

mod document;

use std::collections::HashMap;

use glam::DVec3;
use heatwalk_surface::{Soup, Unit};

use self::document::{Array, Contents, GIFTI};
use super::budget::Budget;
use super::format::Format;
use super::labels::Labels;
use super::reader::Resources;
use super::scalar::whole;
use super::xml;
use crate::error::{Error, Result};
use crate::model::Model;

pub(super) const FORMAT: Format = Format {
    extensions: &["gii"],
    is: has_header,
    read: |budget, name, bytes, resources| read(budget, name, bytes, resources).map(Model::from),
    upward: Some(DVec3::Z),
};

pub fn has_header(bytes: &[u8]) -> bool {
    xml::has_root(bytes, b"<GIFTI")
}

fn read(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    let Contents { arrays, .. } = document::read(budget, bytes, resources)?;
    let points = of_three(only(&arrays, "POINTSET", SURFACES)?)?;
    let triangles = of_three(only(&arrays, "TRIANGLE", SURFACES)?)?;
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

/// The labels of vertices.
pub fn labels(budget: &Budget, bytes: &[u8]) -> Result<Labels> {
    let Contents { arrays, labels: table } = document::read(budget, bytes, &|_| None)?;
    let keys = only(&arrays, "LABEL", LABELS)?;
    let mut label_of_key = HashMap::new();
    let mut labels = Labels { names: Vec::new(), of_vertices: budget.list(keys.numbers.len())? };
    for (key, name) in table {
        label_of_key.entry(key).or_insert(labels.names.len() as u32);
        labels.names.push(name);
    }
    let label = |&key: &f64| (key.fract() == 0.0).then(|| label_of_key.get(&(key as i64)).copied()).flatten();
    labels.of_vertices.extend(keys.numbers.iter().map(label));
    Ok(labels)
}

/// What is said where an array is missing, and where it is there several times.
type Said = [&'static str; 2];

const SURFACES: Said =
    ["there is no surface in it; give the file of points and triangles (.surf.gii)", "several surfaces in one file"];
const LABELS: Said = ["there are no labels in it; give a .label.gii file", "several maps of labels in one file"];

/// The array that has this intent.
fn only<'a>(arrays: &'a [Array], intent: &str, [missing, several]: Said) -> Result<&'a Array> {
    let mut found = arrays.iter().filter(|array| array.intent == intent);
    let array = found.next().ok_or_else(|| GIFTI.at("document", missing))?;
    if found.next().is_some() {
        let (feature, remedy) = (several.to_owned(), "save each by itself".to_owned());
        return Err(Error::Unsupported { format: "GIFTI", feature, remedy });
    }
    Ok(array)
}

/// Refuses an array whose rows have not three numbers.
fn of_three(array: &Array) -> Result<&Array> {
    if array.columns == 3 {
        return Ok(array);
    }
    let (intent, columns) = (&array.intent, array.columns);
    let problem = format!("the array {intent} has rows of {columns} numbers in place of 3; save the file again");
    Err(GIFTI.at("document", problem))
}
