//! Polygon File Format (Turk 1994), ASCII and binary of either byte order, with any elements and properties.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use heatwalk_surface::{Attribute, Soup, Unit, UnitRule, WarningCode, Warnings};

use super::budget::Budget;
use super::color::light;
use super::format::Format;
use super::reader::Reporter;
use super::scalar::{Scalar, whole};
use super::text;
use super::triangulate::Polygons;
use crate::appearance::Appearance;
use crate::error::{Error, Result};
use crate::model::Model;

const PLY: Reporter = Reporter("PLY");

enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

struct Property {
    name: String,
    kind: Kind,
}

struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
}

/// Where the values come from: the whole of it, and what is left.
enum Body<'a> {
    Ascii { all: &'a str, rest: &'a str },
    Binary { all: &'a [u8], rest: &'a [u8], is_little: bool },
}

impl Body<'_> {
    /// The next value.
    ///
    /// # Errors
    /// What is there instead.
    fn next(&mut self, scalar: Scalar) -> std::result::Result<f64, String> {
        match self {
            Self::Ascii { rest, .. } => {
                let word = text::word(rest);
                word.and_then(text::number).ok_or_else(|| text::why_no_number(word))
            }
            Self::Binary { rest, is_little, .. } => {
                let (own, left) = rest.split_at_checked(scalar.size()).ok_or("the file ends before it")?;
                *rest = left;
                Ok(scalar.number(own, *is_little))
            }
        }
    }

    /// Where something is left, other than white space, behind a header.
    fn left(&self, header: &[u8]) -> Option<String> {
        match *self {
            Self::Ascii { all, rest } => {
                let left = rest.trim_ascii_start();
                let lines = text::line_number(&all.as_bytes()[..all.len() - left.len()]) - 1;
                (!left.is_empty()).then(|| format!("line {}", text::line_number(header) + lines))
            }
            Self::Binary { all, rest, .. } => {
                let place = header.len() + all.len() - rest.len();
                (!rest.trim_ascii().is_empty()).then(|| format!("byte {place}"))
            }
        }
    }
}

pub const FORMAT: Format = Format {
    extensions: &["ply"],
    is: |bytes| bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r"),
    read: |budget, name, bytes, _| read(budget, name, bytes),
    upward: None,
};

fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Model> {
    let Header { elements, encoding, unit, body: values } = header(bytes)?;
    let text;
    let mut body = match encoding {
        Encoding::Ascii => {
            text = String::from_utf8_lossy(values);
            Body::Ascii { all: &text, rest: &text }
        }
        Encoding::Binary { is_little } => Body::Binary { all: values, rest: values, is_little },
    };
    let mut positions: Vec<DVec3> = Vec::new();
    let mut colors: Vec<[u16; 4]> = Vec::new();
    let mut normals: Vec<Vec3> = Vec::new();
    let mut attributes: Vec<Attribute> = Vec::new();
    let mut polygons = Polygons::new(budget);
    let mut warnings = Warnings::default();
    let mut list = Vec::new();
    for element in &elements {
        let role = Role::of(element)?;
        if let Role::Vertex { .. } = role {
            // Three coordinates take at least three bytes, so a count beyond that is a lie and must not be reserved.
            budget.reserve(&mut positions, (bytes.len() / 3).min(element.count as usize))?;
            attributes = attributes_of(element);
        }
        if element.name == "edge" {
            warnings.add_many(WarningCode::LinesLeftOut, element.count as usize, || "element edge".to_owned());
        }
        // Elements without properties take no bytes; a count of them could keep the loop below busy for ever.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for index in 0..count {
            let place = || format!("{} {index}", element.name);
            let mut position = [0.0; 3];
            let mut color = [0; 4];
            let mut normal = [0.0; 3];
            let mut further = attributes.iter_mut();
            for (column, property) in element.properties.iter().enumerate() {
                let broken = |found: String| {
                    let name = &property.name;
                    PLY.at(
                        place(),
                        format!(
                            "{name} should be a number, but {found}; the file is damaged or cut short, save it again"
                        ),
                    )
                };
                match property.kind {
                    Kind::Scalar(scalar) => {
                        let value = body.next(scalar).map_err(broken)?;
                        if let Role::Vertex { axes, upright, channels } = role {
                            if let Some(axis) = axes.iter().position(|&axis| axis == column) {
                                position[axis] = value;
                            } else if let Some(upright) = upright
                                && let Some(axis) = upright.iter().position(|&axis| axis == column)
                            {
                                normal[axis] = value as f32;
                            } else if let Some(channels) = channels
                                && let Some(channel) = channels.iter().position(|&channel| channel == Some(column))
                            {
                                color[channel] = channel_value(value, scalar, channel);
                            } else if !KNOWN.contains(&property.name.as_str())
                                && let Some(attribute) = further.next()
                            {
                                budget.push(&mut attribute.values, value)?;
                            }
                        }
                    }
                    Kind::List { count, item } => {
                        let length = body.next(count).map_err(broken)?;
                        let length = whole(length).ok_or_else(|| broken(format!("its length is {length}")))?;
                        list.clear();
                        for _ in 0..length {
                            budget.push(&mut list, body.next(item).map_err(broken)?)?;
                        }
                        let wrong = |value: f64| {
                            PLY.at(
                                place(),
                                format!("vertex {value} is no index, which is whole and not negative; repair the file"),
                            )
                        };
                        match role {
                            Role::Face(at) if at == column => face(&list, &mut polygons, wrong)?,
                            Role::Strips(at) if at == column => strips(&list, &mut polygons, wrong)?,
                            _ => {}
                        }
                    }
                }
            }
            if let Role::Vertex { upright, channels, .. } = role {
                budget.push(&mut positions, position.into())?;
                if upright.is_some() {
                    budget.push(&mut normals, Vec3::from(normal).normalize_or_zero())?;
                }
                if let Some([.., alpha]) = channels {
                    color[ALPHA] = if alpha.is_some() { color[ALPHA] } else { u16::MAX };
                    budget.push(&mut colors, color)?;
                }
            }
        }
    }
    if let Some(place) = body.left(&bytes[..bytes.len() - values.len()]) {
        warnings.add(WarningCode::Trailing, || place);
    }
    let place = |polygon: usize| format!("face {polygon}");
    polygons
        .check(positions.len())
        .map_err(|missing| PLY.no_vertex(place(missing.polygon), missing.vertex, positions.len(), 0))?;
    let (triangles, polygons) = polygons.triangulate_all(&positions, &mut warnings, place)?;
    let soup =
        Soup { polygons, attributes, unit, warnings: warnings.into_vec(), ..Soup::single(name, positions, triangles) };
    let colors = if colors.len() == soup.positions.len() { colors } else { Vec::new() };
    // Faces tell how they are seen; of points alone nothing else tells which side is outside.
    let normals = if soup.triangles.is_empty() { normals } else { Vec::new() };
    Ok(Model { appearance: Arc::new(Appearance { colors, normals, ..Appearance::default() }), ..soup.into() })
}

