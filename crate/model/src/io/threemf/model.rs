//! A model part: its objects, colors and what is to be built.

use std::collections::HashMap;

use glam::{DMat4, DVec3, DVec4};
use heatwalk_surface::Unit;
use quick_xml::events::BytesStart;

use super::format::THREEMF;
use crate::error::Result;
use crate::io::budget::Budget;
use crate::io::text;
use crate::io::xml::{Document, Node, attributes};

/// Red, green, blue and alpha, a byte each; what has no color is white.
pub const WHITE: u32 = u32::MAX;

#[derive(Default)]
pub struct ModelPart {
    pub unit: Unit,
    pub objects: HashMap<u32, Object>,
    pub build: Vec<Reference>,
    /// Colors of color groups and base materials by the identifier of the group.
    groups: HashMap<u32, Vec<u32>>,
}

/// A mesh, or components of which it is made.
#[derive(Default)]
pub struct Object {
    pub name: String,
    /// Supports and volumes that change others are no part of the surface.
    pub is_support: bool,
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
    /// Of the corners of as many triangles as there are up to the last that has any.
    pub colors: Vec<[u32; 3]>,
    pub components: Vec<Reference>,
    property: Property,
}

/// An object that stands somewhere.
pub struct Reference {
    /// Of the model part that has it, where that is another one.
    pub path: Option<String>,
    pub object: u32,
    pub transform: DMat4,
}

/// A group and an index in it.
#[derive(Clone, Copy, Default)]
struct Property {
    group: Option<u32>,
    index: Option<u32>,
}

impl ModelPart {
    pub fn parse(budget: &Budget, path: &str, text: &str) -> Result<Self> {
        let mut model = Self::default();
        let mut document = Document::new(THREEMF, path, text);
        let mut object: Option<(u32, Object)> = None;
        let mut group = None;
        while let Some(node) = document.next()? {
            let (element, is_empty) = match node {
                Node::Start { element, is_empty } => (element, is_empty),
                Node::End(name) if name == "object" => {
                    model.objects.extend(object.take());
                    continue;
                }
                _ => continue,
            };
            match (element.local_name().as_ref(), &mut object) {
                ("model", _) => model.unit = unit(&element),
                ("object", _) => {
                    budget.take_items::<(u32, Object)>(1)?;
                    let (id, started) = Object::of(&element);
                    match id {
                        Some(id) if is_empty => drop(model.objects.insert(id, started)),
                        Some(id) => object = Some((id, started)),
                        None => return Err(document.broken("an object has no identifier; save the model again")),
                    }
                }
                ("vertex", Some((_, object))) => {
                    let position = position(&element);
                    let position = position
                        .map_err(|found| document.broken(&format!("a vertex needs three numbers, but {found}")))?;
                    budget.push(&mut object.positions, position)?;
                }
                ("triangle", Some((_, object))) => {
                    let triangle = Triangle::of(&element);
                    let [Some(a), Some(b), Some(c)] = triangle.corners else {
                        return Err(document.broken("a triangle needs three vertices"));
                    };
                    budget.push(&mut object.triangles, [a, b, c])?;
                    model.add_color(budget, object, &triangle)?;
                }
                ("component", Some((_, object))) => {
                    budget.reserve(&mut object.components, 1)?;
                    object.components.extend(Reference::of(&element));
                }
                ("item", _) => {
                    budget.reserve(&mut model.build, 1)?;
                    model.build.extend(Reference::of(&element));
                }
                ("colorgroup" | "basematerials", _) => {
                    budget.take_items::<(u32, Vec<u32>)>(1)?;
                    group = attributes(&element).find(|(name, _)| *name == "id").and_then(|(_, id)| id.parse().ok());
                    model.groups.extend(group.map(|group| (group, Vec::new())));
                }
                ("color" | "base", _) => {
                    let given = attributes(&element).find(|(name, _)| matches!(*name, "color" | "displaycolor"));
                    let color = given.and_then(|(_, color)| color_of(&color)).unwrap_or(WHITE);
                    if let Some(colors) = group.and_then(|group| model.groups.get_mut(&group)) {
                        budget.push(colors, color)?;
                    }
                }
                _ => {}
            }
        }
        Ok(model)
    }

