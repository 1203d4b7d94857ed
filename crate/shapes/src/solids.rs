//! Closed solids of which assemblies are made.

use std::collections::HashMap;
use std::f64::consts::TAU;

use glam::{DAffine3, DVec2, DVec3};
use heatwalk_surface::Soup;

/// Adds a box with rounded edges about the origin, half as large as `half` in each direction, as the transform places it.
/// `spacing` is the length of an edge.
pub fn add_box(soup: &mut Soup, half: DVec3, rounding: f64, spacing: f64, place: DAffine3) {
    let steps = (2.0 * half / spacing).ceil().max(DVec3::ONE).as_ivec3();
    let core = half - rounding;
    let mut numbers: HashMap<[i32; 3], u32> = HashMap::new();
    let mut vertex = |at: [i32; 3]| {
        *numbers.entry(at).or_insert_with(|| {
            let share = DVec3::new(at[0].into(), at[1].into(), at[2].into()) / steps.as_dvec3();
            let on_box = (2.0 * share - 1.0) * half;
            let inside = on_box.clamp(-core, core);
            soup.positions.push(place.transform_point3(inside + rounding * (on_box - inside).normalize_or_zero()));
            soup.positions.len() as u32 - 1
        })
    };
    let counts = steps.to_array();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (side, level) in [(0, 0), (1, counts[axis])] {
            for i in 0..counts[u] {
                for j in 0..counts[v] {
                    let mut corner = |a: i32, b: i32| {
                        let mut at = [0; 3];
                        (at[axis], at[u], at[v]) = (level, i + a, j + b);
                        vertex(at)
                    };
                    let mut square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if side == 0 {
                        square.reverse();
                    }
                    let [a, b, c, d] = square;
                    soup.triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
}

/// Adds what a profile sweeps around the y axis: corners as distance from the axis and height, upward, the first and the last
/// on the axis. `spacing` is the length of an edge.
pub fn add_turned(soup: &mut Soup, profile: &[DVec2], spacing: f64, place: DAffine3) {
    let mut rings = vec![profile[0]];
    for side in profile.windows(2) {
        let steps = (side[0].distance(side[1]) / spacing).ceil().max(1.0) as u32;
        rings.extend((1..=steps).map(|step| side[0].lerp(side[1], f64::from(step) / f64::from(steps))));
    }
    let widest = rings.iter().map(|ring| ring.x).fold(0.0, f64::max);
    let sectors = ((TAU * widest / spacing).ceil() as u32).max(8);
    let mut add = |point: DVec3| {
        soup.positions.push(place.transform_point3(point));
        soup.positions.len() as u32 - 1
    };
    let bottom = add(DVec3::new(0.0, rings[0].y, 0.0));
    let top = add(DVec3::new(0.0, rings[rings.len() - 1].y, 0.0));
    let middle = &rings[1..rings.len() - 1];
    let first = top + 1;
    for ring in middle {
        for sector in 0..sectors {
            let (sine, cosine) = (TAU * f64::from(sector) / f64::from(sectors)).sin_cos();
            add(DVec3::new(ring.x * cosine, ring.y, -ring.x * sine));
        }
    }
    let at = |ring: usize, sector: u32| first + ring as u32 * sectors + sector % sectors;
    let last = middle.len() - 1;
    for sector in 0..sectors {
        soup.triangles.push([bottom, at(0, sector + 1), at(0, sector)]);
        for ring in 0..last {
            let [a, b, c, d] = [at(ring, sector), at(ring, sector + 1), at(ring + 1, sector + 1), at(ring + 1, sector)];
            soup.triangles.extend([[a, b, c], [a, c, d]]);
        }
        soup.triangles.push([at(last, sector), at(last, sector + 1), top]);
    }
}

/// The profile of a cylinder with a rounded rim, from −`half` to `half`.
pub fn cylinder(radius: f64, half: f64) -> Vec<DVec2> {
    let rim = 0.3 * radius.min(half);
    let arc = |from: f64, center: DVec2| {
        (0..=4).map(move |step| center + rim * DVec2::from_angle((from + f64::from(step) / 4.0) * TAU / 4.0))
    };
    let lower = arc(-1.0, DVec2::new(radius - rim, rim - half));
    let upper = arc(0.0, DVec2::new(radius - rim, half - rim));
    [DVec2::new(0.0, -half)].into_iter().chain(lower).chain(upper).chain([DVec2::new(0.0, half)]).collect()
}

/// The profile of a ball.
pub fn ball(radius: f64, steps: u32) -> Vec<DVec2> {
    let angle = |step: u32| TAU / 2.0 * f64::from(step) / f64::from(steps);
    let mut profile: Vec<DVec2> =
        (0..=steps).map(|step| radius * DVec2::new(angle(step).sin(), -angle(step).cos())).collect();
    // The poles are on the axis, to the last digit.
    (profile[0].x, profile[steps as usize].x) = (0.0, 0.0);
    profile
}
