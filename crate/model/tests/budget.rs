//! Small files that claim, pack or repeat much are refused before they fill the memory; scenes that show a mesh many times are read.

#![cfg(not(target_arch = "wasm32"))]

mod allocated;

use std::fmt::Write as _;
use std::io::Write as _;
use std::iter;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use heatwalk_model::io::{self, Budget};
use heatwalk_model::{Error, Result};
use heatwalk_surface::Soup;
use miniz_oxide::deflate::{compress_to_vec, compress_to_vec_zlib};
use rawzip::{CompressionMethod, ZipArchiveWriter};

use allocated::{GROWING, alone};

/// What the parsed JSON, XML or text of a file takes for each of its bytes, which is not counted.
const PARSED: usize = 100;

/// What reading gives, and the most bytes in use at once meanwhile.
fn measured(name: &str, bytes: &[u8]) -> (Result<Soup>, usize) {
    allocated::measured(|| io::read(name, bytes, &|_| None).map(|model| model.soup))
}

/// Refuses the file for what it takes, within that.
fn assert_refused(name: &str, bytes: &[u8]) {
    let (read, peak) = measured(name, bytes);
    let budget = Budget::of_file(bytes.len()).left();
    assert_eq!(read.err(), Some(Error::OverBudget { size: bytes.len() as u64, budget }), "{name}");
    let most = (GROWING * budget as f64) as usize + PARSED * bytes.len();
    assert!(peak < most, "{name}: {peak} bytes of {budget}");
}

/// A file that ends before what it claims.
fn assert_small(name: &str, bytes: &[u8]) {
    let (read, peak) = measured(name, bytes);
    let error = read.map(|soup| soup.triangles.len()).expect_err(name);
    assert!(!matches!(error, Error::OverBudget { .. }), "{name}: {error}");
    assert!(peak < 1 << 20, "{name}: {peak} bytes");
}

#[test]
fn what_cutting_a_polygon_takes_is_counted() {
    let _alone = alone();
    const TEETH: usize = 50_000;
    let mut comb = format!("OFF\n{} 1 0\n", 2 * TEETH);
    // Teeth upward from left to right; the polygon comes back along their feet.
    (0..TEETH).for_each(|tooth| writeln!(comb, "{tooth} {} 0", 2 + tooth % 2).expect("text grows"));
    (0..TEETH).rev().for_each(|tooth| writeln!(comb, "{tooth} {} 0", tooth % 2).expect("text grows"));
    write!(comb, "{}", 2 * TEETH).expect("text grows");
    (0..2 * TEETH).for_each(|corner| write!(comb, " {corner}").expect("text grows"));
    let (read, peak) = measured("comb.off", comb.as_bytes());
    assert_eq!(read.expect("a sound polygon").triangles.len(), 2 * TEETH - 2);
    let few = Budget::limited(comb.len(), (peak as f64 / GROWING) as u64);
    let refused = io::read_within(&few, "comb.off", comb.as_bytes(), &|_| None);
    assert!(matches!(refused, Err(Error::OverBudget { .. })), "{peak} bytes");
}

/// Polygonal data whose arrays are as given, compressed or not, appended raw.
fn vtp(pieces: &str, is_compressed: bool, appended: &[u8]) -> Vec<u8> {
    let compressor = if is_compressed { "compressor=\"vtkZLibDataCompressor\"" } else { "" };
    let head = format!(
        "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt64\" {compressor}><PolyData>{pieces}</PolyData>\
         <AppendedData encoding=\"raw\">_"
    );
    [head.as_bytes(), appended, b"</AppendedData></VTKFile>"].concat()
}

fn array(kind: &str, name: usize) -> String {
    format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=\"appended\" offset=\"0\"/>")
}

fn words(numbers: impl IntoIterator<Item = u64>) -> Vec<u8> {
    numbers.into_iter().flat_map(u64::to_le_bytes).collect()
}

#[test]
fn blocks_of_zeros_are_not_inflated_beyond_the_budget() {
    let _alone = alone();
    const BLOCK: usize = 1 << 20;
    let packed = compress_to_vec_zlib(&vec![0; BLOCK], 6);
    for blocks in [40_usize, 100] {
        let lengths = [blocks as u64, BLOCK as u64, 0].into_iter().chain(iter::repeat_n(packed.len() as u64, blocks));
        let appended = [words(lengths), packed.repeat(blocks)].concat();
        let arrays: String = (0..200).map(|name| array("UInt8", name)).collect();
        assert_refused("a.vtp", &vtp(&format!("<Piece><Points>{arrays}</Points></Piece>"), true, &appended));
    }
}