    /// Adds the color of the last triangle of an object.
    fn add_color(
        &self,
        budget: &Budget,
        object: &mut Object,
        &Triangle { group, indices, .. }: &Triangle,
    ) -> Result<()> {
        let (group, first) = match indices[0] {
            Some(first) => (group.or(object.property.group), Some(first)),
            None => (object.property.group, object.property.index),
        };
        let Some((colors, first)) = group.and_then(|group| self.groups.get(&group)).zip(first) else { return Ok(()) };
        let color = |index: Option<u32>| colors.get(index.unwrap_or(first) as usize).copied().unwrap_or(WHITE);
        budget.resize(&mut object.colors, object.triangles.len() - 1, [WHITE; 3])?;
        budget.push(&mut object.colors, [Some(first), indices[1], indices[2]].map(color))
    }
}

impl Object {
    fn of(element: &BytesStart) -> (Option<u32>, Self) {
        let mut object = Self::default();
        let mut id = None;
        for (name, value) in attributes(element) {
            match name {
                "id" => id = value.parse().ok(),
                "name" => object.name = value.into_owned(),
                "type" => object.is_support = matches!(&*value, "support" | "solidsupport" | "other"),
                "pid" => object.property.group = value.parse().ok(),
                "pindex" => object.property.index = value.parse().ok(),
                _ => {}
            }
        }
        (id, object)
    }
}

impl Reference {
    /// None where no object is named.
    fn of(element: &BytesStart) -> Option<Self> {
        let (mut path, mut object, mut transform) = (None, None, DMat4::IDENTITY);
        for (name, value) in attributes(element) {
            match name {
                "path" => path = Some(value.into_owned()),
                "objectid" => object = value.parse().ok(),
                "transform" => transform = matrix(&value).unwrap_or(DMat4::IDENTITY),
                _ => {}
            }
        }
        Some(Self { path, object: object?, transform })
    }
}

fn unit(model: &BytesStart) -> Unit {
    let unit = attributes(model).find(|(name, _)| *name == "unit");
    match unit.as_ref().map(|(_, unit)| &**unit) {
        Some("micron") => Unit::Micrometer,
        Some("centimeter") => Unit::Centimeter,
        Some("inch") => Unit::Inch,
        Some("foot") => Unit::Foot,
        Some("meter") => Unit::Meter,
        _ => Unit::Millimeter,
    }
}

/// A position; what is there instead otherwise.
fn position(vertex: &BytesStart) -> std::result::Result<DVec3, String> {
    let mut position = [None; 3];
    for (name, value) in attributes(vertex) {
        if let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) {
            let word = value.trim();
            position[axis] = Some(text::number(word).ok_or_else(|| text::why_no_number(Some(word)))?);
        }
    }
    let [x, y, z] = position.map(|coordinate| coordinate.ok_or_else(|| text::why_no_number(None)));
    Ok(DVec3::new(x?, y?, z?))
}

/// A triangle, with the group and the indices of the colors of its corners.
#[derive(Default)]
struct Triangle {
    corners: [Option<u32>; 3],
    group: Option<u32>,
    indices: [Option<u32>; 3],
}

impl Triangle {
    fn of(element: &BytesStart) -> Self {
        let mut triangle = Self::default();
        for (name, value) in attributes(element) {
            let number = value.trim().parse().ok();
            match name {
                "v1" => triangle.corners[0] = number,
                "v2" => triangle.corners[1] = number,
                "v3" => triangle.corners[2] = number,
                "pid" => triangle.group = number,
                "p1" => triangle.indices[0] = number,
                "p2" => triangle.indices[1] = number,
                "p3" => triangle.indices[2] = number,
                _ => {}
            }
        }
        triangle
    }
}

/// Rows of a 4 × 3 matrix that row vectors are multiplied by (3MF Core 1.3, 3.3).
fn matrix(text: &str) -> Option<DMat4> {
    let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok().filter(|number| number.is_finite()));
    let mut row = |last| Some(DVec4::new(numbers.next()??, numbers.next()??, numbers.next()??, last));
    Some(DMat4::from_cols(row(0.0)?, row(0.0)?, row(0.0)?, row(1.0)?))
}

/// `#RRGGBB` or `#RRGGBBAA`.
fn color_of(text: &str) -> Option<u32> {
    let digits = text.trim().strip_prefix('#')?;
    let number = u32::from_str_radix(digits, 16).ok()?;
    match digits.len() {
        6 => Some(number << 8 | 0xFF),
        8 => Some(number),
        _ => None,
    }
}
