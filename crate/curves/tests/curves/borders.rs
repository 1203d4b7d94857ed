//! Borders of cells against bisectors of the plane.

use std::convert::Infallible;

use glam::{DVec3, dvec3};
use heatwalk_curves::{Borders, Field, write};
use heatwalk_shapes as shapes;
use heatwalk_surface::Soup;

use super::field;

/// The nearest of some points, each with what it begins at.
fn nearest(sources: &[(DVec3, f64)], place: DVec3) -> Option<u32> {
    let of = |&(source, begin): &(DVec3, f64)| begin + source.distance(place);
    (0..sources.len() as u32).min_by(|&a, &b| of(&sources[a as usize]).total_cmp(&of(&sources[b as usize])))
}

/// The triangles in which sources are.
fn starts(field: &Field, sources: &[(DVec3, f64)]) -> Vec<u32> {
    let holds = |&triangle: &u32, place: DVec3| {
        let [a, b, c] = field.triangles()[triangle as usize].map(|corner| field.positions()[corner as usize]);
        let turned = |from: DVec3, to: DVec3| (to - from).cross(place - from).y;
        let turns = [turned(a, b), turned(b, c), turned(c, a)];
        turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
    };
    let count = field.triangles().len() as u32;
    (0..count).filter(|triangle| sources.iter().any(|&(source, _)| holds(triangle, source))).collect()
}

/// The areas of tiles by cell, all of which turn as their triangles do.
fn areas_of_tiles(field: &Field, borders: &Borders) -> Vec<f64> {
    let mut areas = vec![0.0; borders.areas.len()];
    for tile in &borders.tiles {
        let corners = field.triangles()[tile.triangle as usize].map(|corner| field.positions()[corner as usize]);
        let turned = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
        let places = tile.corners.map(|weights| (0..3).map(|k| weights[k] * corners[k]).sum::<DVec3>());
        let area = turned(places).dot(turned(corners).normalize()) / 2.0;
        assert!(area > -1e-12, "turned over");
        areas[tile.cell as usize] += area;
    }
    areas
}

fn traced(field: &Field, sources: &[(DVec3, f64)]) -> Borders {
    let of_vertices: Vec<Option<u32>> = field.positions().iter().map(|&place| nearest(sources, place)).collect();
    let ask = |triangle: u32, weights: [f64; 3]| {
        let corners = field.triangles()[triangle as usize];
        let place = (0..3).map(|k| weights[k] * field.positions()[corners[k] as usize]).sum();
        Ok::<_, Infallible>(nearest(sources, place))
    };
    let Ok(borders) = Borders::trace(field, (&of_vertices, sources.len()), &starts(field, sources), ask);
    for (of_tiles, area) in areas_of_tiles(field, &borders).iter().zip(&borders.areas) {
        assert!((of_tiles - area).abs() < 1e-9, "{of_tiles} of tiles, {area}");
    }
    for tile in &borders.tiles {
        let corners = field.triangles()[tile.triangle as usize].map(|corner| field.positions()[corner as usize]);
        let middle =
            (0..3).map(|k| tile.corners.iter().map(|weights| weights[k]).sum::<f64>() / 3.0 * corners[k]).sum();
        let [least, own] = [nearest(sources, middle), Some(tile.cell)].map(|cell| {
            let (source, begin) = sources[cell.expect("all are reached") as usize];
            begin + source.distance(middle)
        });
        // A border within a triangle is a chord between the places where it is followed.
        assert!(own - least < 1e-4, "a tile in another's cell");
    }
    borders
}

/// The square from 0 to 1 along X and to −1 along Z.
fn square(quads: u32) -> Field {
    field(&shapes::grid(quads, quads), |_| 0.0)
}

