//! What ezdxf and trimesh, readers of other programs, find in our files. HEATWALK_PYTHON names a Python that has them; python3
//! if not given.

#![cfg(feature = "peers")]

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use glam::DVec3;
use heatwalk_curves::{Field, Isolines, Levels, Strips, write};
use heatwalk_shapes as shapes;

const SCRIPT: &str = "
import ezdxf
import trimesh
drawing = ezdxf.readfile('a.dxf')
assert drawing.dxfversion == 'AC1009' and not drawing.audit().errors
def length(line):
    points = [vertex.dxf.location for vertex in line.vertices]
    points += points[:1] if line.is_closed else []
    return sum((b - a).magnitude for a, b in zip(points, points[1:]))
lines = list(drawing.modelspace().query('POLYLINE'))
assert all(line.is_3d_polyline for line in lines)
print(len(lines), sum(line.is_closed for line in lines), len({line.dxf.layer for line in lines}), sum(map(length, lines)))
curves = trimesh.load('a.glb')
# It takes all vertices of a primitive for one line.
print(len(curves.geometry), sum(len(curve.vertices) for curve in curves.geometry.values()))
strips = trimesh.load('a.obj', force='mesh', process=False)
print(strips.is_watertight, strips.area)
";

#[test]
fn others_read_what_is_written() {
    let python = std::env::var("HEATWALK_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let soup = shapes::torus(1.0, 0.4, 60, 30);
    let distances = soup.positions.iter().map(|position| (*position - DVec3::X).length()).collect();
    let area: f64 = soup
        .triangles
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| soup.positions[corner as usize]);
            0.5 * (b - a).cross(c - a).length()
        })
        .sum();
    let field = Field::new(soup.positions, soup.triangles, distances).unwrap();
    let levels = Levels::at(&[0.5, 1.0, 1.5]).unwrap();
    let isolines = Isolines::trace(&field, &levels);
    let curves: Vec<_> = isolines.isolines.iter().flat_map(|isoline| &isoline.curves).collect();
    let length: f64 = curves.iter().map(|curve| curve.length).sum();
    let closed = curves.iter().filter(|curve| curve.is_closed).count();

    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("peers");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("a.dxf"), write::dxf(&isolines)).unwrap();
    fs::write(folder.join("a.glb"), write::glb(&isolines)).unwrap();
    fs::write(folder.join("a.obj"), write::strips_obj(&Strips::cut(&field, &levels).unwrap())).unwrap();
    let output = Command::new(&python).current_dir(&folder).args(["-c", SCRIPT]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    let [dxf, glb, obj] = &said.lines().map(|line| line.split(' ').collect()).collect::<Vec<Vec<_>>>()[..] else {
        panic!("{said}")
    };
    let is_near = |text: &str, wanted: f64, error: f64| (text.parse::<f64>().unwrap() / wanted - 1.0).abs() < error;
    assert_eq!(dxf[..3], [curves.len().to_string(), closed.to_string(), "3".to_owned()]);
    assert!(is_near(dxf[3], length, 1e-12), "{said}");
    let points: usize = curves.iter().map(|curve| curve.points.len()).sum();
    assert_eq!(glb[..], ["3".to_owned(), points.to_string()]);
    assert!(obj[0] == "True" && is_near(obj[1], area, 1e-6), "{said}");
}
