//! Wavefront OBJ (Wavefront Technologies, Advanced Visualizer manual, appendix B1): vertices, polygons, objects, groups and
//! materials, texture coordinates, normals, and colors of vertices. A material library that is missing or damaged takes nothing
//! from the surface.

mod library;
mod material;
mod texture;

use std::collections::HashMap;
use std::iter::Peekable;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use heatwalk_surface::{Part, Soup, WarningCode, Warnings};

use super::budget::Budget;
use super::color::light;
use super::format::Format;
use super::reader::{Reporter, Resources, numbers};
use super::seams::seams;
use super::text;
use super::triangulate::Polygons;
use crate::appearance::{Appearance, Run};
use crate::error::Result;
use crate::model::Model;
use library::Library;

const OBJ: Reporter = Reporter("OBJ");

/// Statements that say nothing of a surface of polygons, or are said by curves and surfaces of free form, which are told of.
const NEEDLESS: [&str; 30] = [
    "",
    "s",
    "mg",
    "vp",
    "deg",
    "bmat",
    "step",
    "cstype",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "usemap",
    "maplib",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "call",
    "csh",
    "bsp",
    "bzp",
    "res",
];

/// In place of an index: there is none.
const NONE: u32 = u32::MAX;

/// Parts by object and group; a name met again continues its part.
struct Groups {
    names: Vec<String>,
    by_key: HashMap<(String, String), usize>,
    object: String,
    current: usize,
}

impl Groups {
    fn new(file: &str) -> Self {
        let by_key = HashMap::from([((String::new(), String::new()), 0)]);
        Self { names: vec![file.to_owned()], by_key, object: String::new(), current: 0 }
    }

    fn open(&mut self, object: &str, group: &str) {
        self.object = object.to_owned();
        let name = if group.is_empty() { object } else { group };
        let next = self.names.len();
        self.current = *self.by_key.entry((object.to_owned(), group.to_owned())).or_insert(next);
        if self.current == next {
            self.names.push(name.to_owned());
        }
    }
}

/// What the file holds, polygons in its order.
struct File<'a> {
    budget: &'a Budget,
    positions: Vec<DVec3>,
    /// Red, green and blue as displays take them; of as many vertices as there are up to the last that has one.
    colors: Vec<[f32; 3]>,
    /// u and v, (0, 0) at an image's upper left corner.
    texcoords: Vec<[f32; 2]>,
    normals: Vec<Vec3>,
    polygons: Polygons<'a>,
    /// Of each corner of the polygons up to the last that has any, its texture coordinate and its normal.
    attributes: Vec<[u32; 2]>,
    part_of_polygon: Vec<usize>,
    material_of_polygon: Vec<Option<usize>>,
    line_of_polygon: Vec<u32>,
    warnings: Warnings,
}

pub const FORMAT: Format = Format { extensions: &["obj"], is: |_| false, read, upward: None };

fn read(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let text = String::from_utf8_lossy(bytes);
    let mut file = File::new(budget);
    let mut groups = Groups::new(name);
    let mut library = Library::new(resources);
    let mut material = None;
    let mut lines = text::lines(&text).peekable();
    let mut joined = String::new();
    while let Some((number, line)) = lines.next() {
        let mut arguments = text::statement(line);
        if let Some(head) = line.strip_suffix('\\') {
            if !join(head, &mut lines, &mut joined) {
                file.warnings.add(WarningCode::UnjoinedLines, || format!("line {number}"));
            }
            arguments = text::statement(&joined);
        }
        let keyword = text::word(&mut arguments).unwrap_or_default();
        let place = || format!("line {number}");
        match keyword {
            "v" => file.vertex(arguments, number)?,
            "vt" => {
                let [u, v] = numbers(arguments);
                budget.push(&mut file.texcoords, [u, 1.0 - v])?;
            }
            "vn" => budget.push(&mut file.normals, Vec3::from(numbers(arguments)).normalize_or_zero())?,
            "f" => {
                file.polygon(arguments, number)?;
                budget.push(&mut file.part_of_polygon, groups.current)?;
                budget.push(&mut file.material_of_polygon, material)?;
                budget.push(&mut file.line_of_polygon, number as u32)?;
            }
            "o" => groups.open(arguments.trim(), ""),
            "g" => {
                let object = std::mem::take(&mut groups.object);
                // Each group has the name of its object.
                budget.take(object.len() as u64)?;
                groups.open(&object, arguments.trim());
            }
            "mtllib" => library.open(arguments.trim()),
            "usemtl" => material = Some(library.use_material(arguments.trim())),
            "p" | "l" => file.warnings.add(WarningCode::LinesLeftOut, place),
            "curv" | "curv2" | "surf" => file.warnings.add(WarningCode::CurvesLeftOut, place),
            keyword if NEEDLESS.contains(&keyword) => {}
            _ => file.warnings.add(WarningCode::UnknownStatements, place),
        }
    }
    file.assemble(groups.names, library)
}

