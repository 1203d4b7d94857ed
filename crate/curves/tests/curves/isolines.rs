//! Isolines, strips, sheets and their files.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_curves::write::View;
use heatwalk_curves::{Error, Field, Isolines, Kind, Levels, Sheet, Strips, write};
use heatwalk_shapes as shapes;
use heatwalk_surface::{Soup, Unit};

use super::{area, field, plane_area, tube};

fn trace(field: &Field, values: &[f64]) -> Isolines {
    Isolines::trace(field, &Levels::at(values).unwrap())
}

fn triangle(distances: [f64; 3]) -> Field {
    Field::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]], distances.to_vec()).unwrap()
}

#[test]
fn isolines_of_a_linear_function_are_straight_across_the_plane() {
    let field = field(&shapes::grid(7, 5), |position| position.x);
    let traced = trace(&field, &[0.25, 0.6]);
    for (isoline, value) in traced.isolines.iter().zip([0.25, 0.6]) {
        assert_eq!(isoline.curves.len(), 1);
        assert!(!isoline.curves[0].is_closed);
        assert!((isoline.length - 1.0).abs() < 1e-14);
        assert!((isoline.enclosed_area - value).abs() < 1e-14);
        assert!(isoline.curves[0].points.iter().all(|point| (point.x - value).abs() < 1e-15));
    }
}

#[test]
fn an_isoline_on_a_sphere_is_a_parallel() {
    let soup = shapes::icosphere(6);
    let field = field(&soup, |position| position.normalize().z.acos());
    for value in [0.3, 1.0, PI / 2.0, 2.5] {
        let [isoline] = &trace(&field, &[value]).isolines[..] else { panic!("one level") };
        let [curve] = &isoline.curves[..] else { panic!("one curve, not {}", isoline.curves.len()) };
        assert!(curve.is_closed && curve.triangles.len() == curve.points.len());
        // Edges are at most 0.02 long; linear interpolation and chords are off by their squares.
        assert!((isoline.length / (TAU * value.sin()) - 1.0).abs() < 2e-3, "length {}", isoline.length);
        assert!((isoline.enclosed_area / (TAU * (1.0 - value.cos())) - 1.0).abs() < 2e-3);
        // Larger distances, to the south, are on the left: westward seen from outside.
        let turning: f64 = curve.segments().map(|[from, to]| from.x * to.y - from.y * to.x).sum();
        assert!(turning < 0.0);
    }
}

#[test]
fn a_vertex_at_the_value_counts_as_farther_and_gives_no_point_twice() {
    // Every vertex of a row of the grid is at the value.
    let field = field(&shapes::grid(8, 8), |position| position.x);
    let [isoline] = &trace(&field, &[0.5]).isolines[..] else { panic!("one level") };
    let [curve] = &isoline.curves[..] else { panic!("one curve") };
    assert_eq!(curve.points.len(), 9);
    assert_eq!(isoline.length, 1.0);
    assert_eq!(isoline.enclosed_area, 0.5);
    // A corner that is the farthest place is a point, which is no curve.
    assert!(trace(&triangle([0.0, 0.0, 1.0]), &[1.0]).isolines[0].curves.is_empty());
    assert_eq!(trace(&triangle([0.0, 1.0, 1.0]), &[1.0]).isolines[0].curves.len(), 1);
    assert!(trace(&triangle([1.0, 1.0, 1.0]), &[1.0]).isolines[0].curves.is_empty());
}

#[test]
fn curves_are_a_component_each_and_closed_as_rings_are() {
    let field = field(&shapes::torus(1.0, 0.3, 40, 20), |position| position.x + 2.0);
    let counts = |value: f64| trace(&field, &[value]).isolines[0].curves.iter().filter(|curve| curve.is_closed).count();
    // A plane cuts a torus once at its sides and twice through its hole.
    assert_eq!([counts(0.8), counts(2.01), counts(3.2)], [1, 2, 1]);
}

