//! Isolines of distances that are known everywhere are as long as the curves themselves.

use std::convert::Infallible;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;
use heatwalk_curves::{Field, Isolines, Levels, MOST_ROUNDS, Places, Refined, Strips};
use heatwalk_shapes as shapes;

use super::{area, field};

/// Divides a field along isolines of a distance that is known everywhere in space; how many places were asked for.
fn refined(field: &Field, levels: &[f64], distance: impl Fn(DVec3) -> f64) -> (Refined, usize) {
    let mut count = 0;
    let ask = |places: &Places| {
        count += places.triangles.len();
        let place = |(&triangle, weights): (&u32, &[f64; 3])| {
            let corners = field.triangles()[triangle as usize];
            distance((0..3).map(|k| weights[k] * field.positions()[corners[k] as usize]).sum())
        };
        Ok::<_, Infallible>(Some(places.triangles.iter().zip(&places.weights).map(place).collect()))
    };
    let Ok(found) = field.refined(&Levels::at(levels).unwrap(), MOST_ROUNDS, ask);
    (found, count)
}

#[test]
fn circles_of_a_plane_are_as_long_and_large_as_they_are() {
    for quads in [2, 5, 40] {
        let center = DVec3::new(0.5, 0.0, -0.5);
        let distance = |position: DVec3| position.distance(center);
        let coarse = field(&shapes::grid(quads, quads), distance);
        let levels = [0.1, 0.25, 0.4];
        let (found, count) = refined(&coarse, &levels, distance);
        assert!(found.is_true && count < 2000, "{count} places of {quads} quads");
        let traced = Isolines::trace(&found.field, &Levels::at(&levels).unwrap());
        for isoline in &traced.isolines {
            let (length, inside) = (TAU * isoline.value, PI * isoline.value.powi(2));
            assert!(
                (isoline.length / length - 1.0).abs() < 1e-3,
                "{quads}, {}: {}",
                isoline.value,
                isoline.length / length
            );
            assert!((isoline.enclosed_area / inside - 1.0).abs() < 2e-3, "{quads}, {}", isoline.value);
            assert!(isoline.curves.len() == 1 && isoline.curves[0].is_closed);
        }
        // In one piece still, with all of the area.
        let strips = Strips::cut(&found.field, &Levels::at(&levels).unwrap()).unwrap();
        assert!((area(&strips.positions, &strips.triangles) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn circles_around_the_corner_of_a_box_are_three_quarters() {
    // Three faces at the origin; beyond them circles go on as circles around it as long as they meet no other edge.
    let corner = |[u, v]: [f64; 2]| [DVec3::new(u, v, 0.0), DVec3::new(0.0, u, v), DVec3::new(v, 0.0, u)];
    let mut soup = shapes::grid(3, 3);
    let flat = soup.positions.clone();
    let faces = soup.triangles.clone();
    soup.positions.clear();
    soup.triangles.clear();
    for side in 0..3 {
        let first = soup.positions.len() as u32;
        soup.positions.extend(flat.iter().map(|position| corner([position.x, -position.z])[side]));
        soup.triangles.extend(faces.iter().map(|corners| corners.map(|corner| corner + first)));
    }
    let soup = heatwalk_surface::Soup::single("corner", soup.positions, soup.triangles);
    let coarse = field(&soup, DVec3::length);
    let (found, _) = refined(&coarse, &[0.3, 0.7], DVec3::length);
    for isoline in &Isolines::trace(&found.field, &Levels::at(&[0.3, 0.7]).unwrap()).isolines {
        assert!(found.is_true && isoline.curves.len() == 1 && isoline.curves[0].is_closed);
        assert!((isoline.length / (3.0 * FRAC_PI_2 * isoline.value) - 1.0).abs() < 1e-3);
        assert!((isoline.enclosed_area / (0.75 * PI * isoline.value.powi(2)) - 1.0).abs() < 2e-3);
    }
}

#[test]
fn a_distance_that_is_linear_is_asked_for_once() {
    // From a place far off the corner, nearly.
    let line = |position: DVec3| 3.0 + position.x - 1e-9 * position.z;
    let (found, count) = refined(&field(&shapes::grid(6, 6), line), &[3.2, 3.55, 4.0], line);
    assert!(found.is_true);
    // The level at the rim, which nothing is beyond, is no reason for more.
    assert_eq!(count, 107);
}

#[test]
fn what_is_not_known_stays_as_it_is() {
    let center = DVec3::new(0.5, 0.0, -0.5);
    let coarse = field(&shapes::grid(4, 4), |position| position.distance(center));
    let Ok(found) = coarse.refined(&Levels::at(&[0.3]).unwrap(), MOST_ROUNDS, |_| Ok::<_, Infallible>(None));
    assert!(!found.is_true);
    assert_eq!(found.field.triangles(), coarse.triangles());
}

#[test]
fn a_line_that_is_the_source_at_its_vertices_has_straight_isolines() {
    // Distance to the nearest of seven vertices on one side.
    let nearest = |position: DVec3| {
        let to = |index: i32| position.distance(DVec3::new(0.0, 0.0, -f64::from(index) / 6.0));
        (0..=6).map(to).fold(f64::INFINITY, f64::min)
    };
    let (found, count) = refined(&field(&shapes::grid(6, 6), nearest), &[0.25], nearest);
    assert_eq!((count, found.is_true), (6, false));
    let [isoline] = &Isolines::trace(&found.field, &Levels::at(&[0.25]).unwrap()).isolines[..] else { panic!("one") };
    assert!((isoline.length - 1.0).abs() < 1e-12);
}