/// Joins a line, of which `head` is without its backslash, with the next ones up to the first without; `false` where one of these
/// begins a statement of its own: names and comments may end in a backslash as paths of folders do.
fn join<'a>(head: &str, lines: &mut Peekable<impl Iterator<Item = (usize, &'a str)>>, joined: &mut String) -> bool {
    joined.clear();
    joined.push_str(head);
    while let Some((_, line)) = lines.next_if(|&(_, line)| !begins_statement(line)) {
        joined.push(' ');
        match line.strip_suffix('\\') {
            Some(head) => joined.push_str(head),
            None => {
                joined.push_str(line);
                return true;
            }
        }
    }
    lines.peek().is_none()
}

/// Whether a line begins with a word: lists go on with numbers.
fn begins_statement(mut line: &str) -> bool {
    text::word(&mut line)
        .is_some_and(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()) && text::number(word).is_none())
}

impl<'a> File<'a> {
    fn new(budget: &'a Budget) -> Self {
        Self {
            budget,
            positions: Vec::new(),
            colors: Vec::new(),
            texcoords: Vec::new(),
            normals: Vec::new(),
            polygons: Polygons::new(budget),
            attributes: Vec::new(),
            part_of_polygon: Vec::new(),
            material_of_polygon: Vec::new(),
            line_of_polygon: Vec::new(),
            warnings: Warnings::default(),
        }
    }

    fn vertex(&mut self, arguments: &str, line: usize) -> Result<()> {
        let mut rest = arguments;
        self.budget.push(&mut self.positions, OBJ.position(|| text::word(&mut rest), line)?)?;
        // A single number is the weight of a rational curve's control point.
        if rest.split_ascii_whitespace().nth(2).is_some() {
            self.budget.resize(&mut self.colors, self.positions.len() - 1, [1.0; 3])?;
            self.budget.push(&mut self.colors, numbers(rest))?;
        }
        Ok(())
    }

    fn polygon(&mut self, arguments: &str, line: usize) -> Result<()> {
        for word in arguments.split_ascii_whitespace() {
            let mut indices = word.split('/');
            self.polygons.corner(vertex(indices.next().unwrap_or_default(), line, self.positions.len())?)?;
            let texcoord = attribute(indices.next(), self.texcoords.len());
            let attributes = [texcoord, attribute(indices.next(), self.normals.len())];
            if attributes != [NONE; 2] {
                self.budget.resize(&mut self.attributes, self.polygons.corner_count() - 1, [NONE; 2])?;
                self.budget.push(&mut self.attributes, attributes)?;
            }
        }
        self.polygons.close()
    }

    /// The triangles in the order of the file, and the parts that have some.
    fn assemble(mut self, names: Vec<String>, library: Library) -> Result<Model> {
        let line = |polygon: usize| format!("line {}", self.line_of_polygon[polygon]);
        let vertices = self.positions.len();
        self.polygons
            .check(vertices)
            .map_err(|missing| OBJ.no_vertex(line(missing.polygon), missing.vertex.saturating_add(1), vertices, 1))?;
        let mut corners = self.budget.list(self.part_of_polygon.len())?;
        let mut runs: Vec<Run> = Vec::new();
        let mut polygons = Vec::new();
        let mut parts: Vec<Part> = names.into_iter().map(Part::new).collect();
        for (polygon, &part) in self.part_of_polygon.iter().enumerate() {
            let start = corners.len();
            if !self.polygons.triangulate_corners(polygon, &self.positions, &mut corners)? {
                self.warnings.add(WarningCode::CrossedPolygons, || line(polygon));
            }
            let own = start..corners.len();
            if own.is_empty() {
                self.warnings.add(WarningCode::LinesLeftOut, || line(polygon));
                continue;
            }
            parts[part].add(own.clone());
            if own.len() > 1 {
                self.budget.push(&mut polygons, own.clone())?;
            }
            let material = self.material_of_polygon[polygon];
            match runs.last_mut().filter(|run| run.material == material) {
                Some(run) => run.triangles.end = own.end,
                None => runs.push(Run { triangles: own, material }),
            }
        }
        parts.retain(|part| !part.is_empty());
        let mut triangles = self.budget.list(corners.len())?;
        triangles.extend(corners.iter().map(|&places| self.polygons.vertices(places)));
        let mut appearance = library.finish(runs);
        self.add_attributes(&triangles, &corners, &mut appearance);
        let warnings = self.warnings.into_vec();
        let soup = Soup { positions: self.positions, triangles, polygons, parts, warnings, ..Soup::default() };
        Ok(Model { appearance: Arc::new(appearance), ..soup.into() })
    }