#[test]
fn what_is_not_reached_has_no_isolines_and_no_strips() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)];
    let field = Field::new(positions, vec![[0, 1, 2], [1, 3, 2]], vec![0.0, 1.0, 1.0, f64::INFINITY]).unwrap();
    let [isoline] = &trace(&field, &[0.5]).isolines[..] else { panic!("one level") };
    assert_eq!((isoline.curves.len(), isoline.enclosed_area), (1, 0.125));
    let strips = Strips::cut(&field, &Levels::at(&[0.5]).unwrap()).unwrap();
    assert!((area(&strips.positions, &strips.triangles) - 0.5).abs() < 1e-15);
}

#[test]
fn curves_end_where_three_triangles_share_an_edge() {
    // Three wings on the edge from 0 to 1.
    let positions = vec![DVec3::ZERO, DVec3::Z, DVec3::X, DVec3::Y, -DVec3::X];
    let field = Field::new(positions, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]], vec![0.0, 1.0, 0.0, 0.0, 0.0]).unwrap();
    let [isoline] = &trace(&field, &[0.5]).isolines[..] else { panic!("one level") };
    assert_eq!(isoline.curves.len(), 3);
    let middle = DVec3::new(0.0, 0.0, 0.5);
    for curve in &isoline.curves {
        assert!(!curve.is_closed && curve.points.contains(&middle));
    }
}

#[test]
fn strips_fit_together_keep_the_area_and_lie_between_their_values() {
    let soup = shapes::icosphere(4);
    let field = field(&soup, |position| position.normalize().z.acos());
    let levels = Levels::counted(40, field.largest()).unwrap();
    let strips = Strips::cut(&field, &levels).unwrap();
    let whole = area(field.positions(), field.triangles());
    assert!((area(&strips.positions, &strips.triangles) / whole - 1.0).abs() < 1e-12);
    let mut sides: HashMap<(u32, u32), u32> = HashMap::new();
    for corners in &strips.triangles {
        (0..3).for_each(|k| *sides.entry((corners[k], corners[(k + 1) % 3])).or_default() += 1);
    }
    assert!(sides.iter().all(|(&(a, b), &count)| count == 1 && sides.get(&(b, a)) == Some(&1)), "watertight");
    let isolines = Isolines::trace(&field, &levels);
    let mut nearer = 0.0;
    for (strip, range) in strips.ranges.iter().enumerate() {
        let [low, high] = strips.bounds(strip);
        for &corner in strips.triangles[range.clone()].as_flattened() {
            let distance = strips.distances[corner as usize];
            assert!(low.is_none_or(|low| low <= distance) && high.is_none_or(|high| distance <= high));
        }
        nearer += area(&strips.positions, &strips.triangles[range.clone()]);
        if let Some(isoline) = isolines.isolines.get(strip) {
            assert!((nearer / isoline.enclosed_area - 1.0).abs() < 1e-9, "strip {strip}");
        }
    }
}

#[test]
fn a_triangle_of_one_value_is_in_one_strip() {
    let strips = Strips::cut(&triangle([1.0, 1.0, 1.0]), &Levels::at(&[1.0]).unwrap()).unwrap();
    assert_eq!(strips.ranges, [0..0, 0..1]);
}

