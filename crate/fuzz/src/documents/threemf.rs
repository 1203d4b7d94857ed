//! 3MF files: objects of meshes and components that refer to each other, in a package of parts.

use std::io::Write as _;

use arbitrary::{Arbitrary, Result, Unstructured};
use rawzip::{CompressionMethod, ZipArchiveWriter};

use super::{Number, list};

const RELATIONS: &str = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship \
     Target=\"/3D/3dmodel.model\" Id=\"rel0\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
const UNITS: [&str; 4] = ["millimeter", "inch", "micron", "parsec"];
const PATHS: [&str; 3] = ["", " p:path=\"/3D/other.model\"", " p:path=\"/3D/3dmodel.model\""];

/// The bytes of a file.
#[derive(Debug)]
pub struct ThreemfFile(pub Vec<u8>);

impl<'a> Arbitrary<'a> for ThreemfFile {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let mut bytes = Vec::new();
        let mut package = ZipArchiveWriter::new(&mut bytes);
        for (path, text) in [
            ("_rels/.rels", RELATIONS.to_owned()),
            ("3D/3dmodel.model", model(data)?),
            ("3D/other.model", model(data)?),
        ] {
            let file = package.new_file(path).compression_method(CompressionMethod::STORE);
            let (mut entry, config) = file.start().expect("a short path");
            let mut writer = config.wrap(&mut entry);
            writer.write_all(text.as_bytes()).expect("room in memory");
            let (_, descriptor) = writer.finish().expect("room in memory");
            entry.finish(descriptor).expect("room in memory");
        }
        package.finish().expect("room in memory");
        Ok(Self(bytes))
    }
}

fn model(data: &mut Unstructured) -> Result<String> {
    let unit = data.choose(&UNITS)?;
    let objects = (0..data.int_in_range(1..=4)?).map(|_| object(data)).collect::<Result<String>>()?;
    let items = (0..data.int_in_range(0..=3)?).map(|_| reference(data, "item")).collect::<Result<String>>()?;
    Ok(format!(
        "<model unit=\"{unit}\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
         xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"><resources>{objects}</resources>\
         <build>{items}</build></model>"
    ))
}

fn object(data: &mut Unstructured) -> Result<String> {
    let id = Number::arbitrary(data)?.0;
    let content = if data.arbitrary()? {
        let vertices: String =
            list::<[i8; 3]>(data)?.iter().map(|[x, y, z]| format!("<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>")).collect();
        let triangles: String = list::<[Number; 3]>(data)?
            .iter()
            .map(|[a, b, c]| format!("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", a.0, b.0, c.0))
            .collect();
        format!("<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>")
    } else {
        let components =
            (0..data.int_in_range(0..=3)?).map(|_| reference(data, "component")).collect::<Result<String>>()?;
        format!("<components>{components}</components>")
    };
    Ok(format!("<object id=\"{id}\" type=\"model\">{content}</object>"))
}

fn reference(data: &mut Unstructured, tag: &str) -> Result<String> {
    let (id, path) = (Number::arbitrary(data)?.0, data.choose(&PATHS)?);
    let transform: Vec<String> = data.arbitrary::<[i8; 12]>()?.iter().map(ToString::to_string).collect();
    Ok(format!("<{tag} objectid=\"{id}\"{path} transform=\"{}\"/>", transform.join(" ")))
}