    /// Adds the attributes of vertices; `corners` are places among those of the polygons.
    fn add_attributes(&self, triangles: &[[u32; 3]], corners: &[[usize; 3]], appearance: &mut Appearance) {
        let is_textured = appearance.materials.iter().any(|material| material.textures.iter().any(Option::is_some));
        let texcoord =
            |&[texcoord, _]: &[u32; 2]| self.texcoords.get(texcoord as usize).filter(|_| is_textured).copied();
        let normal = |&[_, normal]: &[u32; 2]| self.normals.get(normal as usize).copied();
        let vertices = self.positions.len();
        if self.attributes.iter().any(|attributes| texcoord(attributes).is_some() || normal(attributes).is_some()) {
            let corners = corners.as_flattened();
            let attributes = |corner: usize| self.attributes.get(corners[corner]).copied().unwrap_or([NONE; 2]);
            let value = |corner: usize| {
                let attributes = attributes(corner);
                let normal = normal(&attributes).unwrap_or_default().to_array();
                texcoord(&attributes).unwrap_or_default().into_iter().chain(normal).map(f32::to_bits)
            };
            let (seams, rows) = seams(vertices, triangles, &|a, b| value(a).cmp(value(b)));
            let rows = || rows.iter().map(|corner| corner.map_or([NONE; 2], attributes));
            if is_textured {
                let texcoords = rows().map(|row| texcoord(&row).unwrap_or_default());
                appearance.texcoords = texcoords.map(|[u, v]| [u, v, 0.0, 0.0]).collect();
            }
            if !self.normals.is_empty() {
                appearance.normals = rows().map(|row| normal(&row).unwrap_or_default()).collect();
            }
            appearance.seams = seams;
        }
        if !self.colors.is_empty() {
            appearance.colors = self.linear_colors();
            let copies = appearance.seams.vertices.iter().skip(vertices);
            let colors: Vec<_> = copies.map(|&vertex| appearance.colors[vertex as usize]).collect();
            appearance.colors.extend(colors);
        }
    }

    /// Of every vertex; white where it has none. Some programs write numbers up to 255 instead of up to 1.
    fn linear_colors(&self) -> Vec<[u16; 4]> {
        let is_large = self.colors.as_flattened().iter().any(|&channel| channel > 1.0);
        let scale = if is_large { 255.0 } else { 1.0 };
        let wide =
            |channel: f32| (light((f64::from(channel) / scale).clamp(0.0, 1.0)) * f64::from(u16::MAX)).round() as u16;
        let colors = self.colors.iter().map(|color| color.map(wide)).map(|[r, g, b]| [r, g, b, u16::MAX]);
        let mut colors: Vec<_> = colors.collect();
        colors.resize(self.positions.len(), [u16::MAX; 4]);
        colors
    }
}

/// A 0-based vertex; negative counts back from the last vertex so far.
fn vertex(word: &str, line: usize, vertices: usize) -> Result<u64> {
    match word.parse::<i64>() {
        Ok(index) if index > 0 => Ok(index.unsigned_abs() - 1),
        Ok(index) if index < 0 => (vertices as u64)
            .checked_sub(index.unsigned_abs())
            .ok_or_else(|| OBJ.line(line, format!("vertex {index} counts back beyond the {vertices} vertices so far"))),
        _ => Err(OBJ.line(line, format!("{} is not a vertex index; they count from 1", text::quoted(word)))),
    }
}

/// A 0-based texture coordinate or normal, counted as vertices are; [`NONE`] where there is no sound one.
fn attribute(word: Option<&str>, count: usize) -> u32 {
    let index = word.and_then(|word| word.parse::<i64>().ok()).unwrap_or(0);
    let index = if index < 0 { index.saturating_add_unsigned(count as u64) } else { index - 1 };
    u32::try_from(index).unwrap_or(NONE)
}
