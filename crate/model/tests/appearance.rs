//! Materials, images and attributes of glTF files: read, kept with the triangles, written.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::Vec3;
use heatwalk_model::Model;
use heatwalk_model::appearance::{Alpha, Channel, Material, Run, Texture, Wrap};
use heatwalk_model::io::{self, write};
use heatwalk_surface::Error as SurfaceError;
use serde_json::{Value, json};

/// Bytes of a file that grows.
#[derive(Default)]
struct Data {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Data {
    fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.push(json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() }));
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: &[u8]) {
        let view = self.view(bytes);
        let is_normalized = component != 5126 && kind != "SCALAR";
        self.accessors.push(json!({
            "bufferView": view, "componentType": component, "type": kind, "count": count, "normalized": is_normalized
        }));
    }

    fn floats(&mut self, kind: &str, count: usize, values: &[f32]) {
        self.accessor(5126, kind, count, &values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>());
    }
}

/// A square of two triangles that have a material each, in a node that stretches and mirrors it, and one of a third kind
/// without a material. Accessors: positions, corners of each half, normals, texture coordinates, colors.
fn document() -> (Value, Vec<u8>) {
    let mut data = Data::default();
    data.floats("VEC3", 4, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    data.accessor(5121, "SCALAR", 3, &[0, 1, 2]);
    data.accessor(5121, "SCALAR", 3, &[0, 2, 3]);
    data.floats("VEC3", 4, &[0.6, 0.0, 0.8, 0.6, 0.0, 0.8, 0.6, 0.0, 0.8, 0.6, 0.0, 0.8]);
    let corners: Vec<u8> = [0_u16, 0, 65535, 0, 65535, 65535, 0, 65535].iter().flat_map(|u| u.to_le_bytes()).collect();
    data.accessor(5123, "VEC2", 4, &corners);
    data.accessor(5121, "VEC3", 4, &[255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 51, 51]);
    let image = data.view(b"\x89PNG of a texture");
    let attributes = json!({ "POSITION": 0, "NORMAL": 3, "TEXCOORD_1": 4, "COLOR_0": 5 });
    let half =
        |indices: u32, material: u32| json!({ "attributes": attributes, "indices": indices, "material": material });
    let document = json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_emissive_strength"],
        "nodes": [
            { "mesh": 0, "name": "halves", "scale": [-2, 1, 1] },
            { "mesh": 1, "name": "bare", "translation": [0, 0, 1] }
        ],
        "meshes": [
            { "primitives": [half(1, 1), half(2, 0)] },
            { "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }
        ],
        "materials": [
            {
                "pbrMetallicRoughness": {
                    "baseColorFactor": [0.5, 0.25, 1, 0.5], "metallicFactor": 0.25,
                    "baseColorTexture": { "index": 0, "texCoord": 1, "extensions": { "KHR_texture_transform": {
                        "offset": [0.25, 0.5], "scale": [2, -3], "rotation": 0.5
                    } } }
                },
                "normalTexture": { "index": 1, "scale": 0.5 },
                "alphaMode": "MASK", "alphaCutoff": 0.75, "doubleSided": true
            },
            {
                "emissiveFactor": [1, 0.5, 0],
                "occlusionTexture": { "index": 2, "strength": 0.5 },
                "extensions": { "KHR_materials_unlit": {}, "KHR_materials_emissive_strength": { "emissiveStrength": 4 } },
                "alphaMode": "BLEND"
            }
        ],
        "textures": [{ "source": 1, "sampler": 0 }, { "source": 1 }, { "source": 0 }],
        "samplers": [{ "wrapS": 33071, "wrapT": 33648, "magFilter": 9728 }],
        "images": [{ "uri": "gone.png" }, { "bufferView": image, "mimeType": "image/png" }],
        "bufferViews": data.views,
        "accessors": data.accessors,
        "buffers": [{ "uri": "data.bin", "byteLength": data.bytes.len() }]
    });
    (document, data.bytes)
}

fn read(document: &Value, data: &[u8]) -> Model {
    let resources = |uri: &str| (uri == "data.bin").then(|| data.to_vec());
    io::read("mesh.gltf", document.to_string().as_bytes(), &resources).unwrap()
}