const ALPHA: usize = 3;

/// Scalar properties of vertices that are shape or look.
const KNOWN: [&str; 14] = ["x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "s", "t", "u", "v"];

/// The further properties of vertices, in order, without values yet.
fn attributes_of(vertices: &Element) -> Vec<Attribute> {
    let is_further =
        |property: &&Property| matches!(property.kind, Kind::Scalar(_)) && !KNOWN.contains(&property.name.as_str());
    let further = vertices.properties.iter().filter(is_further);
    further.map(|property| Attribute { name: property.name.clone(), values: Vec::new() }).collect()
}

/// A channel of a color as linear light, 65535 for 1. Whole numbers reach up to the largest of their type, others up to 1;
/// red, green and blue are as displays take them.
fn channel_value(value: f64, scalar: Scalar, channel: usize) -> u16 {
    let most = match scalar {
        Scalar::I8 | Scalar::U8 => f64::from(u8::MAX),
        Scalar::I16 | Scalar::U16 => f64::from(u16::MAX),
        Scalar::I32 | Scalar::U32 => f64::from(u32::MAX),
        Scalar::I64 | Scalar::U64 => u64::MAX as f64,
        Scalar::F32 | Scalar::F64 => 1.0,
    };
    let share = (value / most).clamp(0.0, 1.0);
    let linear = if channel == ALPHA { share } else { light(share) };
    (linear * f64::from(u16::MAX)).round() as u16
}

/// What an element means to a mesh, with the columns that matter.
#[derive(Clone, Copy)]
enum Role {
    /// Columns of x, y and z, those of normals where there are any, and of red, green, blue and alpha where there are colors.
    Vertex {
        axes: [usize; 3],
        upright: Option<[usize; 3]>,
        channels: Option<[Option<usize>; 4]>,
    },
    Face(usize),
    Strips(usize),
    Other,
}

impl Role {
    fn of(element: &Element) -> Result<Self> {
        let scalar = |name: &str| {
            let column = element.properties.iter().position(|property| property.name == name);
            column.filter(|&column| matches!(element.properties[column].kind, Kind::Scalar(_)))
        };
        let indices = || {
            element.properties.iter().position(|property| {
                matches!(property.name.as_str(), "vertex_indices" | "vertex_index")
                    && matches!(property.kind, Kind::List { .. })
            })
        };
        let missing = |what: &str| {
            PLY.at(format!("element {}", element.name), format!("it has no {what}; export the mesh with them"))
        };
        match element.name.as_str() {
            "vertex" => match (scalar("x"), scalar("y"), scalar("z")) {
                (Some(x), Some(y), Some(z)) => {
                    let channels = ["red", "green", "blue", "alpha"].map(scalar);
                    let has_color = channels[..ALPHA].iter().all(Option::is_some);
                    let upright = match ["nx", "ny", "nz"].map(scalar) {
                        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
                        _ => None,
                    };
                    Ok(Self::Vertex { axes: [x, y, z], upright, channels: has_color.then_some(channels) })
                }
                _ => Err(missing("x, y and z")),
            },
            "face" | "tristrips" if element.count > 0 => {
                let column = indices().ok_or_else(|| missing("list of vertex indices"))?;
                Ok(if element.name == "face" { Self::Face(column) } else { Self::Strips(column) })
            }
            _ => Ok(Self::Other),
        }
    }
}

/// Adds a polygon. `wrong`: the error of what is no index.
fn face(list: &[f64], polygons: &mut Polygons, wrong: impl Fn(f64) -> Error) -> Result<()> {
    for &value in list {
        polygons.corner(whole(value).ok_or_else(|| wrong(value))?)?;
    }
    polygons.close()
}

/// Adds the triangles of strips that are separated by −1, every second one turned.
fn strips(list: &[f64], polygons: &mut Polygons, wrong: impl Fn(f64) -> Error) -> Result<()> {
    for strip in list.split(|&value| value == -1.0) {
        for (index, corners) in strip.windows(3).enumerate() {
            let [a, b, c] = [corners[0], corners[1], corners[2]];
            face(&if index % 2 == 0 { [a, b, c] } else { [b, a, c] }, polygons, &wrong)?;
        }
    }
    Ok(())
}

#[derive(Clone, Copy)]
enum Encoding {
    Ascii,
    Binary { is_little: bool },
}

struct Header<'a> {
    elements: Vec<Element>,
    encoding: Encoding,
    /// By a comment `lengths in mm`, as files of Heatwalk have it; the format itself says nothing of units.
    unit: Option<Unit>,
    /// The bytes after it.
    body: &'a [u8],
}

