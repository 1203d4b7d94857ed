//! XML files of VTK: pieces of arrays of any type, inline or appended, packed or not.

use std::io::Write as _;

use arbitrary::{Arbitrary, Result, Unstructured};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::{Number, list};

const TYPES: [&str; 10] =
    ["Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64"];
const SETS: [&str; 2] = ["PolyData", "UnstructuredGrid"];
const LISTS: [&str; 4] = ["Polys", "Strips", "Cells", "Lines"];
const HEADERS: [&str; 3] = ["UInt32", "UInt64", "UInt8"];
const ORDERS: [&str; 2] = ["LittleEndian", "BigEndian"];

/// The bytes of a file.
#[derive(Debug)]
pub struct VtkFile(pub Vec<u8>);

impl<'a> Arbitrary<'a> for VtkFile {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let (set, header, order) = (data.choose(&SETS)?, data.choose(&HEADERS)?, data.choose(&ORDERS)?);
        let is_packed: bool = data.arbitrary()?;
        let mut pieces = String::new();
        for _ in 0..data.int_in_range(1..=2)? {
            let counts = [Number::arbitrary(data)?.0, Number::arbitrary(data)?.0];
            let points = array(data, "Points", 3)?;
            let cells = data.choose(&LISTS)?;
            let lists = ["connectivity", "offsets", "types", "faces"];
            let lists = lists.map(|name| array(data, name, 1)).into_iter().collect::<Result<String>>()?;
            let values = array(data, "cost", 1)?;
            pieces += &format!(
                "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\" NumberOfPolys=\"{}\"><Points>{points}</Points>\
                 <{cells}>{lists}</{cells}><PointData>{values}</PointData></Piece>",
                counts[0], counts[1], counts[1]
            );
        }
        let compressor = if is_packed { " compressor=\"vtkZLibDataCompressor\"" } else { "" };
        let head = format!(
            "<VTKFile type=\"{set}\" version=\"1.0\" byte_order=\"{order}\" header_type=\"{header}\"{compressor}><{set}>{pieces}</{set}>\
             <AppendedData encoding=\"raw\">_"
        );
        let appended = data.bytes(data.len())?;
        Ok(Self([head.as_bytes(), appended, b"</AppendedData></VTKFile>"].concat()))
    }
}

fn array(data: &mut Unstructured, name: &str, components: u8) -> Result<String> {
    let kind = data.choose(&TYPES)?;
    let start = format!("<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\"");
    Ok(match data.int_in_range(0..=3)? {
        0 => format!("{start} format=\"appended\" offset=\"{}\"/>", Number::arbitrary(data)?.0),
        1 => {
            let values = list::<Number>(data)?;
            let bytes: Vec<u8> = values.iter().flat_map(|number| (number.0 as u32).to_le_bytes()).collect();
            let packed = packed(data, &bytes)?;
            format!("{start} format=\"binary\">{}</DataArray>", BASE64_STANDARD.encode(packed))
        }
        _ => {
            let words: Vec<String> = list::<Number>(data)?.iter().map(|number| number.0.to_string()).collect();
            format!("{start} format=\"ascii\">{}</DataArray>", vec![words.join(" "); usize::from(components)].join(" "))
        }
    })
}

/// With a header of one block, which may lie.
fn packed(data: &mut Unstructured, bytes: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).expect("room in memory");
    let packed = encoder.finish().expect("room in memory");
    let says = |data: &mut Unstructured, truth: usize| {
        let lie = Number::arbitrary(data)?.0 as u32;
        Ok(if data.ratio(1, 8)? { lie } else { truth as u32 })
    };
    let header = [says(data, 1)?, says(data, bytes.len())?, says(data, 0)?, says(data, packed.len())?];
    Ok([header.into_iter().flat_map(u32::to_le_bytes).collect(), packed].concat())
}