fn texture(material: &Material, channel: Channel) -> &Texture {
    material.textures[channel as usize].as_ref().unwrap()
}

#[test]
fn materials_are_read() {
    let (document, data) = document();
    let model = read(&document, &data);
    let [masked, unlit] = &model.appearance.materials[..] else { panic!("two materials") };
    assert_eq!((masked.base_color, masked.metalness, masked.roughness), ([0.5, 0.25, 1.0, 0.5], 0.25, 1.0));
    assert_eq!((masked.alpha, masked.is_double_sided, masked.is_unlit), (Alpha::Mask(0.75), true, false));
    assert_eq!((unlit.alpha, unlit.is_double_sided, unlit.is_unlit), (Alpha::Blend, false, true));
    assert_eq!(unlit.emission, [4.0, 2.0, 0.0]);
    assert_eq!((masked.normal_scale, unlit.occlusion_strength), (0.5, 0.5));

    // The image of two textures is one; that which is missing is empty.
    let images: Vec<&[u8]> = model.appearance.images.iter().map(|image| &image.bytes[..]).collect();
    assert_eq!(images, [&b"\x89PNG of a texture"[..], b""]);
    assert_eq!(model.appearance.images[0].media_type, "image/png");
    assert_eq!(texture(unlit, Channel::Occlusion).image, 1);
    let normal = texture(masked, Channel::Normal);
    assert_eq!((normal.image, normal.set, normal.transform), (0, 0, Texture::IDENTITY));
    assert_eq!((normal.wrap, normal.is_sharp), ([Wrap::Repeat; 2], false));
    let base = texture(masked, Channel::BaseColor);
    assert_eq!((base.image, base.set, base.wrap, base.is_sharp), (0, 1, [Wrap::Clamp, Wrap::Mirror], true));
    // (1, 1) is scaled to (2, −3), turned by 0.5, moved.
    let (sine, cosine) = 0.5_f32.sin_cos();
    let at = base.transform.map(|[u, v, one]| u + v + one);
    assert!((at[0] - (2.0 * cosine - 3.0 * sine + 0.25)).abs() < 1e-6, "{at:?}");
    assert!((at[1] - (-2.0 * sine - 3.0 * cosine + 0.5)).abs() < 1e-6, "{at:?}");
}

#[test]
fn attributes_follow_their_vertices_and_runs_their_triangles() {
    let (document, data) = document();
    let model = read(&document, &data);
    let appearance = &model.appearance;
    // Halves share their vertices; the bare triangle has four of its own.
    assert_eq!((model.soup.positions.len(), model.soup.triangles.len()), (8, 3));
    assert_eq!(appearance.texcoords[2], [0.0, 0.0, 1.0, 1.0]);
    assert_eq!(appearance.colors[1], [0, 65535, 0, 65535]);
    assert_eq!((appearance.colors[3], appearance.colors[7]), ([13107, 13107, 13107, 65535], [65535; 4]));
    // Stretched along x, a normal leans less; mirrored, it leans the other way and stays on its side of the square.
    let normal = appearance.normals[0];
    assert!(normal.abs_diff_eq(Vec3::new(-0.3, 0.0, 0.8).normalize(), 1e-6), "{normal}");
    assert_eq!(appearance.normals[5], Vec3::ZERO);
    let run = |triangles, material| Run { triangles, material };
    assert_eq!(appearance.runs, [run(0..1, Some(1)), run(1..2, Some(0)), run(2..3, None)]);

    let bare = model.select(&[1]).unwrap();
    assert_eq!(bare.appearance.runs, [run(0..1, None)]);
    // The bare triangle uses three of its four vertices.
    assert_eq!((bare.appearance.colors.len(), bare.soup.positions.len()), (3, 3));
    let halves = model.select(&[0]).unwrap();
    assert_eq!(halves.appearance.texcoords, appearance.texcoords[..4]);
    assert_eq!(halves.appearance.runs, [run(0..1, Some(1)), run(1..2, Some(0))]);
    assert_eq!(appearance.runs_of([0, 2].into_iter()), [run(0..1, Some(1)), run(1..2, None)]);
}

