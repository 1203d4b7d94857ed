//! GLB files: views, accessors, meshes, nodes and animations that refer to each other, and to what is not there.

use arbitrary::{Arbitrary, Result, Unstructured};
use serde_json::{Map, Value, json};

use super::{Number, list};

const COMPONENTS: [u64; 7] = [5120, 5121, 5122, 5123, 5125, 5126, 5124];
const KINDS: [&str; 8] = ["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4", "VEC5"];
const ATTRIBUTES: [&str; 8] =
    ["POSITION", "NORMAL", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0", "JOINTS_0", "WEIGHTS_0", "_COST"];
const PATHS: [&str; 5] = ["translation", "rotation", "scale", "weights", "pointer"];
const INTERPOLATIONS: [&str; 3] = ["LINEAR", "STEP", "CUBICSPLINE"];
const MODES: [&str; 4] = ["ATTRIBUTES", "TRIANGLES", "INDICES", "LINES"];
const FILTERS: [&str; 5] = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"];
const EXTENSIONS: [&str; 6] = [
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "EXT_mesh_gpu_instancing",
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_texture_transform",
];

/// The bytes of a file.
#[derive(Debug)]
pub struct GlbFile(pub Vec<u8>);

impl<'a> Arbitrary<'a> for GlbFile {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let views = items(data, view)?;
        let accessors = items(data, accessor)?;
        let meshes = items(data, |data| Ok(json!({ "primitives": items(data, primitive)? })))?;
        let nodes = items(data, node)?;
        let skins = items(data, |data| {
            Ok(json!({ "joints": indices(data)?, "inverseBindMatrices": index(data)?, "skeleton": index(data)? }))
        })?;
        let animations = items(data, animation)?;
        let (scene, scenes) = (index(data)?, [json!({ "nodes": indices(data)? })]);
        let names = &EXTENSIONS[..data.int_in_range(0..=EXTENSIONS.len())?];
        // What is left is the buffer.
        let buffer = data.bytes(data.len())?;
        let length = if buffer.len() % 7 == 6 { Number::arbitrary(data)?.0 } else { buffer.len() as u64 };
        let document = json!({
            "asset": { "version": "2.0" }, "buffers": [{ "byteLength": length }], "bufferViews": views,
            "accessors": accessors, "meshes": meshes, "nodes": nodes, "skins": skins, "animations": animations,
            "scenes": scenes, "scene": scene, "extensionsUsed": names, "extensionsRequired": names,
        });
        Ok(Self(glb(document.to_string().as_bytes(), buffer)))
    }
}

fn glb(document: &[u8], buffer: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8], bytes: &[u8], padding: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), padding);
        [&(bytes.len() as u32).to_le_bytes()[..], kind, &bytes].concat()
    };
    let chunks = [chunk(b"JSON", document, b' '), chunk(b"BIN\0", buffer, 0)].concat();
    let length = (12 + chunks.len()) as u32;
    [b"glTF", &2_u32.to_le_bytes()[..], &length.to_le_bytes(), &chunks].concat()
}

fn items(data: &mut Unstructured, item: impl Fn(&mut Unstructured) -> Result<Value>) -> Result<Vec<Value>> {
    (0..data.int_in_range(0..=super::MOST_ITEMS)?).map(|_| item(data)).collect()
}

fn number(data: &mut Unstructured) -> Result<Value> {
    Ok(Number::arbitrary(data)?.0.into())
}

fn index(data: &mut Unstructured) -> Result<Value> {
    number(data)
}

fn indices(data: &mut Unstructured) -> Result<Value> {
    Ok(list::<Number>(data)?.into_iter().map(|Number(index)| Value::from(index)).collect())
}

/// An object of those members that the data choose.
fn some(data: &mut Unstructured, members: Vec<(&str, Value)>) -> Result<Map<String, Value>> {
    let mut object = Map::new();
    for (name, value) in members {
        if data.ratio(3, 4)? {
            object.insert(name.to_owned(), value);
        }
    }
    Ok(object)
}