#[test]
fn a_gifti_array_that_packs_much_is_refused() {
    let _alone = alone();
    let packed = BASE64_STANDARD.encode(compress_to_vec_zlib(&vec![0; 100 << 20], 9));
    let points = format!(
        "<DataArray Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\" Encoding=\"GZipBase64Binary\" Dim0=\"COUNT\" Dim1=\"3\">\
         <Data>{packed}</Data></DataArray>"
    );
    let document = format!("<GIFTI>{points}</GIFTI>");
    assert_refused("a.gii", document.replace("COUNT", "30000000").as_bytes());
    assert_small("a.gii", "<GIFTI></GIFTI>".as_bytes());
}

#[test]
fn arrays_and_pieces_that_share_their_bytes_count_each() {
    let _alone = alone();
    let bytes = vec![0; 100_000];
    let appended = [words([bytes.len() as u64]), bytes].concat();
    let arrays: String = (0..4000).map(|name| array("UInt8", name)).collect();
    assert_refused("a.vtp", &vtp(&format!("<Piece><Points>{arrays}</Points></Piece>"), false, &appended));
    let piece = format!("<Piece><Points>{}</Points></Piece>", array("UInt8", 0));
    assert_refused("a.vtp", &vtp(&piece.repeat(4000), false, &appended));
}

/// A document over one accessor of positions, all of them at the origin, which its buffer brings along.
fn gltf(positions: usize, rest: &str) -> String {
    let length = 12 * positions;
    format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"buffers\": [{{\"byteLength\": {length}, \"uri\": \"data:;base64,{}\"}}],\
         \"bufferViews\": [{{\"buffer\": 0, \"byteLength\": {length}}}],\
         \"accessors\": [{{\"bufferView\": 0, \"componentType\": 5126, \"count\": {positions}, \"type\": \"VEC3\"}}], {rest}}}",
        "AAAA".repeat(length / 3)
    )
}

fn list(item: impl Fn(usize) -> String, count: usize) -> String {
    (0..count).map(item).collect::<Vec<_>>().join(",")
}

/// The same mesh at so many nodes.
fn nodes(mesh: &str, count: usize) -> String {
    format!("\"meshes\": [{mesh}], \"nodes\": [{}]", list(|_| "{\"mesh\": 0}".to_owned(), count))
}

#[test]
fn what_shares_an_accessor_counts_each() {
    let _alone = alone();
    let plain = "{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}";
    assert_refused("nodes.gltf", gltf(9999, &nodes(plain, 2000)).as_bytes());
    let apart = |number: usize| format!("{{\"attributes\": {{\"POSITION\": 0, \"TEXCOORD_0\": {number}}}}}");
    let primitives = format!("{{\"primitives\": [{}]}}", list(apart, 2000));
    assert_refused("primitives.gltf", gltf(9999, &nodes(&primitives, 1)).as_bytes());
    let targets = list(|_| "{\"POSITION\": 0}".to_owned(), 1000);
    let morphed = format!("{{\"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}, \"targets\": [{targets}]}}]}}");
    let weights = "\"animations\": [{\"channels\": [{\"sampler\": 0, \"target\": {\"node\": 0, \"path\": \"weights\"}}],\
        \"samplers\": [{\"input\": 1, \"output\": 1}]}]";
    let document = gltf(9999, &format!("{}, {weights}", nodes(&morphed, 1))).replace(
        "\"type\": \"VEC3\"}]",
        "\"type\": \"VEC3\"}, {\"bufferView\": 0, \"componentType\": 5126, \"count\": 1, \"type\": \"SCALAR\"}]",
    );
    assert_refused("targets.gltf", document.as_bytes());
}