#[test]
fn a_ring_around_a_tube_unrolls_to_a_rectangle() {
    let (around, height) = (24, 3.0);
    let field = field(&tube(around, 9, height), |position| position.z);
    let strips = Strips::cut(&field, &Levels::at(&[0.7, 1.9]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    assert_eq!(sheet.planes.len(), 3);
    let girth = f64::from(around) * 2.0 * (PI / f64::from(around)).sin();
    for (plane, width) in sheet.planes.iter().zip([0.7, 1.2, 1.1]) {
        let [outline] = &plane.loops[..] else { panic!("a ring is cut open into one loop") };
        let next = |index: usize| outline[(index + 1) % outline.len()];
        let doubled: f64 = outline.iter().enumerate().map(|(index, point)| point.perp_dot(next(index))).sum();
        assert!((0.5 * doubled - girth * width).abs() < 1e-9, "counter-clockwise, with the area of the ring");
        let inside = |point: &glam::DVec2| point.cmpge(glam::DVec2::ZERO).all() && point.cmple(sheet.size).all();
        assert!(outline.iter().all(inside));
    }
}

#[test]
fn what_is_curved_is_refused_with_its_largest_defect() {
    let field = field(&shapes::icosphere(2), |position| position.normalize().z.acos());
    let strips = Strips::cut(&field, &Levels::at(&[1.0]).unwrap()).unwrap();
    let Err(Error::NotDevelopable(refused)) = Sheet::unroll(&field, &strips) else {
        panic!("a cap of a sphere is curved")
    };
    assert!(refused.largest > 0.05 && refused.total >= refused.largest);
    assert!(refused.to_string().contains(&format!("{:.4} rad at vertex {}", refused.largest, refused.vertex)));
}

#[test]
fn a_strip_whose_source_is_the_tip_of_a_cone_is_cut_open_to_its_rim() {
    // Facets around a tip, in two rows, with a source at the tip, whose distance begins at 0.5.
    let (around, slant) = (12, 2.0_f64.sqrt());
    let ring = |radius: f64| {
        (0..around).map(move |index| {
            let angle = TAU * f64::from(index) / f64::from(around);
            DVec3::new(radius * angle.cos(), radius * angle.sin(), -radius)
        })
    };
    let positions: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain(ring(0.5)).chain(ring(1.0)).collect();
    let facet = |index: u32| {
        let [a, b] = [1 + index, 1 + (index + 1) % around];
        [[0, a, b], [a, a + around, b + around], [a, b + around, b]]
    };
    let soup = Soup::single("cone", positions, (0..around).flat_map(facet).collect());
    let field = field(&soup, |position| 0.5 + slant * position.truncate().length());
    let strips = Strips::cut(&field, &Levels::at(&[0.5 + 0.8 * slant]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    assert!(sheet.left_out.is_empty());
    assert_eq!(sheet.planes.iter().map(|plane| (plane.strip, plane.loops.len())).collect::<Vec<_>>(), [(0, 1), (1, 1)]);
    for plane in &sheet.planes {
        let whole = area(&strips.positions, &strips.triangles[strips.ranges[plane.strip].clone()]);
        assert!((plane_area(&plane.loops) - whole).abs() < 1e-12);
    }
}

#[test]
fn what_is_curved_is_left_out_of_the_sheet_and_named() {
    let field = field(&shapes::icosphere(2), |position| position.normalize().z.acos());
    let strips = Strips::cut(&field, &Levels::at(&[1.0, 1.01]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    assert!(!sheet.planes.is_empty() && sheet.planes.iter().all(|plane| plane.strip == 1));
    assert_eq!(sheet.strips_left_out(), [0, 2]);
    let drawn: f64 = sheet.planes.iter().map(|plane| plane_area(&plane.loops)).sum();
    assert!((drawn / area(&strips.positions, &strips.triangles[strips.ranges[1].clone()]) - 1.0).abs() < 1e-9);
    // A vertex of it alone is curved too much.
    assert_eq!(sheet.flat_spacing(&field, &strips), None);
    assert!(sheet.left_out[0].is_by_one_vertex() && sheet.left_out[0].to_string().contains("no spacing changes that"));
}

#[test]
fn a_spacing_is_found_by_which_all_strips_are_flat() {
    // A bowl of Gaussian curvature 0.048 at most, on the unit square.
    let mut soup = shapes::grid(40, 40);
    soup.positions.iter_mut().for_each(|position| position.y = 0.11 * position.length_squared());
    let field = field(&soup, |position| position.x);
    let unrolled = |spacing: f64| {
        let strips = Strips::cut(&field, &Levels::spaced(spacing, field.largest()).unwrap()).unwrap();
        let sheet = Sheet::unroll(&field, &strips).unwrap();
        let spacing = sheet.flat_spacing(&field, &strips);
        (sheet.left_out.len(), spacing)
    };
    // The last strip is narrow and flat.
    let (left_out, spacing) = unrolled(0.49);
    assert_eq!((left_out, spacing), (2, Some(0.2)));
    assert_eq!(unrolled(0.2), (0, None));
}

/// Whole numbers and others of a PDF: the sides of the page, in millimeters, what is written, and the segments of all lines, in
/// millimeters from its upper left corner. Checks that objects are where the table says.
fn read_pdf(bytes: &[u8]) -> ([f64; 2], String, Vec<Vec<[f64; 2]>>) {
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    let (_, table) = text.split_once("xref\n0 6\n").unwrap();
    for (number, row) in table.lines().skip(1).take(5).enumerate() {
        let at: usize = row.split(' ').next().unwrap().parse().unwrap();
        assert!(text[at..].starts_with(&format!("{} 0 obj\n", number + 1)));
    }
    let start: usize = text.rsplit("startxref\n").next().unwrap().lines().next().unwrap().parse().unwrap();
    assert!(text[start..].starts_with("xref\n"));
    let between = |begin: &str, end: &str| text.split_once(begin).unwrap().1.split_once(end).unwrap().0.to_owned();
    let numbers = |text: &str| text.split(' ').map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
    let [_, _, width, height] = numbers(&between("/MediaBox [", "]"))[..] else { panic!("a box has four numbers") };
    let length: usize = between("/Length ", " ").parse().unwrap();
    let content = between("stream\n", "endstream");
    assert_eq!(content.len(), length);
    let drawn = content.split(" w 1 j 1 J\n").nth(1).unwrap();
    let (mut lines, mut last) = (Vec::new(), Vec::new());
    for token in drawn.split_whitespace() {
        match token {
            "m" => lines.push(vec![[last[0], last[1]]]),
            "l" => lines.last_mut().unwrap().push([last[0], last[1]]),
            "s" | "S" => {}
            number => {
                last.push(number.parse::<f64>().unwrap());
                continue;
            }
        }
        last.clear();
    }
    ([width, height].map(|side| side * 25.4 / 72.0), between("Td (", ")"), lines)
}

#[test]
fn a_pdf_is_at_true_scale_with_a_ruler() {
    let field = field(&shapes::grid(2, 2), |position| position.x);
    let isolines = trace(&field, &[0.5]);
    let view = View::from_direction(&field, DVec3::Y, DVec3::Z).unwrap();
    let read = |unit| read_pdf(&write::pdf(&isolines, &field, &view, unit));
    let (page, words, lines) = read(Unit::Meter);
    // The picture with its margins of 3 %, those of the page, and the foot.
    assert!((page[0] - 1080.0).abs() < 1e-6 && (page[1] - 1096.0).abs() < 1e-6, "{page:?}");
    assert_eq!(words, "100 mm     1 : 1");
    let length = |line: &[[f64; 2]]| -> f64 {
        line.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])).sum()
    };
    assert!((length(&lines[0]) - 100.0).abs() < 1e-9, "the ruler");
    // Its ticks, and the isoline, which is 1 m long.
    assert_eq!(lines.len(), 1 + 11 + 1);
    assert!((length(&lines[12]) - 1000.0).abs() < 1e-3, "{}", length(&lines[12]));

    // What is larger than a page is drawn at a rounded scale, and what is smaller has the ruler all the same.
    let (page, words, lines) = read(Unit::Kilometer);
    assert_eq!(words, "100 mm     1 : 500");
    assert!((length(&lines[12]) - 2000.0).abs() < 1e-3 && page[0] < 5080.0);
    let (page, _, lines) = read(Unit::Millimeter);
    assert!((page[0] - 120.0).abs() < 1e-9 && (length(&lines[12]) - 1.0).abs() < 1e-3);

    let strips = Strips::cut(&field, &Levels::at(&[0.5]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    let (_, _, lines) = read_pdf(&write::sheet_pdf(&sheet, Unit::Meter));
    let around: f64 = lines[12..].iter().map(|line| length(&[&line[..], &line[..1]].concat())).sum();
    assert!((around - 2.0 * 3000.0).abs() < 1e-2, "two rectangles of 0.5 by 1: {around}");
}

#[test]
fn levels_are_multiples_of_a_spacing_or_equal_shares() {
    assert_eq!(Levels::spaced(0.5, 2.0).unwrap().values(), [0.5, 1.0, 1.5]);
    assert_eq!(Levels::counted(3, 2.0).unwrap().values(), [0.5, 1.0, 1.5]);
    assert_eq!(Levels::at(&[3.0, 1.0, 3.0]).unwrap().values(), [1.0, 3.0]);
    for bad in [0.0, -1.0, f64::NAN, 2.0] {
        assert!(matches!(Levels::spaced(bad, 2.0), Err(Error::NoLevel { .. })), "{bad}");
    }
    assert!(matches!(Levels::spaced(1e-9, 2.0), Err(Error::TooManyLevels { .. })));
    assert!(matches!(Levels::counted(0, 2.0), Err(Error::NoLevel { .. })));
    assert!(matches!(Levels::at(&[f64::INFINITY]), Err(Error::NoLevel { .. })));
}

#[test]
fn rejects_fields_that_do_not_fit() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let new =
        |triangle, distances: &[f64]| Field::new(positions.clone(), vec![triangle], distances.to_vec()).unwrap_err();
    assert!(matches!(new([0, 1, 2], &[0.0]), Error::CountMismatch { vertices: 3, distances: 1 }));
    assert!(matches!(new([0, 1, 3], &[0.0; 3]), Error::IndexOutOfRange { triangle: 0, vertex: 3, vertices: 3 }));
    assert!(matches!(new([0, 1, 2], &[0.0, f64::NAN, 0.0]), Error::NotANumber { vertex: 1, what: "distance" }));
}

/// Two squares that face Z, one of them behind the right half of the other.
fn one_behind_the_other() -> Field {
    let square = |left: f64, z: f64| {
        [(left, 0.0), (2.0, 0.0), (2.0, 2.0), (left, 2.0)].map(|(x, y)| DVec3::new(x, y, z)).to_vec()
    };
    let positions = [square(0.0, 0.0), square(1.0, 1.0)].concat();
    let soup = Soup::single("squares", positions, vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]);
    field(&soup, |position| position.y)
}

/// The length of all lines of a picture, in pixels.
fn drawn_length(svg: &[u8]) -> f64 {
    let text = String::from_utf8(svg.to_vec()).unwrap();
    let mut length = 0.0;
    for data in text.split("d=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
        let mut at = (0.0, 0.0);
        for command in data.split_inclusive(['M', 'L']).collect::<Vec<_>>().windows(2) {
            let numbers = command[1].trim_end_matches(['M', 'L']);
            let (x, y) = numbers.split_once(' ').unwrap();
            let to: (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
            if command[0].ends_with('L') {
                length += (to.0 - at.0).hypot(to.1 - at.1);
            }
            at = to;
        }
    }
    length
}

#[test]
fn what_is_behind_the_surface_is_not_in_a_picture() {
    let field = one_behind_the_other();
    let isolines = trace(&field, &[1.1]);
    let seen = |toward_eye: DVec3| {
        let view = View::from_direction(&field, toward_eye, DVec3::Y).unwrap();
        drawn_length(&write::svg(&isolines, &field, &view, None))
    };
    // Of the square behind the left half is seen, of the other one all; the picture is 2.12 wide, with its margins.
    let whole = 2.0 * 1000.0 / 2.12;
    // The end of what is seen is found to a thousandth of a fifth of a segment, and written to a thousandth of a pixel.
    assert!((seen(DVec3::Z) - whole).abs() < 0.5, "{} of {whole}", seen(DVec3::Z));
    assert_eq!(seen(DVec3::NEG_Z), 0.0, "the insides of both");
    // From the side that the front square leaves open, the picture is 1/√2 (2 + 1) wide, and nothing is hidden.
    let aside = 3.0 / 2.0_f64.sqrt() * 1000.0 / (3.0 / 2.0_f64.sqrt() + 0.06 * (3.0 / 2.0_f64.sqrt()));
    let oblique = seen(DVec3::new(-1.0, 0.0, 1.0));
    assert!((oblique - aside).abs() < 0.5, "{oblique} of {aside}");
}

#[test]
fn a_girth_is_called_so_in_files() {
    let girth = Isolines { kind: Kind::Girth, ..trace(&one_behind_the_other(), &[1.1]) };
    for file in [write::obj(&girth, None), write::dxf(&girth, None), write::glb(&girth)] {
        let text = String::from_utf8_lossy(&file).to_lowercase();
        assert!(text.contains("girth") && !text.contains("isoline"));
    }
}

#[test]
fn files_say_the_unit_of_their_lengths() {
    let field = one_behind_the_other();
    let isolines = trace(&field, &[1.1]);
    let strips = Strips::cut(&field, &Levels::at(&[1.1]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();

    let inches = Some(Unit::Inch);
    assert!(text(write::csv(&isolines, inches)).starts_with("curve,value (in),closed,x (in),y (in),z (in)\n"));
    assert!(text(write::csv(&isolines, None)).starts_with("curve,value,closed,x,y,z\n"));
    for write in [write::obj(&isolines, inches), write::strips_obj(&strips, inches)] {
        assert!(text(write).contains("\n# lengths in in\n"));
    }
    assert!(!text(write::obj(&isolines, None)).contains("lengths"));
    for file in [write::dxf(&isolines, inches), write::sheet_dxf(&sheet, &strips, inches)] {
        assert!(text(file).contains("  9\n$INSUNITS\n 70\n1\n"));
    }
    assert!(!text(write::dxf(&isolines, None)).contains("$INSUNITS"));

    // The picture is 2.12 wide, with its margins; in pixels where nothing says how long that is.
    let view = View::from_direction(&field, DVec3::Z, DVec3::Y).unwrap();
    let width = |svg: Vec<u8>| text(svg).split("width=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    let millimeters = |svg: Vec<u8>| width(svg).strip_suffix("mm").unwrap().parse::<f64>().unwrap();
    assert!((millimeters(write::svg(&isolines, &field, &view, inches)) - 2.12 * 25.4).abs() < 1e-9);
    assert!((millimeters(write::svg(&isolines, &field, &view, Some(Unit::Meter))) - 2120.0).abs() < 1e-9);
    assert!((width(write::svg(&isolines, &field, &view, None)).parse::<f64>().unwrap() - 1000.0).abs() < 1e-9);
    assert!((millimeters(write::sheet_svg(&sheet, &strips, inches)) - sheet.size.x * 25.4).abs() < 1e-9);
    // Programs that pass over the unit of the width read the same millimeters.
    for svg in [write::svg(&isolines, &field, &view, inches), write::sheet_svg(&sheet, &strips, inches)] {
        let svg = text(svg);
        let side = |begin: &str, end| svg.split(begin).nth(1).unwrap().split(end).next().unwrap().to_owned();
        assert_eq!(side("viewBox=\"0 0 ", ' '), side("width=\"", 'm'));
    }
    let drawn = drawn_length(&write::svg(&isolines, &field, &view, inches));
    assert!((drawn / drawn_length(&write::svg(&isolines, &field, &view, None)) - 0.00212 * 25.4).abs() < 1e-6);

    let ply = |unit| write::with_ply_comment(b"ply\nformat ascii 1.0\nelement vertex 0\n\n\n".to_vec(), unit);
    assert_eq!(text(ply(inches)), "ply\nformat ascii 1.0\ncomment lengths in in\nelement vertex 0\n\n\n");
    assert_eq!(text(ply(None)), "ply\nformat ascii 1.0\nelement vertex 0\n\n\n");
}