#[test]
fn other_triangles_keep_the_vertices_that_they_use() {
    let (document, data) = document();
    let model = read(&document, &data);
    let other = model.with_triangles("fewer", vec![[5, 1, 2]]).unwrap();
    assert_eq!(other.soup.positions, [1, 2, 5].map(|vertex| model.soup.positions[vertex]));
    assert_eq!((&other.soup.triangles[..], other.soup.parts[0].name.as_str()), (&[[2, 0, 1]][..], "fewer"));
    assert_eq!((other.soup.unit, other.cameras), (model.soup.unit, model.cameras.clone()));
    assert!(other.appearance.is_empty());
    let beyond = model.with_triangles("fewer", vec![[0, 1, 2], [0, 1, 8]]);
    assert_eq!(beyond, Err(SurfaceError::IndexOutOfRange { triangle: 1, vertex: 8, vertices: 8 }));
}

#[test]
fn what_cannot_be_shown_keeps_no_file_from_opening() {
    let (whole, data) = document();
    let geometry = read(&whole, &data);
    let broken: [fn(&mut Value); 6] = [
        |document| document["accessors"][5]["count"] = json!(400),
        |document| document["accessors"][3]["type"] = json!("VEC2"),
        |document| document["textures"][0]["source"] = json!(77),
        |document| document["materials"][0]["normalTexture"]["index"] = json!(77),
        |document| document["meshes"][0]["primitives"][0]["material"] = json!(77),
        |document| document["images"][1]["bufferView"] = json!(77),
    ];
    for (index, spoil) in broken.into_iter().enumerate() {
        let mut document = whole.clone();
        spoil(&mut document);
        let model = read(&document, &data);
        assert_eq!(
            (&model.soup.positions, &model.soup.triangles),
            (&geometry.soup.positions, &geometry.soup.triangles),
            "case {index}"
        );
        assert_ne!(model.appearance, geometry.appearance, "case {index}");
    }
}

#[test]
fn a_file_without_materials_says_nothing() {
    let (mut document, data) = document();
    document["nodes"][0]["mesh"] = json!(1);
    let model = read(&document, &data);
    assert!(model.appearance.is_empty());
    assert!(model.appearance.images.is_empty(), "nothing is kept that nothing uses");
}

#[test]
fn a_basis_image_is_taken_where_there_is_no_other() {
    let (mut document, data) = document();
    let ktx2 = json!({ "KHR_texture_basisu": { "source": 2 } });
    document["textures"][0] = json!({ "extensions": ktx2, "source": 1 });
    document["textures"][1] = json!({ "extensions": ktx2 });
    let uri = "data:image/ktx2;base64,q0tUWCAyMLsNChoK";
    document["images"].as_array_mut().unwrap().push(json!({ "uri": uri, "mimeType": "image/ktx2" }));
    let model = read(&document, &data);
    let look = &model.appearance;
    let bytes = |channel| &look.images[texture(&look.materials[0], channel).image].bytes[..];
    assert_eq!(bytes(Channel::BaseColor), b"\x89PNG of a texture");
    assert_eq!(bytes(Channel::Normal), b"\xABKTX 20\xBB\r\n\x1A\n");
}

/// The document of a GLB file.
fn document_of(glb: &[u8]) -> Value {
    let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
    serde_json::from_slice(&glb[20..20 + length]).unwrap()
}

#[test]
fn images_that_need_an_extension_are_written_with_it() {
    for (media_type, name, encoded, bytes) in [
        ("image/ktx2", "KHR_texture_basisu", "q0tUWCAyMLsNChoK", &b"\xABKTX 20\xBB\r\n\x1A\n"[..]),
        ("image/webp", "EXT_texture_webp", "UklGRgQAAABXRUJQ", b"RIFF\x04\0\0\0WEBP"),
    ] {
        let (mut document, data) = document();
        let mut extensions = json!({});
        extensions[name] = json!({ "source": 2 });
        document["textures"][1] = json!({ "extensions": extensions });
        let image = json!({ "uri": format!("data:{media_type};base64,{encoded}") });
        document["images"].as_array_mut().unwrap().push(image);
        let model = read(&document, &data);
        let glb = write::distance_glb(&model, &vec![1.0; model.soup.positions.len()]);
        let back = io::read("mesh.glb", &glb, &|_| None).unwrap().appearance;
        let normal = &back.images[texture(&back.materials[0], Channel::Normal).image];
        assert_eq!((&normal.bytes[..], &normal.media_type[..]), (bytes, media_type));
        let written = document_of(&glb);
        assert_eq!(written["extensionsRequired"], json!([name]));
        assert!(written["extensionsUsed"].as_array().unwrap().contains(&name.into()));
        let textures = written["textures"].as_array().unwrap();
        let [by_extension, plain] = [true, false]
            .map(|wanted| textures.iter().filter(|texture| texture.get("extensions").is_some() == wanted).count());
        assert_eq!([by_extension, plain], [1, 1], "{name}");
    }
}

