//! Polygon File Format (Turk 1994), ASCII and binary of either byte order, with any elements and properties.

use std::str::SplitAsciiWhitespace;
use std::sync::Arc;

use glam::DVec3;

use super::budget::Budget;
use super::color::light;
use super::reader::Reporter;
use super::triangulate::Polygons;
use crate::appearance::Appearance;
use crate::error::Result;
use crate::soup::{Attribute, Soup};

const PLY: Reporter = Reporter("PLY");

#[derive(Clone, Copy, PartialEq)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn parse(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }
}

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

/// Where the values come from. Every type of the format fits into an f64 without loss.
enum Body<'a> {
    Ascii(SplitAsciiWhitespace<'a>),
    LittleEndian(&'a [u8]),
    BigEndian(&'a [u8]),
}

impl Body<'_> {
    /// The next value; `None` at the end of the file or where the word is not a number.
    fn next(&mut self, scalar: Scalar) -> Option<f64> {
        match self {
            Self::Ascii(words) => words.next()?.parse().ok(),
            Self::LittleEndian(bytes) => Some(match scalar {
                Scalar::I8 => i8::from_le_bytes(take(bytes)?).into(),
                Scalar::U8 => u8::from_le_bytes(take(bytes)?).into(),
                Scalar::I16 => i16::from_le_bytes(take(bytes)?).into(),
                Scalar::U16 => u16::from_le_bytes(take(bytes)?).into(),
                Scalar::I32 => i32::from_le_bytes(take(bytes)?).into(),
                Scalar::U32 => u32::from_le_bytes(take(bytes)?).into(),
                Scalar::F32 => f32::from_le_bytes(take(bytes)?).into(),
                Scalar::F64 => f64::from_le_bytes(take(bytes)?),
            }),
            Self::BigEndian(bytes) => Some(match scalar {
                Scalar::I8 => i8::from_be_bytes(take(bytes)?).into(),
                Scalar::U8 => u8::from_be_bytes(take(bytes)?).into(),
                Scalar::I16 => i16::from_be_bytes(take(bytes)?).into(),
                Scalar::U16 => u16::from_be_bytes(take(bytes)?).into(),
                Scalar::I32 => i32::from_be_bytes(take(bytes)?).into(),
                Scalar::U32 => u32::from_be_bytes(take(bytes)?).into(),
                Scalar::F32 => f32::from_be_bytes(take(bytes)?).into(),
                Scalar::F64 => f64::from_be_bytes(take(bytes)?),
            }),
        }
    }
}

fn take<const N: usize>(bytes: &mut &[u8]) -> Option<[u8; N]> {
    let (value, rest) = bytes.split_first_chunk::<N>()?;
    *bytes = rest;
    Some(*value)
}

pub fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let (elements, encoding, body) = header(bytes)?;
    let text;
    let mut body = match encoding {
        Encoding::Ascii => {
            text = String::from_utf8_lossy(body);
            Body::Ascii(text.split_ascii_whitespace())
        }
        Encoding::LittleEndian => Body::LittleEndian(body),
        Encoding::BigEndian => Body::BigEndian(body),
    };
    let mut positions: Vec<DVec3> = Vec::new();
    let mut colors: Vec<[u16; 4]> = Vec::new();
    let mut attributes: Vec<Attribute> = Vec::new();
    let mut polygons = Polygons::new(budget);
    let mut list = Vec::new();
    for element in &elements {
        let role = Role::of(element)?;
        if let Role::Vertex { .. } = role {
            // Three coordinates take at least three bytes, so a count beyond that is a lie and must not be reserved.
            budget.reserve(&mut positions, (bytes.len() / 3).min(element.count as usize))?;
            attributes = attributes_of(element);
        }
        // Elements without properties take no bytes; a count of them could keep the loop below busy for ever.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for index in 0..count {
            let broken = || {
                PLY.at(
                    format!("{} {index}", element.name),
                    "the value is missing or not a number; the file is damaged or cut short, save it again",
                )
            };
            let mut position = [0.0; 3];
            let mut color = [0; 4];
            let mut further = attributes.iter_mut();
            for (column, property) in element.properties.iter().enumerate() {
                match property.kind {
                    Kind::Scalar(scalar) => {
                        let value = body.next(scalar).ok_or_else(broken)?;
                        if let Role::Vertex { axes, channels } = role {
                            if let Some(axis) = axes.iter().position(|&axis| axis == column) {
                                position[axis] = value;
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
                        let length = body.next(count).and_then(as_index).ok_or_else(broken)?;
                        list.clear();
                        for _ in 0..length {
                            budget.push(&mut list, body.next(item).ok_or_else(broken)?)?;
                        }
                        let valid = match role {
                            Role::Face(at) if at == column => face(&list, &mut polygons)?,
                            Role::Strips(at) if at == column => strips(&list, &mut polygons)?,
                            _ => true,
                        };
                        if !valid {
                            return Err(PLY.at(
                                format!("{} {index}", element.name),
                                "a vertex index is negative or not whole; repair the file",
                            ));
                        }
                    }
                }
            }
            if let Role::Vertex { channels, .. } = role {
                budget.push(&mut positions, position.into())?;
                if let Some([.., alpha]) = channels {
                    color[ALPHA] = if alpha.is_some() { color[ALPHA] } else { u16::MAX };
                    budget.push(&mut colors, color)?;
                }
            }
        }
    }
    let triangles = polygons.triangulate_all(&positions)?;
    let mut soup = Soup::single(name, positions, triangles);
    soup.attributes = attributes;
    if colors.len() == soup.positions.len() {
        soup.appearance = Arc::new(Appearance { colors, ..Appearance::default() });
    }
    Ok(soup)
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
        Scalar::F32 | Scalar::F64 => 1.0,
    };
    let share = (value / most).clamp(0.0, 1.0);
    let linear = if channel == ALPHA { share } else { light(share) };
    (linear * f64::from(u16::MAX)).round() as u16
}

