//! Small files that claim, pack or repeat much are refused before they fill the memory.

#![cfg(not(target_arch = "wasm32"))]

#[path = "../../model/tests/allocated.rs"]
mod allocated;

use heatwalk_model::Error as FileError;
use heatwalk_model::io::Budget;
use heatwalk_volume::io::{self, Error, Result, TetFile};

use allocated::{GROWING, alone};

fn measured(name: &str, bytes: &[u8]) -> (Result<TetFile>, usize) {
    allocated::measured(|| io::read(name, bytes, &|_| None))
}

fn ints(numbers: &[i32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

#[test]
fn sections_of_medit_may_not_overlap() {
    let _alone = alone();
    // Each of many sections of tetrahedra begins a few bytes after the one before and has all that follows.
    const SECTIONS: i32 = 2000;
    let mut bytes = ints(&[1, 2]);
    for section in 0..SECTIONS {
        bytes.extend(ints(&[8, 8 + 12 * (section + 1), 5000]));
    }
    bytes.extend(ints(&[1, 2, 3, 4, 0].repeat(10_000)));
    let (read, peak) = measured("a.meshb", &bytes);
    let error = read.map(|file| file.soup.tetrahedra.len()).unwrap_err().to_string();
    assert!(error.contains("the section before goes on at byte"), "{error}");
    assert!(peak < 1 << 20, "{peak} bytes");
}

#[test]
fn arrays_that_share_their_bytes_count_each() {
    let _alone = alone();
    const POINTS: usize = 30_000;
    let arrays: String = (0..2000)
        .map(|name| format!("<DataArray type=\"UInt8\" Name=\"{name}\" format=\"appended\" offset=\"0\"/>"))
        .collect();
    let head = format!(
        "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt32\"><UnstructuredGrid>\
         <Piece><Points>{arrays}</Points></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_"
    );
    let bytes = [head.as_bytes(), &ints(&[POINTS as i32]), &vec![0; POINTS]].concat();
    let (read, peak) = measured("a.vtu", &bytes);
    let budget = Budget::of_file(bytes.len()).left();
    let refused = Error::File(FileError::OverBudget { size: bytes.len() as u64, budget });
    assert_eq!(read.map(|file| file.soup.tetrahedra.len()), Err(refused));
    assert!(peak < (GROWING * budget as f64) as usize + bytes.len(), "{peak} bytes of {budget}");
}

#[test]
fn counts_without_anything_behind_them_take_nothing() {
    let _alone = alone();
    let huge = 1_u64 << 62;
    let binary = [&ints(&[1, 4, 4])[..], &0_u64.to_le_bytes(), &huge.to_le_bytes(), &[0; 32]].concat();
    for (name, bytes) in [
        ("a.mesh", format!("MeshVersionFormatted 2 Dimension 3 Vertices {huge} 0 0 0 0").into_bytes()),
        ("a.mesh", format!("MeshVersionFormatted 2 Dimension 3 Tetrahedra {huge} 1 2 3 4 0").into_bytes()),
        ("a.meshb", binary),
        ("a.msh", format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{huge}\n1 0 0 0\n").into_bytes()),
        (
            "a.msh",
            format!("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {huge} 1 {huge}\n3 1 0 {huge}\n1\n").into_bytes(),
        ),
        ("a.msh", format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n{huge}\n1 4 0 1 2 3 4\n").into_bytes()),
    ] {
        let (read, peak) = measured(name, &bytes);
        assert!(read.is_err() && peak < 1 << 20, "{name}: {peak} bytes, {:?}", read.err());
    }
}