#[test]
fn the_older_material_model_is_understood() {
    let (mut document, data) = document();
    document["materials"][1]["extensions"] = json!({ "KHR_materials_pbrSpecularGlossiness": {
        "diffuseFactor": [0.5, 0.5, 0.25, 1], "glossinessFactor": 0.75, "diffuseTexture": { "index": 0 }
    } });
    let model = read(&document, &data);
    let material = &model.appearance.materials[1];
    assert_eq!((material.base_color, material.metalness, material.roughness), ([0.5, 0.5, 0.25, 1.0], 0.0, 0.25));
    assert_eq!(texture(material, Channel::BaseColor).wrap[0], Wrap::Clamp);
}

#[test]
fn extensions_of_materials_that_are_not_shown_are_written_again() {
    let (mut document, data) = document();
    let glass = json!({
        "KHR_materials_transmission": { "transmissionFactor": 0.9 },
        "KHR_materials_volume": { "thicknessFactor": 0.5, "attenuationColor": [0.5, 1, 0.25] },
        "KHR_materials_clearcoat": { "clearcoatFactor": 1, "clearcoatTexture": { "index": 0 } },
        "KHR_materials_unlit": {},
        "EXT_of_others": { "material": 1 }
    });
    document["materials"][1]["extensions"] = glass.clone();
    let model = read(&document, &data);
    let glb = write::distance_glb(&model, &vec![1.0; model.soup.positions.len()]);
    let written = document_of(&glb);
    let kept = ["KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_volume"];
    let extensions = written["materials"][1]["extensions"].as_object().unwrap();
    assert_eq!(extensions.keys().collect::<Vec<_>>(), kept);
    for name in kept {
        assert_eq!(extensions[name], glass[name]);
        assert!(written["extensionsUsed"].as_array().unwrap().contains(&name.into()), "{name}");
    }
    assert_eq!(io::read("mesh.glb", &glb, &|_| None).unwrap().appearance.materials[1].further.len(), 2);
}

#[test]
fn a_written_file_reads_back_with_its_materials() {
    let (mut document, data) = document();
    // Written normals are unit vectors for all vertices or none.
    document["meshes"][1]["primitives"][0] = document["meshes"][0]["primitives"][0].clone();
    let model = read(&document, &data);
    let glb = write::distance_glb(&model, &vec![1.0; model.soup.positions.len()]);
    let back = io::read("mesh.glb", &glb, &|_| None).unwrap();
    assert_eq!((&back.soup.positions, &back.soup.triangles), (&model.soup.positions, &model.soup.triangles));
    let (written, read) = (&model.appearance, &back.appearance);
    assert_eq!((&read.texcoords, &read.colors, &read.runs), (&written.texcoords, &written.colors, &written.runs));
    assert!(read.normals.iter().zip(&written.normals).all(|(a, b)| a.abs_diff_eq(*b, 1e-6)));
    // The image that is missing has gone, with its texture.
    assert_eq!(read.images, written.images[..1]);
    let without = Material { textures: Default::default(), occlusion_strength: 1.0, ..written.materials[1].clone() };
    assert_eq!(read.materials[1], without);
    let (mut there, mut back) = (written.materials[0].clone(), read.materials[0].clone());
    let base = Channel::BaseColor as usize;
    let transforms = [&mut there, &mut back].map(|material| material.textures[base].take().unwrap().transform);
    let apart = transforms[0].as_flattened().iter().zip(transforms[1].as_flattened()).map(|(a, b)| (a - b).abs());
    assert!(apart.fold(0.0, f32::max) < 1e-6, "{transforms:?}");
    assert_eq!(back, there);
}