#[test]
fn names_and_images_that_are_shared_count_each() {
    let _alone = alone();
    let name = "x".repeat(100_000);
    let mesh = format!("{{\"name\": \"{name}\", \"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}}}]}}");
    assert_refused("names.gltf", gltf(3, &nodes(&mesh, 10_000)).as_bytes());
    let weights = list(|_| "0".to_owned(), 100_000);
    let mesh = format!("{{\"weights\": [{weights}], \"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}}}]}}");
    assert_refused("weights.gltf", gltf(3, &nodes(&mesh, 10_000)).as_bytes());
    let material =
        |number: usize| format!("{{\"pbrMetallicRoughness\": {{\"baseColorTexture\": {{\"index\": {number}}}}}}}");
    let images = format!(
        "\"images\": [{}], \"textures\": [{}], \"materials\": [{}]",
        list(|_| "{\"bufferView\": 0, \"mimeType\": \"image/png\"}".to_owned(), 3000),
        list(|number| format!("{{\"source\": {number}}}"), 3000),
        list(material, 3000)
    );
    let mesh = "{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"material\": 0}]}";
    assert_refused("images.gltf", gltf(9999, &format!("{}, {images}", nodes(mesh, 1))).as_bytes());
}

#[test]
fn views_that_share_compressed_bytes_count_each() {
    let _alone = alone();
    // A stream of 4,096 elements of 256 bytes, all of them zeros.
    let (count, stride, block) = (4096, 256, 32);
    let stream = [&[0xA0][..], &vec![0; count / block * stride + stride]].concat();
    let extension = format!(
        "{{\"EXT_meshopt_compression\": {{\"buffer\": 0, \"byteLength\": {}, \"byteStride\": {stride}, \"count\": {count},\
         \"mode\": \"ATTRIBUTES\"}}}}",
        stream.len()
    );
    let length = count * stride;
    let view = |_| {
        format!("{{\"buffer\": 0, \"byteLength\": {length}, \"byteStride\": {stride}, \"extensions\": {extension}}}")
    };
    let accessor =
        |view: usize| format!("{{\"bufferView\": {view}, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}}");
    let primitive = |accessor: usize| format!("{{\"attributes\": {{\"POSITION\": {accessor}}}}}");
    let document = format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"buffers\": [{{\"byteLength\": {}}}], \"bufferViews\": [{}],\
         \"accessors\": [{}], {}}}",
        stream.len(),
        list(view, 1000),
        list(accessor, 1000),
        nodes(&format!("{{\"primitives\": [{}]}}", list(primitive, 1000)), 1)
    );
    assert_refused("a.glb", &glb(&document, &stream));
}

fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8; 4], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat();
    let chunks = [chunk(b"JSON", json.as_bytes()), chunk(b"BIN\0", binary)].concat();
    [&b"glTF\x02\0\0\0"[..], &(chunks.len() as u32 + 12).to_le_bytes(), &chunks].concat()
}

/// A 3MF file of this model.
fn threemf(resources: &str, build: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    let file = archive.new_file("3D/3dmodel.model").compression_method(CompressionMethod::DEFLATE);
    let (mut entry, config) = file.start().unwrap();
    let mut writer = config.wrap(Vec::new());
    write!(writer, "<model><resources>{resources}</resources><build>{build}</build></model>").unwrap();
    let (plain, descriptor) = writer.finish().unwrap();
    entry.write_all(&compress_to_vec(&plain, 6)).unwrap();
    entry.finish(descriptor).unwrap();
    archive.finish().unwrap();
    bytes
}

#[test]
fn objects_that_are_built_many_times_count_each() {
    let _alone = alone();
    let vertices = "<vertex x=\"0\" y=\"0\" z=\"0\"/>".repeat(3000);
    let triangles = "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>".repeat(3000);
    let mesh = format!("<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>");
    let items = |count: usize| "<item objectid=\"1\"/>".repeat(count);
    assert_refused("a.3mf", &threemf(&format!("<object id=\"1\">{mesh}</object>"), &items(10_000)));
    let name = "x".repeat(100_000);
    let small = mesh.replace(&"<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>".repeat(2999), "");
    let small = small.replace(&"<vertex x=\"0\" y=\"0\" z=\"0\"/>".repeat(2997), "");
    assert_refused("a.3mf", &threemf(&format!("<object id=\"1\" name=\"{name}\">{small}</object>"), &items(10_000)));
    let empty: String = (0..1_000_000).map(|id| format!("<object id=\"{id}\"/>")).collect();
    let repeated = "<object id=\"1\"/>".repeat(2_000_000);
    assert_refused("a.3mf", &threemf(&repeated, ""));
    assert!(io::read("a.3mf", &threemf(&empty, ""), &|_| None).is_err());
}

