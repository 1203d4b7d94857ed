//! The JSON of a file. Only what geometry needs can refuse it.

use gltf::json::deserialize::from_slice;
use gltf::json::{Error as JsonError, Index, Root, Value};

use super::draco::DRACO;
use super::format::GLTF;
use super::instancing::INSTANCING;
use super::meshopt::MESHOPT;
use super::pointer;
use crate::error::{Error, Result};
use crate::io::text::without_mark;

/// Extensions of geometry that are read.
const READ: [&str; 5] = [DRACO, MESHOPT[0], MESHOPT[1], "KHR_mesh_quantization", INSTANCING];

/// Extensions found on geometry that add to it and take nothing away.
const HARMLESS: [&str; 6] = [
    "CESIUM_primitive_outline",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "FB_ngon_encoding",
    "KHR_xmp_json_ld",
];

/// Parses the JSON and checks that its version and the extensions of its geometry are known.
pub fn parse(json: &[u8]) -> Result<Root> {
    let json = without_padding(json);
    // The second way takes several times as long and as much memory.
    let root = from_slice(json).or_else(|error| forgiving(json, &error))?;
    check_version(&root.asset.version)?;
    check_extensions(&root)?;
    Ok(root)
}

/// Without a byte order mark, and without the zeros that some programs fill the chunk of a GLB file with.
fn without_padding(json: &[u8]) -> &[u8] {
    let end = json.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    without_mark(&json[..end])
}

/// What geometry needs, and of the rest what can be understood.
fn forgiving(json: &[u8], refused: &JsonError) -> Result<Root> {
    let mut document: Value = from_slice(json).map_err(|error| unreadable(&error))?;
    // glTF 1.0 has objects where later versions have arrays.
    let version = document.pointer("/asset/version").and_then(Value::as_str);
    let has_objects = document.get("meshes").is_some_and(Value::is_object);
    check_version(version.unwrap_or(if has_objects { "1.0" } else { "2.0" }))?;
    if !document.is_object() {
        return Err(GLTF.at("JSON", format!("{refused}; export it again")));
    }
    tidy(&mut document);
    pointer::resolve(&mut document);
    // A scene may be empty.
    let scenes = document.get_mut("scenes").and_then(Value::as_array_mut).into_iter().flatten();
    for scene in scenes.filter_map(Value::as_object_mut) {
        scene.entry("nodes").or_insert_with(|| Value::Array(Vec::new()));
    }
    let document = &document;
    Ok(Root {
        accessors: needed(document, "accessors", |text| from_slice(text))?,
        buffers: needed(document, "buffers", |text| from_slice(text))?,
        buffer_views: needed(document, "bufferViews", |text| from_slice(text))?,
        meshes: needed(document, "meshes", |text| from_slice(text))?,
        nodes: needed(document, "nodes", |text| from_slice(text))?,
        scenes: needed(document, "scenes", |text| from_slice(text))?,
        skins: needed(document, "skins", |text| from_slice(text))?,
        scene: document.get("scene").and_then(|scene| u32::try_from(scene.as_u64()?).ok()).map(Index::new),
        animations: optional(document, "animations", |text| from_slice(text)),
        extensions: document.get("extensions").and_then(|all| serde_json::from_value(all.clone()).ok()),
        cameras: optional(document, "cameras", |text| from_slice(text)),
        images: optional(document, "images", |text| from_slice(text)),
        materials: optional(document, "materials", |text| from_slice(text)),
        samplers: optional(document, "samplers", |text| from_slice(text)),
        textures: optional(document, "textures", |text| from_slice(text)),
        extensions_used: texts(document, "extensionsUsed"),
        extensions_required: texts(document, "extensionsRequired"),
        ..Root::default()
    })
}

