//! 3MF files: objects, components, colors and units; archives that are damaged or made to do harm.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::io::Write;

use glam::DVec3;
use heatwalk_model::Error;
use heatwalk_model::io::{self, Budget};
use heatwalk_surface::{InputTriangle, InputVertex, Unit};
use miniz_oxide::deflate::compress_to_vec;
use rawzip::{CompressionMethod, ZipArchiveWriter};

use crate::reading::{areas, cut_short_at_every_byte, damaged_copies, flip_bytes, part_names, read, read_model};

/// An archive of files that are deflated, or stored where their names end in `.rels`.
fn archive(files: &[(&str, &str)]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    for (name, text) in files {
        let is_stored = name.ends_with(".rels");
        let method = if is_stored { CompressionMethod::STORE } else { CompressionMethod::DEFLATE };
        let (mut entry, config) = archive.new_file(name).compression_method(method).start().unwrap();
        let mut writer = config.wrap(Vec::new());
        writer.write_all(text.as_bytes()).unwrap();
        let (plain, descriptor) = writer.finish().unwrap();
        entry.write_all(&if is_stored { plain } else { compress_to_vec(&plain, 6) }).unwrap();
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

fn model(unit: &str, resources: &str, build: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model {unit} xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
         xmlns:m=\"m\" xmlns:p=\"p\"><resources>{resources}</resources><build>{build}</build></model>"
    )
}

/// A file with one model at the usual place.
fn file(unit: &str, resources: &str, build: &str) -> Vec<u8> {
    archive(&[("3D/3dmodel.model", &model(unit, resources, build))])
}

/// A right triangle of area ½ in the plane z = 0.
fn triangle(id: u32, attributes: &str, colors: &str) -> String {
    format!(
        "<object id=\"{id}\" {attributes}><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>\
         <vertex x=\"0\" y=\"1.0\" z=\"0\" /></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" {colors}/></triangles>\
         </mesh></object>"
    )
}

const ITEM: &str = "<item objectid=\"1\"/>";

#[test]
fn objects_stand_where_items_and_components_put_them() {
    let resources = format!(
        "{}{}<object id=\"3\" name=\"pair &amp; more\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>\
         <component objectid=\"2\"/></components></object>",
        triangle(1, "", ""),
        triangle(2, "name=\"small\"", "")
    );
    let build = "<item objectid=\"3\" transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"/><item objectid=\"1\" transform=\"0 1 0 1 0 0 0 0 1 0 0 0\"/>";
    let soup = read("parts.3mf", file("unit=\"inch\"", &resources, build)).unwrap();
    assert_eq!(part_names(&soup), ["pair & more", "small", "parts"]);
    assert_eq!(
        soup.positions[0],
        DVec3::new(20.0, 0.0, 5.0),
        "moved by the component, then scaled and moved by the item"
    );
    assert_eq!(soup.positions[4], DVec3::new(2.0, 0.0, 5.0));
    // The last one is mirrored: x and y change places, and its corners turn.
    assert_eq!((soup.positions[7], soup.triangles[2]), (DVec3::Y, [6, 8, 7]));
    assert_eq!(areas(&soup), [2.0, 2.0, 0.5]);
    assert_eq!(soup.unit, Some(Unit::Inch));
    assert_eq!(soup.select(&[1]).unwrap().unit, Some(Unit::Inch));
    assert_eq!(read("a.3mf", file("", &triangle(1, "", ""), ITEM)).unwrap().unit, Some(Unit::Millimeter));
}

#[test]
fn models_in_other_files_of_the_package_are_read() {
    let root = model(
        "",
        "<object id=\"1\" name=\"a\"><components><component p:path=\"/3D/Objects/b.model\" objectid=\"1\"/></components></object>",
        ITEM,
    );
    let other = model("", &triangle(1, "name=\"b\"", ""), "");
    let relationships = "<Relationships><Relationship Target=\"/other.png\" Type=\"x/thumbnail\"/>\
        <Relationship Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"/3D/root.model\"/></Relationships>";
    let package = archive(&[("_rels/.rels", relationships), ("3D/root.model", &root), ("3D/objects/B.model", &other)]);
    assert_eq!(part_names(&read("a.3mf", &package).unwrap()), ["b"]);
    assert_eq!(read("told by its first bytes", &package).unwrap().triangles.len(), 1);
}

#[test]
fn colors_of_groups_and_base_materials_belong_to_corners() {
    let groups = "<m:colorgroup id=\"7\"><m:color color=\"#FF0000\"/><m:color color=\"#00FF0080\"/></m:colorgroup>\
        <basematerials id=\"8\"><base name=\"blue\" displaycolor=\"#0000FF\"/></basematerials>";
    let resources = format!(
        "{groups}{}{}{}",
        triangle(1, "pid=\"8\" pindex=\"0\"", ""),
        triangle(2, "pid=\"8\" pindex=\"0\"", "pid=\"7\" p1=\"0\" p2=\"1\" p3=\"9\""),
        triangle(3, "", "")
    );
    let build = "<item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"3\"/>";
    let model = read_model("a.3mf", file("", &resources, build)).unwrap();
    let color = |triangle, vertex| {
        let row = model.appearance.row(InputTriangle(triangle), InputVertex(vertex));
        model.appearance.colors[row]
    };
    let (blue, white) = ([0, 0, 65535, 65535], [65535; 4]);
    assert_eq!([color(0, 0), color(0, 2), color(2, 6)], [blue, blue, white]);
    assert_eq!([color(1, 3), color(1, 4), color(1, 5)], [[65535, 0, 0, 65535], [0, 65535, 0, 32896], white]);
    assert!(read_model("a.3mf", file("", &triangle(1, "", "p1=\"0\""), ITEM)).unwrap().appearance.is_empty());

    // Two triangles at one vertex, each in a color of its own.
    let square = triangle(1, "pid=\"7\"", "p1=\"0\"")
        .replace("</triangles>", "<triangle v1=\"0\" v2=\"2\" v3=\"1\" p1=\"1\"/></triangles>");
    let model = read_model("a.3mf", file("", &format!("{groups}{square}"), ITEM)).unwrap();
    assert_eq!((model.soup.positions.len(), model.appearance.colors.len()), (3, 6));
}

#[test]
fn supports_are_no_part_of_the_surface() {
    let resources = format!("{}{}", triangle(1, "type=\"model\"", ""), triangle(2, "type=\"support\"", ""));
    let soup = read("a.3mf", file("", &resources, "<item objectid=\"2\"/><item objectid=\"1\"/>")).unwrap();
    assert_eq!(soup.triangles.len(), 1);
}

#[test]
fn errors_name_the_place() {
    let one = triangle(1, "", "");
    for (bytes, place) in [
        (file("", &one, "<item objectid=\"5\"/>"), "object 5"),
        (file("", &one.replace("v3=\"2\"", "v3=\"-1\""), ITEM), "3dmodel.model, byte"),
        (file("", &one.replace("x=\"1\"", "x=\"one\""), ITEM), "3dmodel.model, byte"),
        (file("", &one.replace("</mesh>", "</mush>"), ITEM), "3dmodel.model, byte"),
        (archive(&[("readme.txt", "no model")]), "3D/3dmodel.model"),
        (b"PK\x03\x04 and no archive".to_vec(), "archive"),
        (
            file("", "<object id=\"1\"><components><component objectid=\"1\"/></components></object>", ITEM),
            "nested in a circle",
        ),
    ] {
        let error = read("a.3mf", bytes).unwrap_err().to_string();
        assert!(error.contains(place), "{error}");
    }
    let error = read("a.3mf", file("", &one.replace("v3=\"2\"", "v3=\"3\""), ITEM)).unwrap_err().to_string();
    assert!(error.contains("vertex 3 does not exist; there are 3, counted from 0"), "{error}");
    let error = read("a.3mf", file("", &one, "")).unwrap_err().to_string();
    assert!(error.contains("no build item of a shows a mesh"), "{error}");
}

#[test]
fn files_that_grow_without_measure_are_refused() {
    // 2²⁵ spaces are packed to a thousandth.
    let padding = format!("<!--{}-->", " ".repeat(1 << 25));
    let bytes = file("", &format!("{padding}{}", triangle(1, "", "")), ITEM);
    let budget = Budget::limited(bytes.len(), 1 << 24);
    let error = io::read_within(&budget, "a.3mf", &bytes, &|_| None).unwrap_err();
    assert_eq!(error, Error::OverBudget { size: bytes.len() as u64, budget: 1 << 24 });
    // Each object is twice the one before: 2⁴⁰ triangles.
    let doubled = |id: u32| {
        let half = format!("<component objectid=\"{}\"/>", id - 1);
        format!("<object id=\"{id}\"><components>{half}{half}</components></object>")
    };
    let resources: String = (2..=41).map(doubled).collect();
    let error = read("a.3mf", file("", &(triangle(1, "", "") + &resources), "<item objectid=\"41\"/>")).unwrap_err();
    assert!(matches!(error, Error::OverBudget { .. }), "{error}");
}

#[test]
fn two_files_of_one_name_are_refused() {
    let model = model("", &triangle(1, "", ""), ITEM);
    let error = read("a.3mf", archive(&[("3D/3dmodel.model", &model), ("3D/3dmodel.model", &model)])).unwrap_err();
    assert!(error.to_string().contains("3D/3dmodel.model: two files of the archive have this name"), "{error}");
}

#[test]
fn damaged_files_do_not_panic() {
    let colors = "<m:colorgroup id=\"7\"><m:color color=\"#FF0000\"/><m:color color=\"#00FF0080\"/></m:colorgroup>";
    let resources = format!("{colors}{}", triangle(1, "pid=\"7\" pindex=\"1\"", "p1=\"0\""));
    let text = model("", &resources, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/>");
    let bytes = archive(&[("3D/3dmodel.model", &text)]);
    cut_short_at_every_byte("a.3mf", &bytes);
    flip_bytes("a.3mf", &bytes);
    // In an archive that is sound.
    for damaged in damaged_copies(text.as_bytes()) {
        let damaged = archive(&[("3D/3dmodel.model", &String::from_utf8_lossy(&damaged))]);
        if let Ok(soup) = read("a.3mf", damaged) {
            assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
        }
    }
}