#[test]
fn groups_that_repeat_the_name_of_an_object_count_each() {
    let _alone = alone();
    let mut text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\no {}\n", "x".repeat(100_000));
    (0..20_000).for_each(|group| writeln!(text, "g {group}\nf 1 2 3").unwrap());
    assert_refused("a.obj", text.as_bytes());
}

#[test]
fn a_library_that_is_named_in_many_ways_counts_each_time() {
    let _alone = alone();
    let image = vec![0; 1 << 20];
    let resources = |uri: &str| match uri {
        "a.mtl" => {
            let maps = (0..3000).map(|map| format!("newmtl {map}\nmap_Kd {}a.png\n", "./".repeat(map)));
            Some(maps.collect::<String>().into_bytes())
        }
        uri if uri.ends_with("a.png") => Some(image.clone()),
        _ => None,
    };
    let uses: String = (0..3000).map(|map| format!("usemtl {map}\nf 1 2 3\n")).collect();
    let text = format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{uses}");
    let (read, peak) = allocated::measured(|| io::read("a.obj", text.as_bytes(), &resources));
    assert!(matches!(read, Err(Error::OverBudget { .. })), "{:?}", read.map(|model| model.soup.parts.len()));
    assert!(peak < (GROWING * f64::from(1_u32 << 31)) as usize, "{peak} bytes");
}

#[test]
fn counts_without_anything_behind_them_take_nothing() {
    let _alone = alone();
    let huge = 1_u64 << 62;
    let ply = |format: &str, vertices: u64| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n\
             element face 1\nproperty list uint uchar vertex_indices\nend_header\n"
        )
    };
    assert_small("a.ply", ply("ascii", huge).as_bytes());
    assert_small("a.ply", ply("binary_little_endian", huge).as_bytes());
    let claims = [ply("binary_little_endian", 3).as_bytes(), &[0; 36], &u32::MAX.to_le_bytes(), &[0, 1, 2]].concat();
    assert_small("a.ply", &claims);
    assert_small("a.off", format!("OFF\n{huge} {huge} 0\n0 0 0\n").as_bytes());
    assert_small("a.off", format!("OFF\n1 1 0\n0 0 0\n{huge} 0 0 0\n").as_bytes());
    for statement in ["POINTS COUNT float", "POINTS 1 float\n0 0 0\nPOLYGONS COUNT COUNT", "FIELD a 1\nb COUNT 1 float"]
    {
        for encoding in ["ASCII", "BINARY"] {
            let statement = statement.replace("COUNT", &huge.to_string());
            let text = format!("# vtk DataFile Version 3.0\na\n{encoding}\nDATASET POLYDATA\n{statement}\n0 0 0\n");
            assert_small("a.vtk", text.as_bytes());
        }
    }
    for lengths in [vec![huge], vec![1, huge, 0, 8], vec![huge, 8, 8], vec![1, 8, 8, huge]] {
        let points = format!("<Piece><Points>{}</Points></Piece>", array("UInt8", 0));
        for is_compressed in [true, false] {
            let bytes = vtp(&points, is_compressed, &words(lengths.iter().copied()));
            let (read, peak) = measured("a.vtp", &bytes);
            assert!(read.is_err() && peak < 1 << 20, "{lengths:?}: {peak} bytes");
        }
    }
    let mut stl = vec![0; 80];
    stl.extend(u32::MAX.to_le_bytes());
    assert_small("a.stl", &stl);
}

#[test]
fn scenes_that_show_a_mesh_many_times_are_read() {
    let _alone = alone();
    let mesh = "{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}";
    let soup = io::read("a.gltf", gltf(999, &nodes(mesh, 1000)).as_bytes(), &|_| None).unwrap().soup;
    assert_eq!((soup.positions.len(), soup.triangles.len()), (999_000, 333_000));
    let mut instances = gltf(
        300,
        "\"meshes\": [MESH], \"nodes\": [{\"mesh\": 0, \"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\": {\"TRANSLATION\": 0}}}}]",
    );
    instances = instances.replace("MESH", mesh);
    assert_eq!(io::read("a.gltf", instances.as_bytes(), &|_| None).unwrap().soup.triangles.len(), 30_000);
}