fn header(bytes: &[u8]) -> Result<Header<'_>> {
    let unfinished = || PLY.at("header", "there is no end_header; the file is cut short, save it again");
    let mut elements: Vec<Element> = Vec::new();
    let (mut encoding, mut unit) = (None, None);
    let mut rest = bytes;
    let mut number = 0;
    let mut is_lone = false;
    loop {
        number += 1;
        let (mut length, text) = text::line_length(rest);
        if length == text {
            return Err(unfinished());
        }
        // After the lone CR of the last line, an LF is data already: the line before tells.
        if is_lone {
            length = text + 1;
        }
        is_lone = rest[text] == b'\r' && length == text + 1;
        let line = String::from_utf8_lossy(&rest[..text]);
        rest = &rest[length..];
        let wrong = |problem: &str| PLY.line(number, format!("{problem}: {}", text::quoted(line.trim())));
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["comment", "lengths", "in", symbol] => {
                if let Ok(UnitRule::Is(stated)) = symbol.parse() {
                    unit = stated;
                }
            }
            ["ply"] | [] | ["comment" | "obj_info", ..] => {}
            ["format", name, ..] => {
                encoding = Some(match name {
                    "ascii" => Encoding::Ascii,
                    "binary_little_endian" => Encoding::Binary { is_little: true },
                    "binary_big_endian" => Encoding::Binary { is_little: false },
                    _ => return Err(wrong("unknown encoding; save as ascii or binary_little_endian")),
                });
            }
            ["element", name, count] => {
                let count = count.parse().map_err(|_| wrong("the count is not a whole number"))?;
                if name == "vertex" && elements.iter().any(|element| element.name == name) {
                    return Err(wrong(
                        "there are vertices twice, and faces count in one list of them; merge both lists",
                    ));
                }
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
            }
            ["property", ref kind @ .., name] => {
                let kind = match *kind {
                    ["list", count, item] => Scalar::parse(count)
                        .zip(Scalar::parse(item))
                        .filter(|&(count, _)| !matches!(count, Scalar::F32 | Scalar::F64))
                        .map(|(count, item)| Kind::List { count, item }),
                    [scalar] => Scalar::parse(scalar).map(Kind::Scalar),
                    _ => None,
                };
                let kind = kind.ok_or_else(|| wrong("unknown property type"))?;
                let element = elements.last_mut().ok_or_else(|| wrong("a property before any element"))?;
                element.properties.push(Property { name: name.to_owned(), kind });
            }
            ["end_header"] => break,
            _ => return Err(wrong("not a header line; the file is damaged")),
        }
    }
    let encoding = encoding.ok_or_else(|| PLY.at("header", "there is no format line; save the file again"))?;
    Ok(Header { elements, encoding, unit, body: rest })
}