fn view(data: &mut Unstructured) -> Result<Value> {
    let members = vec![("byteOffset", number(data)?), ("byteStride", number(data)?)];
    let mut view = some(data, members)?;
    view.insert("buffer".to_owned(), 0.into());
    view.insert("byteLength".to_owned(), number(data)?);
    if data.ratio(1, 4)? {
        let packed = json!({
            "buffer": 0, "byteOffset": number(data)?, "byteLength": number(data)?, "byteStride": number(data)?,
            "count": number(data)?, "mode": data.choose(&MODES)?, "filter": data.choose(&FILTERS)?,
        });
        view.insert("extensions".to_owned(), json!({ "EXT_meshopt_compression": packed }));
    }
    Ok(view.into())
}

fn accessor(data: &mut Unstructured) -> Result<Value> {
    let sparse = json!({
        "count": number(data)?,
        "indices": { "bufferView": index(data)?, "byteOffset": number(data)?, "componentType": data.choose(&COMPONENTS)? },
        "values": { "bufferView": index(data)?, "byteOffset": number(data)? },
    });
    let members = vec![
        ("bufferView", index(data)?),
        ("byteOffset", number(data)?),
        ("normalized", data.arbitrary::<bool>()?.into()),
        ("sparse", sparse),
    ];
    let mut accessor = some(data, members)?;
    accessor.insert("componentType".to_owned(), (*data.choose(&COMPONENTS)?).into());
    accessor.insert("count".to_owned(), number(data)?);
    accessor.insert("type".to_owned(), (*data.choose(&KINDS)?).into());
    Ok(accessor.into())
}

fn attributes(data: &mut Unstructured) -> Result<Value> {
    let mut attributes = Map::new();
    attributes.insert("POSITION".to_owned(), index(data)?);
    for _ in 0..data.int_in_range(0..=3)? {
        attributes.insert((*data.choose(&ATTRIBUTES)?).to_owned(), index(data)?);
    }
    Ok(attributes.into())
}

fn primitive(data: &mut Unstructured) -> Result<Value> {
    let members = vec![
        ("indices", index(data)?),
        ("mode", data.int_in_range(0..=7)?.into()),
        ("targets", items(data, attributes)?.into()),
    ];
    let mut primitive = some(data, members)?;
    primitive.insert("attributes".to_owned(), attributes(data)?);
    if data.ratio(1, 6)? {
        let packed = json!({ "bufferView": index(data)?, "attributes": attributes(data)? });
        primitive.insert("extensions".to_owned(), json!({ "KHR_draco_mesh_compression": packed }));
    }
    Ok(primitive.into())
}

fn node(data: &mut Unstructured) -> Result<Value> {
    let members = vec![
        ("mesh", index(data)?),
        ("skin", index(data)?),
        ("children", indices(data)?),
        ("translation", json!(data.arbitrary::<[i8; 3]>()?)),
        ("scale", json!(data.arbitrary::<[i8; 3]>()?)),
        ("rotation", json!(data.arbitrary::<[i8; 4]>()?)),
        ("weights", json!(data.arbitrary::<[i8; 2]>()?)),
    ];
    let mut node = some(data, members)?;
    if data.ratio(1, 6)? {
        let instances = json!({ "attributes": { "TRANSLATION": index(data)?, "ROTATION": index(data)? } });
        node.insert("extensions".to_owned(), json!({ "EXT_mesh_gpu_instancing": instances }));
    }
    Ok(node.into())
}

fn animation(data: &mut Unstructured) -> Result<Value> {
    let channels = items(data, |data| {
        Ok(json!({ "sampler": index(data)?, "target": { "node": index(data)?, "path": data.choose(&PATHS)? } }))
    })?;
    let samplers = items(data, |data| {
        Ok(json!({ "input": index(data)?, "output": index(data)?, "interpolation": data.choose(&INTERPOLATIONS)? }))
    })?;
    Ok(json!({ "channels": channels, "samplers": samplers }))
}
