//! Distances in a GLB file, with the materials of the file that the triangles came from.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

use crate::appearance::{Alpha, Appearance, Channel, Image, Material, Run, Texels, Texture, Wrap};
use crate::io::write::container::{ARRAY_BUFFER, GlbFile};
use crate::io::write::{largest_finite, share};
use crate::model::Model;

const SHORT: u32 = 5123;
const FLOAT: u32 = 5126;

/// How KTX 2.0 files begin (KTX File Format 2.0, 3.1).
const KTX2: &[u8] = b"\xABKTX 20\xBB\r\n\x1A\n";

/// GLB with `POSITION`, indices and two float attributes: `_REACHABLE` is 1 where the distance is finite and 0 elsewhere,
/// `_DISTANCE` is the distance, and 0 where that is infinite: a GLB file must not hold infinities (glTF 2.0, 3.6.2.2).
/// The first set of texture coordinates that the file has no use for is (distance / largest distance, 0), so that any program
/// can color by distance with a texture; where nothing is reached it is (1, 0).
/// Materials, images and the attributes that these need come along, normals as well. Vertices keep their numbers; further copies
/// of those with several rows of attributes come after them. Textures whose images are yet to be made of others stay behind.
///
/// # Panics
/// If there is not one distance for each vertex.
pub fn distance_glb(model: &Model, distance: &[f64]) -> Vec<u8> {
    assert_eq!(model.soup.positions.len(), distance.len(), "one distance for each vertex");
    let model = &*model.surface_alone();
    let soup = &model.soup;
    let mut file = GlbFile::default();
    let mut attributes = Map::new();
    let mut add = |name: &str, accessor: usize| attributes.insert(name.to_owned(), accessor.into());

    let look = &model.appearance;
    let copies = look.seams.vertices.iter().skip(distance.len()).map(|&vertex| vertex as usize);
    let rows = || (0..distance.len()).chain(copies.clone());
    let positions: Vec<[f32; 3]> = rows().map(|vertex| soup.positions[vertex].as_vec3().to_array()).collect();
    add("POSITION", file.bounded(&positions, "VEC3"));
    let finite = |vertex: usize| [if distance[vertex].is_finite() { distance[vertex] as f32 } else { 0.0 }];
    add("_DISTANCE", file.bounded(&rows().map(finite).collect::<Vec<_>>(), "SCALAR"));
    let reachable: Vec<f32> = rows().map(|vertex| f32::from(u8::from(distance[vertex].is_finite()))).collect();
    add("_REACHABLE", file.accessor(&reachable, FLOAT, "SCALAR", reachable.len(), ARRAY_BUFFER));
    let count = positions.len();
    if !look.normals.is_empty() && look.normals.iter().all(|normal| normal.is_normalized()) {
        let normals: Vec<[f32; 3]> = look.normals.iter().map(|normal| normal.to_array()).collect();
        add("NORMAL", file.accessor(&normals, FLOAT, "VEC3", count, ARRAY_BUFFER));
    }
    let largest = largest_finite(distance);
    let shares: Vec<[f32; 2]> = rows().map(|vertex| [share(distance[vertex], largest), 0.0]).collect();
    let unused = if look.texcoords.is_empty() { "TEXCOORD_0" } else { "TEXCOORD_2" };
    add(unused, file.accessor(&shares, FLOAT, "VEC2", count, ARRAY_BUFFER));
    if !look.texcoords.is_empty() {
        for (set, name) in ["TEXCOORD_0", "TEXCOORD_1"].into_iter().enumerate() {
            let pairs: Vec<[f32; 2]> = look.texcoords.iter().map(|row| [row[2 * set], row[2 * set + 1]]).collect();
            add(name, file.accessor(&pairs, FLOAT, "VEC2", count, ARRAY_BUFFER));
        }
    }
    if !look.colors.is_empty() {
        let colors = file.accessor(&look.colors, SHORT, "VEC4", count, ARRAY_BUFFER);
        file.accessors[colors]["normalized"] = true.into();
        add("COLOR_0", colors);
    }

    let whole = [Run { triangles: 0..soup.triangles.len(), material: None }];
    let runs = if look.runs.is_empty() { &whole[..] } else { &look.runs[..] };
    let triangles = if look.seams.corners.is_empty() { &soup.triangles } else { &look.seams.corners };
    let primitives: Vec<Value> = runs
        .iter()
        .map(|run| {
            let corners = triangles[run.triangles.clone()].as_flattened();
            let indices = file.indices(corners);
            let mut primitive = json!({ "attributes": attributes, "indices": indices });
            if let Some(material) = run.material {
                primitive["material"] = material.into();
            }
            primitive
        })
        .collect();
    let mut root = json!({
        "asset": { "version": "2.0", "generator": "Heatwalk" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": primitives }],
    });
    file.add_materials(&mut root, look);
    file.finish(root)
}

impl GlbFile {
    fn add_materials(&mut self, root: &mut Value, look: &Appearance) {
        if look.materials.is_empty() {
            return;
        }
        let mut uses = Uses { place_of_image: vec![None; look.images.len()], ..Uses::default() };
        let found = look
            .images
            .iter()
            .enumerate()
            .filter(|(_, image)| image.texels == Texels::Encoded && !image.bytes.is_empty());
        let images = found.enumerate().map(|(place, (index, image))| {
            uses.place_of_image[index] = Some(place);
            let (media_type, extension) = format_of(image);
            uses.extension_of_image.push(extension);
            let view = self.view(&image.bytes);
            self.views.push(view);
            json!({ "bufferView": self.views.len() - 1, "mimeType": media_type })
        });
        let images: Vec<Value> = images.collect();
        for (index, image) in look.images.iter().enumerate() {
            // The alpha of a base color that is put together is lost, its color is not.
            if let Texels::Channels([Some((color, 0)), Some(_), Some(_), _]) = image.texels {
                uses.place_of_image[index] = uses.place_of_image[color];
            }
        }
        root["materials"] = look.materials.iter().map(|material| uses.material(material)).collect();
        for (name, list) in [("images", images), ("textures", uses.textures), ("samplers", uses.samplers)] {
            if !list.is_empty() {
                root[name] = list.into();
            }
        }
        if !uses.extensions.is_empty() {
            root["extensionsUsed"] = uses.extensions.into();
        }
        // There is no other image for who does not know these.
        let required: BTreeSet<&str> = uses.extension_of_image.iter().flatten().copied().collect();
        if !required.is_empty() {
            root["extensionsRequired"] = required.into_iter().collect();
        }
    }
}

/// The type of an image, which one in a buffer must have, and the extension by which textures refer to such. The first bytes tell
/// it, or else the file that it is from.
fn format_of(image: &Image) -> (&str, Option<&'static str>) {
    match &image.bytes[..] {
        bytes if bytes.starts_with(KTX2) => ("image/ktx2", Some("KHR_texture_basisu")),
        bytes if bytes.starts_with(b"RIFF") => ("image/webp", Some("EXT_texture_webp")),
        bytes if bytes.starts_with(b"\xFF\xD8") => ("image/jpeg", None),
        _ if image.media_type.is_empty() => ("image/png", None),
        _ => (&image.media_type, None),
    }
}

/// What materials refer to.
#[derive(Default)]
struct Uses {
    /// Those that could not be found are left out.
    place_of_image: Vec<Option<usize>>,
    /// By which textures refer to each that is written; none for what every program reads.
    extension_of_image: Vec<Option<&'static str>>,
    textures: Vec<Value>,
    samplers: Vec<Value>,
    extensions: Vec<String>,
}

impl Uses {
    fn material(&mut self, material: &Material) -> Value {
        let strongest = material.emission.iter().copied().fold(1.0, f32::max);
        let mut value = json!({
            "pbrMetallicRoughness": {
                "baseColorFactor": material.base_color,
                "metallicFactor": material.metalness,
                "roughnessFactor": material.roughness,
            },
            "emissiveFactor": material.emission.map(|color| color / strongest),
            "doubleSided": material.is_double_sided,
        });
        match material.alpha {
            Alpha::Opaque => {}
            Alpha::Mask(cutoff) => (value["alphaMode"], value["alphaCutoff"]) = ("MASK".into(), cutoff.into()),
            Alpha::Blend => value["alphaMode"] = "BLEND".into(),
        }
        let mut texture = |channel: Channel| self.texture(material.textures[channel as usize].as_ref());
        if let Some(texture) = texture(Channel::BaseColor) {
            value["pbrMetallicRoughness"]["baseColorTexture"] = texture;
        }
        if let Some(texture) = texture(Channel::MetallicRoughness) {
            value["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture;
        }
        if let Some(mut texture) = texture(Channel::Normal) {
            texture["scale"] = material.normal_scale.into();
            value["normalTexture"] = texture;
        }
        if let Some(mut texture) = texture(Channel::Occlusion) {
            texture["strength"] = material.occlusion_strength.into();
            value["occlusionTexture"] = texture;
        }
        if let Some(texture) = texture(Channel::Emission) {
            value["emissiveTexture"] = texture;
        }
        if strongest > 1.0 {
            let name = self.extension("KHR_materials_emissive_strength");
            value["extensions"][name] = json!({ "emissiveStrength": strongest });
        }
        if material.is_unlit {
            let name = self.extension("KHR_materials_unlit");
            value["extensions"][name] = json!({});
        }
        for (name, json) in &material.further {
            if let Ok(read) = serde_json::from_str::<Value>(json) {
                value["extensions"][self.extension(name)] = read;
            }
        }
        value
    }

    fn texture(&mut self, texture: Option<&Texture>) -> Option<Value> {
        let texture = texture?;
        let source = self.place_of_image[texture.image]?;
        let wrap = texture.wrap.map(|wrap| match wrap {
            Wrap::Repeat => 10497,
            Wrap::Mirror => 33648,
            Wrap::Clamp => 33071,
        });
        let magnify = if texture.is_sharp { 9728 } else { 9729 };
        let sampler = json!({ "wrapS": wrap[0], "wrapT": wrap[1], "magFilter": magnify, "minFilter": 9987 });
        let sampler = place_of(&mut self.samplers, sampler);
        let mut texture_of_image = json!({ "source": source, "sampler": sampler });
        if let Some(name) = self.extension_of_image[source] {
            self.extension(name);
            texture_of_image = json!({ "sampler": sampler, "extensions": { name: { "source": source } } });
        }
        let index = place_of(&mut self.textures, texture_of_image);
        let mut info = json!({ "index": index, "texCoord": texture.set });
        if texture.transform != Texture::IDENTITY {
            let [[a, b, x], [c, d, y]] = texture.transform;
            let across = a.hypot(c);
            let scale = [across, (a * d - b * c) / across];
            let rotation = (-c).atan2(a);
            let name = self.extension("KHR_texture_transform");
            info["extensions"][name] = json!({ "offset": [x, y], "rotation": rotation, "scale": scale });
        }
        Some(info)
    }

    fn extension<'b>(&mut self, name: &'b str) -> &'b str {
        if !self.extensions.iter().any(|used| used == name) {
            self.extensions.push(name.to_owned());
        }
        name
    }
}

/// The place of a value in a list, at its end where it is new.
fn place_of(list: &mut Vec<Value>, value: Value) -> usize {
    list.iter().position(|known| *known == value).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}
