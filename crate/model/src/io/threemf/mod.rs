//! 3MF (3MF Consortium, Core Specification 1.3), with the parts of the Production Extension and the colors of the Materials and
//! Properties Extension. The archive is opened by rawzip, its XML read by quick-xml.

mod format;
mod model;
mod package;

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DMat4, DVec3};
use heatwalk_surface::Soup;

use super::archive;
use super::budget::Budget;
use super::color::light;
use super::format::Format;
use super::seams::seams;
use crate::appearance::Appearance;
use crate::error::{Error, Result};
use crate::model::Model;
use format::THREEMF;
use model::{ModelPart, Object, Reference, WHITE};
use package::Package;

/// Components that are visited, with or without vertices.
const MOST_REFERENCES: usize = 1 << 20;
/// Components in components: more are a circle.
const MOST_LEVELS: usize = 64;

pub const FORMAT: Format = Format {
    extensions: &["3mf"],
    is: |bytes| bytes.starts_with(archive::MAGIC),
    read: |budget, name, bytes, _| read(budget, name, bytes),
    upward: Some(DVec3::Z),
};

fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Model> {
    let package = Package::open(budget, bytes)?;
    let root = package.root()?;
    let mut models = HashMap::new();
    load(&package, &root, &mut models)?;
    let mut assembly = Assembly { budget, file: name, models, soup: Soup::default(), colors: Vec::new(), visited: 0 };
    assembly.soup.unit = assembly.models.get(&root).map(|model| model.unit);
    let has_mesh =
        assembly.models.values().flat_map(|model| model.objects.values()).any(|object| !object.triangles.is_empty());
    assembly.build(&root)?;
    if assembly.soup.triangles.is_empty() && has_mesh {
        let reason = format!(
            "no build item of {name} shows a mesh that it holds, or as support alone; save the model with its build"
        );
        return Err(Error::empty(reason));
    }
    Ok(assembly.finish())
}

/// Reads a model part and those that it names.
fn load(package: &Package, root: &str, models: &mut HashMap<String, ModelPart>) -> Result<()> {
    let mut wanted = vec![root.to_owned()];
    while let Some(path) = wanted.pop() {
        if models.contains_key(&path) {
            continue;
        }
        let model = ModelPart::parse(package.budget, &path, &package.text(&path)?)?;
        let components = model.objects.values().flat_map(|object| &object.components);
        wanted.extend(components.chain(&model.build).filter_map(|reference| reference.path.clone()));
        models.insert(path, model);
    }
    Ok(())
}

/// The soup as it grows.
struct Assembly<'a> {
    budget: &'a Budget,
    file: &'a str,
    models: HashMap<String, ModelPart>,
    soup: Soup,
    /// Of the corners of as many triangles as there are up to the last that has any.
    colors: Vec<[u32; 3]>,
    visited: usize,
}

/// An object that is to be placed.
struct Placing<'m> {
    path: &'m str,
    reference: &'m Reference,
    world_from_parent: DMat4,
    /// Of the nearest object around it that has one.
    name: &'m str,
    level: usize,
}

impl Assembly<'_> {
    /// Places what is to be built; an explicit stack, since files can be deep.
    fn build(&mut self, root: &str) -> Result<()> {
        let models = std::mem::take(&mut self.models);
        let Some((root, model)) = models.get_key_value(root) else { return Ok(()) };
        let start =
            |reference| Placing { path: root, reference, world_from_parent: DMat4::IDENTITY, name: "", level: 0 };
        let mut stack: Vec<Placing> = model.build.iter().rev().map(start).collect();
        while let Some(Placing { path, reference, world_from_parent, name, level }) = stack.pop() {
            self.visited += 1;
            if level == MOST_LEVELS || self.visited > MOST_REFERENCES {
                return Err(THREEMF.at(
                    format!("object {}", reference.object),
                    "its components are nested in a circle or without end; save the model again",
                ));
            }
            let path = reference.path.as_deref().unwrap_or(path);
            let object = models.get(path).and_then(|model| model.objects.get(&reference.object));
            let object = object.ok_or_else(|| {
                THREEMF.at(format!("object {}", reference.object), "it is used and not defined; save the model again")
            })?;
            if object.is_support {
                continue;
            }
            let world_from_object = world_from_parent * reference.transform;
            let name = if object.name.is_empty() { name } else { &object.name };
            self.add_mesh(object, name, world_from_object)?;
            let inside =
                |reference| Placing { path, reference, world_from_parent: world_from_object, name, level: level + 1 };
            self.budget.take_items::<Placing>(object.components.len())?;
            stack.extend(object.components.iter().rev().map(inside));
        }
        Ok(())
    }

    fn add_mesh(&mut self, object: &Object, name: &str, world_from_object: DMat4) -> Result<()> {
        let Self { budget, file, soup, colors, .. } = self;
        let name = if name.is_empty() { file } else { name };
        let (first, count) = (soup.positions.len(), object.positions.len());
        budget.take_part(name)?;
        budget.reserve(&mut soup.positions, count)?;
        budget.reserve(&mut soup.triangles, object.triangles.len())?;
        soup.positions.extend(object.positions.iter().map(|&position| world_from_object.transform_point3(position)));
        // A mirroring transform turns every triangle inside out.
        let is_mirrored = world_from_object.determinant() < 0.0;
        let turned = |mut corners: [u32; 3]| {
            if is_mirrored {
                corners.swap(1, 2);
            }
            corners
        };
        if !object.colors.is_empty() {
            budget.resize(colors, soup.triangles.len(), [WHITE; 3])?;
            budget.reserve(colors, object.colors.len())?;
            colors.extend(object.colors.iter().map(|&colors| turned(colors)));
        }
        for (triangle, &corners) in object.triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= count) {
                let place = format!("triangle {triangle} of the object {name:?}");
                return Err(THREEMF.no_vertex(place, vertex.into(), count, 0));
            }
            soup.triangles.push(turned(corners).map(|vertex| first as u32 + vertex));
        }
        soup.end_part(name);
        Ok(())
    }

    fn finish(self) -> Model {
        let Self { soup, mut colors, .. } = self;
        let mut appearance = Appearance::default();
        if colors.iter().flatten().any(|&color| color != WHITE) {
            colors.resize(soup.triangles.len(), [WHITE; 3]);
            let color = colors.as_flattened();
            let (seams, rows) = seams(soup.positions.len(), &soup.triangles, &|a, b| color[a].cmp(&color[b]));
            let colors = rows.into_iter().map(|corner| linear(corner.map_or(WHITE, |corner| color[corner]))).collect();
            appearance = Appearance { colors, seams, ..appearance };
        }
        Model { appearance: Arc::new(appearance), ..soup.into() }
    }
}

/// Linear red, green, blue and alpha, 65535 for 1, of a color in sRGB.
fn linear(color: u32) -> [u16; 4] {
    let [channels @ .., alpha] = color.to_be_bytes().map(|channel| f64::from(channel) / 255.0);
    let [red, green, blue] = channels.map(light);
    [red, green, blue, alpha].map(|share| (share * f64::from(u16::MAX)).round() as u16)
}
