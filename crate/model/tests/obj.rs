//! Materials and attributes of OBJ files: by corner, while vertices keep the file's numbers.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::{DVec3, Vec3};
use heatwalk_model::Model;
use heatwalk_model::appearance::{Alpha, Channel, Material, Run, Texels, Texture, Wrap};
use heatwalk_model::io::{self, write};
use heatwalk_surface::{InputTriangle, InputVertex};

use crate::reading::{areas, cut_short_at_every_byte, damaged_copies, flip_bytes, part_names};

/// A square of two triangles that share an edge, along which their texture coordinates differ, and one of another material.
const OBJ: &str = "mtllib sub/house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvn 0 0 2\nvn 1 0 0\n\
    g wall\nusemtl brick\nf 1/1/1 2/2/1 3/3/1\nf 1/5/1 3/3/1 4/4/1\n\
    g roof\nusemtl tile\nf 1/1/2 2/2/2 4\nusemtl unknown\nf -5 -4 -2\n";

const MTL: &str = "# a library\nnewmtl brick\nKd 0.5 0.5 0.5\nNs 98\nd 0.25\nmap_Kd -s 2 3 1 -o 0.25 0.5 -clamp on wall of brick.png\n\
    newmtl tile\nKd 0 0 0\nmap_Kd tile.png\nmap_d -imfchan m holes.png\nKe 2 0 1\nPr 0.5\nmap_Pr r.png\nmap_Pm m.png\nmap_Bump -bm 0.5 bump.png\n\
    newmtl unused\nmap_Kd unused.png\n";

fn given(uri: &str) -> Option<Vec<u8>> {
    match uri {
        "sub/house.mtl" => Some(MTL.into()),
        "sub/wall of brick.png" => Some(b"brick".to_vec()),
        // Named relative to the library, and found beside the mesh.
        "tile.png" => Some(b"tile".to_vec()),
        _ => None,
    }
}

fn read(obj: &str, resource: impl Fn(&str) -> Option<Vec<u8>>) -> Model {
    io::read("house.obj", obj.as_bytes(), &resource).unwrap()
}

/// The materials of a library that a triangle uses one after another.
fn materials(library: &str) -> Vec<Material> {
    let names = library.lines().filter_map(|line| line.strip_prefix("newmtl "));
    let uses: String = names.map(|name| format!("usemtl {name}\nf 1 2 3\n")).collect();
    let obj = format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{uses}");
    read(&obj, |uri| (uri == "a.mtl").then(|| library.into())).appearance.materials.clone()
}

fn row(model: &Model, triangle: u32, vertex: u32) -> usize {
    model.appearance.row(InputTriangle(triangle), InputVertex(vertex))
}

