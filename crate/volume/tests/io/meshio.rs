//! What meshio, a reader of another program, finds in our files. HEATWALK_PYTHON names a Python that has it; python3 if not given.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use heatwalk_volume::io::write;

const SCRIPT: &str = "
import sys
import meshio
for name in sys.argv[1:]:
    mesh = meshio.read(name)
    print(mesh.points.tolist(), mesh.cells_dict['tetra'].tolist(), mesh.point_data['distance'].ravel().tolist())
";

#[test]
fn meshio_reads_what_is_written() {
    let python = std::env::var("HEATWALK_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let (soup, mut distance) = super::tetrahedra();
    // Gmsh's views leave out what is infinite, which meshio does not take.
    distance.iter_mut().for_each(|value| *value = value.min(100.0));
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("meshio");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("a.vtu"), write::vtu(&soup, Some(&distance))).unwrap();
    fs::write(folder.join("a.msh"), write::msh(&soup, Some(&distance))).unwrap();
    let output = Command::new(&python).current_dir(&folder).args(["-c", SCRIPT, "a.vtu", "a.msh"]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let points: Vec<[f64; 3]> = soup.positions.iter().map(|position| position.to_array()).collect();
    let expected = format!("{points:?} {:?} {distance:?}", soup.tetrahedra);
    let said = String::from_utf8(output.stdout).unwrap();
    // meshio may say more than what it is asked for.
    let read: Vec<&str> = said.lines().filter(|line| line.starts_with('[')).collect();
    assert_eq!(read, [&expected, &expected]);
}