/// What an element means to a mesh, with the columns that matter.
#[derive(Clone, Copy)]
enum Role {
    /// Columns of x, y and z, and of red, green, blue and alpha where there are colors.
    Vertex {
        axes: [usize; 3],
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
                    Ok(Self::Vertex { axes: [x, y, z], channels: has_color.then_some(channels) })
                }
                _ => Err(missing("x, y and z")),
            },
            "face" => indices().map(Self::Face).ok_or_else(|| missing("list of vertex indices")),
            "tristrips" => indices().map(Self::Strips).ok_or_else(|| missing("list of vertex indices")),
            _ => Ok(Self::Other),
        }
    }
}

/// The value as a count or an index, if it is one.
fn as_index(value: f64) -> Option<u64> {
    (value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0).then_some(value as u64)
}

/// Adds a polygon; false where an index is none.
fn face(list: &[f64], polygons: &mut Polygons) -> Result<bool> {
    for &value in list {
        let Some(vertex) = as_index(value) else { return Ok(false) };
        polygons.corner(vertex, 0)?;
    }
    polygons.close()?;
    Ok(true)
}

/// Adds the triangles of strips that are separated by −1, every second one turned; false where an index is none.
fn strips(list: &[f64], polygons: &mut Polygons) -> Result<bool> {
    for strip in list.split(|&value| value == -1.0) {
        for (index, corners) in strip.windows(3).enumerate() {
            let [a, b, c] = [corners[0], corners[1], corners[2]];
            if !face(&if index % 2 == 0 { [a, b, c] } else { [b, a, c] }, polygons)? {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

#[derive(Clone, Copy)]
enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// The elements, the encoding and the bytes after the header.
fn header(bytes: &[u8]) -> Result<(Vec<Element>, Encoding, &[u8])> {
    let unfinished = || PLY.at("header", "there is no end_header; the file is cut short, save it again");
    // The first line tells how lines end: after a lone \r of the last one, a \n would already be data.
    let first_end = bytes.iter().position(|&byte| byte == b'\n' || byte == b'\r').ok_or_else(unfinished)?;
    let line_end: &[u8] = match &bytes[first_end..] {
        [b'\r', b'\n', ..] => b"\r\n",
        [b'\r', ..] => b"\r",
        _ => b"\n",
    };
    let mut elements: Vec<Element> = Vec::new();
    let mut encoding = None;
    let mut rest = bytes;
    let mut number = 0;
    loop {
        number += 1;
        let end = rest.windows(line_end.len()).position(|window| window == line_end).ok_or_else(unfinished)?;
        let line = String::from_utf8_lossy(&rest[..end]);
        rest = &rest[end + line_end.len()..];
        let wrong = |problem: &str| PLY.line(number, format!("{problem}: {:?}", line.trim()));
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["ply"] | [] | ["comment" | "obj_info", ..] => {}
            ["format", name, ..] => {
                encoding = Some(match name {
                    "ascii" => Encoding::Ascii,
                    "binary_little_endian" => Encoding::LittleEndian,
                    "binary_big_endian" => Encoding::BigEndian,
                    _ => return Err(wrong("unknown encoding; save as ascii or binary_little_endian")),
                });
            }
            ["element", name, count] => {
                let count = count.parse().map_err(|_| wrong("the count is not a whole number"))?;
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
    Ok((elements, encoding, rest))
}