/// What is wrong with text that is not JSON.
fn unreadable(error: &JsonError) -> Error {
    let place = format!("JSON line {} column {}", error.line(), error.column());
    if error.is_eof() {
        return GLTF.at(place, "the text is cut short here; copy or export it again");
    }
    let words = error.to_string();
    // Told by no category of its own.
    if words.starts_with("recursion limit exceeded") {
        return GLTF.at(place, "lists and objects within each other are more than 127 deep here; export it with fewer");
    }
    GLTF.at(place, format!("{words}; export it again"))
}

/// Parses one element. From text, so that the code that parses whole files serves here too.
type Parse<T> = fn(&[u8]) -> std::result::Result<T, JsonError>;

/// The elements of a top-level array, in which each must parse.
fn needed<T>(document: &Value, key: &str, parse: Parse<T>) -> Result<Vec<T>> {
    let parse = |(index, element): (usize, &Value)| {
        parse(element.to_string().as_bytes()).map_err(|error| {
            let error = error.to_string();
            let problem = error.split(" at line").next().unwrap_or_default();
            GLTF.at(format!("{key}[{index}]"), format!("{problem}; export the file again"))
        })
    };
    array(document, key).enumerate().map(parse).collect()
}

/// The elements of a top-level array, those that do not parse replaced by ones without properties: others have indices.
fn optional<T>(document: &Value, key: &str, parse: Parse<T>) -> Vec<T> {
    array(document, key)
        .filter_map(|element| parse(element.to_string().as_bytes()).or_else(|_| parse(b"{}")).ok())
        .collect()
}

fn texts(document: &Value, key: &str) -> Vec<String> {
    array(document, key).filter_map(Value::as_str).map(str::to_owned).collect()
}

fn array<'a>(document: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    document.get(key).and_then(Value::as_array).into_iter().flatten()
}

/// Removes names and extensions of the wrong type, and writes whole numbers without a fraction: 3.0 is an integer too.
fn tidy(value: &mut Value) {
    match value {
        Value::Object(object) => {
            object.retain(|key, value| match key.as_str() {
                "name" => value.is_string(),
                "extensions" => value.is_object(),
                _ => true,
            });
            object.values_mut().for_each(tidy);
        }
        Value::Array(elements) => elements.iter_mut().for_each(tidy),
        Value::Number(number) => {
            if let Some(whole) = number.as_f64().filter(|number| number.fract() == 0.0 && (0.0..1e15).contains(number))
            {
                *value = Value::from(whole as u64);
            }
        }
        _ => {}
    }
}

fn check_version(version: &str) -> Result<()> {
    if version.starts_with("1.") {
        return Err(Error::Unsupported {
            format: "glTF",
            feature: format!("version {version}"),
            remedy: "export the file as glTF 2.0".to_owned(),
        });
    }
    Ok(())
}

/// An extension that the file requires refuses it only where it says how geometry is to be read.
fn check_extensions(root: &Root) -> Result<()> {
    let appearance = |name: &str| ["_materials_", "_texture_"].iter().any(|part| name.contains(part));
    let unknown = |name: &str| !READ.contains(&name) && !HARMLESS.contains(&name) && !appearance(name);
    let required = root.extensions_required.iter().find(|name| unknown(name) && on_geometry(root, name));
    required.map_or(Ok(()), |name| {
        Err(Error::Unsupported {
            format: "glTF",
            feature: name.clone(),
            remedy: "export the file without this extension".to_owned(),
        })
    })
}

/// Whether the extension changes bytes or meshes. What else it can be on is a node: a light, a sound, a physical body.
fn on_geometry(root: &Root, name: &str) -> bool {
    macro_rules! on {
        ($elements:expr) => {
            $elements.any(|element| element.extensions.as_ref().is_some_and(|all| all.others.contains_key(name)))
        };
    }
    on!(root.buffers.iter())
        || on!(root.buffer_views.iter())
        || on!(root.accessors.iter())
        || on!(root.meshes.iter())
        || on!(root.meshes.iter().flat_map(|mesh| &mesh.primitives))
}
