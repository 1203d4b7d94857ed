//! Decals by log maps that are known in closed form.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};
use heatwalk_curves::{Division, Field, Patch, decal};

use super::{area, tube};

/// The place of a part's corner on its surface.
fn place(surface: &Field, patch: &Patch, corner: usize) -> DVec3 {
    let corners = surface.triangles()[patch.triangle as usize].map(|vertex| surface.positions()[vertex as usize]);
    (0..3).map(|k| patch.corners[corner][k] * corners[k]).sum()
}

fn covered(surface: &Field, patches: &[Patch]) -> f64 {
    let corners: Vec<DVec3> = patches.iter().flat_map(|patch| [0, 1, 2].map(|k| place(surface, patch, k))).collect();
    let triangles: Vec<[u32; 3]> =
        (0..patches.len() as u32).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect();
    area(&corners, &triangles)
}

/// A square of 2, in squares of 0.1 that are cut along a diagonal.
fn plane() -> Field {
    let at = |i: u32, j: u32| DVec3::new(0.1 * f64::from(i) - 1.0, 0.1 * f64::from(j) - 1.0, 0.0);
    let positions: Vec<DVec3> = (0..21).flat_map(|j| (0..21).map(move |i| at(i, j))).collect();
    let square = |j: u32, i: u32| {
        let a = 21 * j + i;
        [[a, a + 1, a + 22], [a, a + 22, a + 21]]
    };
    let triangles = (0..20).flat_map(|j| (0..20).flat_map(move |i| square(j, i))).collect();
    Field::new(positions.clone(), triangles, vec![0.0; positions.len()]).unwrap()
}

/// The triangle around the middle, up to rounding.
fn start(surface: &Field, middle: DVec3) -> u32 {
    let to_middle = |&[a, b, c]: &[u32; 3]| {
        let sum: DVec3 = [a, b, c].map(|vertex| surface.positions()[vertex as usize]).into_iter().sum();
        (sum / 3.0).distance(middle)
    };
    let nearest = surface.triangles().iter().enumerate().min_by(|(_, a), (_, b)| to_middle(a).total_cmp(&to_middle(b)));
    nearest.unwrap().0 as u32
}

#[test]
fn on_a_plane_it_is_the_image() {
    let surface = plane();
    let (middle, half) = (DVec3::new(0.13, -0.21, 0.0), DVec2::new(0.55, 0.37));
    let (sin, cos) = 0.7_f64.sin_cos();
    let turned = |at: DVec3| DVec2::new(cos * at.x + sin * at.y, cos * at.y - sin * at.x);
    let coordinates: Vec<DVec2> = surface.positions().iter().map(|&at| turned(at - middle)).collect();
    let patches = decal(&surface, &coordinates, start(&surface, middle), half);
    assert!((covered(&surface, &patches) - 4.0 * half.x * half.y).abs() < 1e-12);
    for patch in &patches {
        for k in 0..3 {
            let at = turned(place(&surface, patch, k) - middle) / half;
            let image = DVec2::new(1.0 + at.x, 1.0 - at.y) / 2.0;
            assert!(patch.image[k].distance(image) < 1e-12, "{} for {image}", patch.image[k]);
            assert!(image.min_element() > -1e-12 && image.max_element() < 1.0 + 1e-12);
        }
    }
}

#[test]
fn it_ends_at_the_boundary_and_where_the_map_is_not_known() {
    let surface = plane();
    let middle = DVec3::new(0.85, 0.03, 0.0);
    let known = |at: DVec3| if at.y < 0.501 { (at - middle).truncate() } else { DVec2::NAN };
    let coordinates: Vec<DVec2> = surface.positions().iter().map(|&at| known(at)).collect();
    let patches = decal(&surface, &coordinates, start(&surface, middle), DVec2::splat(0.6));
    assert!((covered(&surface, &patches) - (0.15 + 0.6) * (0.47 + 0.6)).abs() < 1e-12);
}

#[test]
fn around_a_tube_it_ends_where_both_sides_meet() {
    let soup = tube(90, 40, 4.0);
    let surface = Field::new(soup.positions.clone(), soup.triangles.clone(), vec![0.0; soup.positions.len()]).unwrap();
    let middle = DVec3::new(1.0, 0.0, 2.0);
    let around = |at: DVec3| DVec2::new(at.y.atan2(at.x), at.z - middle.z);
    let coordinates: Vec<DVec2> = surface.positions().iter().map(|&at| around(at)).collect();
    let start = start(&surface, middle);
    let once = decal(&surface, &coordinates, start, DVec2::new(2.0 * PI, 1.5));
    let lateral = area(surface.positions(), surface.triangles()) / 4.0 * 3.0;
    let part = covered(&surface, &once) / lateral;
    // A row of facets is torn at most.
    assert!(part < 1.0 && part > 1.0 - 2.0 / 90.0, "{part}");
    let torn = once.iter().flat_map(|patch| patch.image.map(|a| patch.image.map(|b| (a - b).x.abs()))).flatten();
    assert!(torn.fold(0.0, f64::max) < 1.1 * TAU / 90.0 / (4.0 * PI) * 2.0);
}

#[test]
fn what_the_map_folds_is_left_out() {
    let surface = plane();
    let folded = |at: DVec3| DVec2::new(if at.x > 0.35 { 0.7 - at.x } else { at.x }, at.y);
    let coordinates: Vec<DVec2> = surface.positions().iter().map(|&at| folded(at)).collect();
    let patches = decal(&surface, &coordinates, start(&surface, DVec3::ZERO), DVec2::splat(0.9));
    let right = patches.iter().flat_map(|patch| [0, 1, 2].map(|k| place(&surface, patch, k).x)).fold(0.0, f64::max);
    assert!((0.3..0.401).contains(&right), "{right}");
    assert!(decal(&surface, &vec![DVec2::NAN; coordinates.len()], 0, DVec2::ONE).is_empty());
}

#[test]
fn divided_triangles_lie_in_theirs() {
    let positions = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(1.0, 3.0, 1.0), DVec3::new(0.0, -0.2, 0.0)];
    let triangles = [[0, 1, 2], [1, 0, 3]];
    let division = Division::of(&positions, &triangles, 0.3, 100_000);
    assert!((area(&division.positions, &division.triangles) - area(&positions, &triangles)).abs() < 1e-12);
    let corner = |vertex: u32| division.positions[vertex as usize];
    for (part, corners) in (0..).zip(&division.triangles) {
        let [a, b, c] = corners.map(corner);
        assert!(a.distance(b) <= 0.3 && b.distance(c) <= 0.3 && c.distance(a) <= 0.3);
        let weights = [0.5, 0.2, 0.3];
        let (origin, within) = division.place_in(part, weights);
        let whole: DVec3 = (0..3).map(|k| within[k] * positions[triangles[origin as usize][k] as usize]).sum();
        assert!(whole.distance(0.5 * a + 0.2 * b + 0.3 * c) < 1e-12);
        let (back, again) = division.part_at(origin, within).unwrap();
        assert_eq!(back, part);
        assert!((0..3).all(|k| (again[k] - weights[k]).abs() < 1e-9));
    }
    assert!(division.part_at(2, [1.0, 0.0, 0.0]).is_none());
    assert_eq!(Division::of(&positions, &triangles, 0.3, 2).triangles, triangles);
}