#[test]
fn a_border_is_the_bisector_whatever_the_triangles() {
    for quads in [1, 7, 90] {
        // One begins later, so that the border is a hyperbola.
        let sources = [(dvec3(0.31, 0.0, -0.42), 0.0), (dvec3(0.74, 0.0, -0.61), 0.12)];
        let borders = traced(&square(quads), &sources);
        let [border] = borders.curves.isolines.as_slice() else { panic!("one border") };
        let [curve] = border.curves.as_slice() else { panic!("in one piece") };
        assert!(!curve.is_closed && curve.points.len() > 50);
        for point in &curve.points {
            let [a, b] = sources.map(|(source, begin)| begin + source.distance(*point));
            assert!((a - b).abs() < 1e-6, "{point} by {}", a - b);
        }
        assert!((borders.areas.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        let length: f64 = curve.points.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
        assert!((curve.length - length).abs() < 1e-12 && (border.length - length).abs() < 1e-12);
        assert_eq!(curve.triangles.len() + 1, curve.points.len());
    }
}

#[test]
fn three_cells_meet_at_one_place_and_a_cell_within_one_triangle_is_whole() {
    let sources = [(dvec3(0.2, 0.0, -0.2), 0.0), (dvec3(0.8, 0.0, -0.3), 0.0), (dvec3(0.5, 0.0, -0.8), 0.0)];
    for quads in [1, 30] {
        let borders = traced(&square(quads), &sources);
        assert_eq!(borders.curves.isolines.len(), 3);
        let ends = borders.curves.isolines.iter().map(|border| {
            let [curve] = border.curves.as_slice() else { panic!("in one piece") };
            let [first, last] = [curve.points[0], curve.points[curve.points.len() - 1]];
            // The one inside.
            let is_inside = |place: DVec3| [place.x, -place.z].iter().all(|&at| at > 0.01 && at < 0.99);
            if is_inside(first) { first } else { last }
        });
        for end in ends {
            let away = sources.map(|(source, _)| source.distance(end));
            assert!(away.iter().all(|&other| (other - away[0]).abs() < 1e-5), "{end}");
        }
        assert!((borders.areas.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }
    // All four vertices of the square belong to another source than the one in the middle of a triangle.
    let far = (dvec3(0.5, 0.0, -0.5), 0.3);
    let borders = traced(&square(1), &[far, (dvec3(0.3, 0.0, -0.6), 0.1)]);
    assert!(borders.areas[1] > 0.01);
    let around = traced(&square(1), &[(dvec3(0.5, 3.0, -0.5), 0.0), (dvec3(0.5, 0.0, -0.5), 2.9)]);
    let [border] = around.curves.isolines.as_slice() else { panic!("one border") };
    assert!(border.curves.len() == 1 && border.curves[0].is_closed);
}

#[test]
fn what_is_not_reached_has_no_border_and_files_name_both_cells() {
    let grid = shapes::grid(2, 2);
    let count = grid.positions.len() as u32;
    let apart = grid.positions.iter().map(|&place| place + 5.0 * DVec3::X);
    let positions = grid.positions.iter().copied().chain(apart).collect();
    let others = grid.triangles.iter().map(|face| face.map(|corner| corner + count));
    let two = Soup::single("two", positions, grid.triangles.iter().copied().chain(others).collect());
    let field = field(&two, |_| 0.0);
    let sources = [(dvec3(0.0, 0.0, 0.0), 0.0), (dvec3(1.0, 0.0, -1.0), 0.0)];
    let here = |place: DVec3| nearest(&sources, place).filter(|_| place.x < 3.0);
    let of_vertices: Vec<Option<u32>> = field.positions().iter().map(|&place| here(place)).collect();
    let Ok(borders) = Borders::trace(&field, (&of_vertices, 2), &[], |triangle, weights| {
        let corners = field.triangles()[triangle as usize];
        Ok::<_, Infallible>(here((0..3).map(|k| weights[k] * field.positions()[corners[k] as usize]).sum()))
    });
    assert!((borders.areas[0] - 0.5).abs() < 1e-6 && (borders.areas[1] - 0.5).abs() < 1e-6);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    assert!(text(write::obj(&borders.curves, None)).contains("\ng border_0_1\n"));
    assert!(text(write::dxf(&borders.curves, None)).contains("\nBORDER_0_1\n"));
    let csv = text(write::csv(&borders.curves, None));
    assert!(csv.starts_with("curve,cell,other,closed,x,y,z\n0,0,1,0,"));
    let view = write::View::from_direction(&field, DVec3::Y, DVec3::NEG_Z).unwrap();
    assert!(text(write::svg(&borders.curves, &field, &view, None)).contains("<g id=\"border_0_1\">"));
    assert!(text(write::glb(&borders.curves).into_iter().filter(u8::is_ascii).collect()).contains("border_0_1"));
}