#[test]
fn vertices_keep_their_numbers_where_attributes_have_seams() {
    let model = read(OBJ, given);
    assert_eq!(model.soup.positions.len(), 5);
    assert_eq!(areas(&model.soup), [0.5; 4]);
    assert_eq!(model.soup.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 3], [0, 1, 3]]);
    assert_eq!(part_names(&model.soup), ["wall", "roof"]);
    let texcoord = |triangle, vertex| model.appearance.texcoords[row(&model, triangle, vertex)];
    // Images begin at their upper left corner, the format's texture coordinates at the lower left one.
    assert_eq!((texcoord(0, 0), texcoord(1, 0)), ([0.0, 1.0, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0]));
    assert_eq!((texcoord(0, 2), texcoord(1, 2)), ([1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]));
    assert_eq!(row(&model, 0, 2), row(&model, 1, 2), "equal attributes are one row");
    let normal = |triangle, vertex| model.appearance.normals[row(&model, triangle, vertex)];
    assert_eq!((normal(0, 1), normal(2, 1), normal(2, 3)), (Vec3::Z, Vec3::X, Vec3::ZERO));
    assert_eq!(model.appearance.seams.vertices[..5], [0, 1, 2, 3, 4]);

    // The roof alone has no use for the rows of the wall.
    let roof = model.select(&[1]).unwrap();
    assert_eq!((roof.soup.positions.len(), roof.soup.triangles.len()), (3, 2));
    assert_eq!(roof.appearance.texcoords[row(&roof, 0, 0)], [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(roof.appearance.normals[row(&roof, 0, 1)], Vec3::X);
    assert!(roof.appearance.seams.vertices.len() < model.appearance.seams.vertices.len());
    assert_eq!(roof.appearance.seams.vertices.len(), roof.appearance.normals.len());
}

#[test]
fn materials_are_read_and_what_is_missing_is_named() {
    let model = read(OBJ, given);
    let look = &model.appearance;
    let run = |triangles, material| Run { triangles, material };
    assert_eq!(look.runs, [run(0..2, Some(0)), run(2..3, Some(1)), run(3..4, None)]);
    assert_eq!(look.missing, ["holes.png", "r.png", "m.png", "bump.png"]);
    let [brick, tile] = &look.materials[..] else { panic!("two materials") };

    // Half as bright to the eye is 0.2140 of the light; the exponent 98 is as wide as roughness 0.02^¼.
    assert!(brick.base_color.iter().zip([0.2140, 0.2140, 0.2140, 0.25]).all(|(a, b)| (a - b).abs() < 1e-4));
    assert!((brick.roughness - 0.02_f32.powf(0.25)).abs() < 1e-6, "{}", brick.roughness);
    assert_eq!((brick.metalness, brick.alpha, brick.is_double_sided), (0.0, Alpha::Blend, true));
    let texture = brick.textures[Channel::BaseColor as usize].unwrap();
    // (u, v) goes to (2u + 0.25, 3v + 0.5) with v upward, and (0, 0) below there is (0, 1) from above.
    assert_eq!(texture.transform, [[2.0, 0.0, 0.25], [0.0, 3.0, -2.5]]);
    assert_eq!((texture.wrap, look.images[texture.image].bytes.as_slice()), ([Wrap::Clamp; 2], &b"brick"[..]));
    assert_eq!(look.images[texture.image].name, "wall of brick.png");

    assert_eq!(
        (tile.base_color, tile.emission[0], tile.emission[2]),
        ([1.0; 4], 2.0, 1.0),
        "black under a texture is white"
    );
    assert_eq!((tile.roughness, tile.metalness, tile.normal_scale, tile.alpha), (0.5, 1.0, 0.5, Alpha::Mask(0.5)));
    let image = |channel: Channel| &look.images[tile.textures[channel as usize].unwrap().image];
    let Texels::Channels([red, green, blue, alpha]) = image(Channel::BaseColor).texels else { panic!("channels") };
    let name =
        |channel: Option<(usize, usize)>| channel.map(|(image, channel)| (&look.images[image].name[..], channel));
    assert_eq!([red, green, blue].map(name), [0, 1, 2].map(|channel| Some(("tile.png", channel))));
    assert_eq!(name(alpha), Some(("holes.png", 3)));
    let Texels::Channels(channels) = image(Channel::MetallicRoughness).texels else { panic!("channels") };
    assert_eq!(channels.map(name), [None, Some(("r.png", 0)), Some(("m.png", 0)), None]);
    assert_eq!((image(Channel::Normal).texels, &image(Channel::Normal).name[..]), (Texels::Heights, "bump.png"));
}

#[test]
fn statements_of_materials_mean_what_programs_write() {
    let one = |statements: &str| materials(&format!("newmtl a\n{statements}\n")).remove(0);
    assert_eq!(one("Kd 1").base_color, [1.0; 4], "one number is for all channels");
    assert_eq!(one("Tr 0.75").base_color[3], 0.25);
    assert_eq!(one("d 1\nTr 1").base_color[3], 1.0, "where both are given, d holds");
    assert_eq!((one("Ns 500\nillum 1").roughness, one("Ns 500\nKs 0 0 0").roughness), (1.0, 1.0), "no highlight");
    assert!(one("illum 0").is_unlit && !one("illum 2").is_unlit);
    assert_eq!((one("Pr 0.25\nPm 0.5\nNs 10").roughness, one("Pm 0.5").metalness), (0.25, 0.5));
    assert_eq!(one("KD 1 0 0\nmap_kd x.png").base_color, [1.0, 0.0, 0.0, 1.0], "keywords in any case");
    assert_eq!(one("map_Ke missing.png").emission, [0.0; 3], "without its image nothing gives off light");
    let packed = one("map_Pr orm.png\nmap_Pm orm.png");
    assert_eq!((packed.roughness, packed.metalness), (1.0, 1.0));
    assert_eq!(one("map_Kd a.png\nmap_d a.png").alpha, Alpha::Mask(0.5));
    let normal = one("norm n.png\nbump b.png").textures[Channel::Normal as usize].unwrap();
    assert_eq!((normal.transform, normal.image), (Texture::IDENTITY, 0), "a normal map comes before a bump map");
    for harmless in
        ["map_Kd", "map_Kd -s", "map_Kd -o 1 -clamp", "Kd spectral file.rfl", "Kd", "d nan", "Ns -5", "bump -bm"]
    {
        let material = one(harmless);
        assert_eq!(material, Material { textures: material.textures, ..one("") }, "{harmless}");
        assert_eq!(material.textures, one("").textures, "{harmless}");
    }
}

#[test]
fn libraries_are_found_as_they_are_named() {
    let found = |statement: &str, there: &'static str| {
        let obj = format!("{statement}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        let model = read(&obj, |uri| (uri == there).then(|| b"newmtl a\nKd 1 0 0".to_vec()));
        (model.appearance.materials.len(), model.appearance.missing.clone())
    };
    assert_eq!(found("mtllib my house.mtl", "my house.mtl"), (1, vec![]));
    assert_eq!(found("mtllib x.mtl a.mtl", "a.mtl"), (1, vec!["x.mtl".to_owned()]));
    assert_eq!(found("mtllib C:\\models\\a.mtl", "a.mtl"), (1, vec![]), "paths of another machine");
    assert_eq!(found("mtllib a.mtl", "b.mtl"), (0, vec!["a.mtl".to_owned()]));
    assert_eq!(found("", "b.mtl"), (0, vec![]));
}

#[test]
fn a_file_without_materials_is_as_it_was() {
    let plain = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n", |_| None);
    assert!(plain.appearance.is_empty());
    assert!(plain.appearance.texcoords.is_empty() && plain.appearance.seams.corners.is_empty());
}

#[test]
fn colors_of_vertices_are_light() {
    let colored = |first: &str| {
        read(&format!("v 0 0 0 {first}\nv 1 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n"), |_| None).appearance.colors.clone()
    };
    assert_eq!(colored("1 0.5 0"), [[65535, 14027, 0, 65535], [65535; 4], [0, 0, 0, 65535]]);
    assert_eq!(colored("255 51 0")[0], [65535, 2170, 0, 65535], "numbers up to 255");
    assert!(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", |_| None).appearance.is_empty(), "a weight is no color");
    let seams = read(&format!("{OBJ}v 1 1 1 1 0 0\n"), given).appearance.clone();
    assert_eq!(seams.colors.len(), seams.seams.vertices.len());
}

#[test]
fn a_written_file_has_the_vertices_first_and_their_copies_after_them() {
    let model = read(OBJ, given);
    let distance: Vec<f64> = (0..5).map(f64::from).collect();
    let back = io::read("a.glb", &write::distance_glb(&model, &distance), &|_| None).unwrap();
    assert_eq!(back.soup.positions[..5], model.soup.positions[..]);
    for triangle in 0..2 {
        for (there, here) in back.soup.triangles[triangle].into_iter().zip(model.soup.triangles[triangle]) {
            assert_eq!(back.soup.positions[there as usize], model.soup.positions[here as usize]);
            let row = row(&model, triangle as u32, here);
            assert_eq!(back.appearance.texcoords[there as usize], model.appearance.texcoords[row]);
        }
    }
    assert_eq!(back.soup.positions[back.soup.triangles[0][2] as usize], DVec3::new(1.0, 1.0, 0.0));
    let names: Vec<_> = back.appearance.images.iter().map(|image| &image.bytes[..]).collect();
    assert_eq!(names, [&b"brick"[..], b"tile"], "the color of the tiles is kept without its holes");
}

#[test]
fn damaged_libraries_do_not_panic() {
    flip_bytes("a.obj", OBJ.as_bytes());
    cut_short_at_every_byte("a.obj", OBJ.as_bytes());
    for damaged in damaged_copies(MTL.as_bytes()) {
        let model = read(OBJ, |uri| if uri == "sub/house.mtl" { Some(damaged.clone()) } else { given(uri) });
        assert_eq!(model.soup.triangles.len(), 4);
        model.select(&[1]).unwrap();
    }
}
