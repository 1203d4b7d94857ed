//! Terrains among the files: height fields over a grid or in map coordinates.

use glam::{DVec2, DVec3};

/// Heights are at least and at most this share of the longer and of the shorter side of the ground: less is a picture, more a body.
const RELIEF: [f64; 2] = [0.002, 0.5];
/// Least share of the rectangle around the ground that triangles cover; more than all of it is more than one height a place.
const COVERED: [f64; 2] = [0.5, 1.001];
/// Least number of rows and of columns of a grid, and the least share of its places that have a vertex.
const GRID: (usize, f64) = (4, 0.5);

/// Whether triangles are a height field along Z whose vertices lie on a grid along X and Y, or, as maps have them, farther from the
/// origin than the ground is wide.
pub(crate) fn is_terrain(positions: &[DVec3], triangles: &[[u32; 3]]) -> bool {
    let position = |vertex: u32| positions.get(vertex as usize).copied();
    let triangles = || triangles.iter().filter_map(move |&[a, b, c]| Some([position(a)?, position(b)?, position(c)?]));
    let (low, high) = triangles()
        .flatten()
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)));
    let extent = high - low;
    let ground = extent.truncate();
    let [least, most] = RELIEF;
    let has_relief = extent.z >= least * ground.max_element() && extent.z <= most * ground.min_element();
    if !extent.is_finite() || !has_relief {
        return false;
    }
    // Seen from above, twice their area with its sign, in shares of the ground.
    let seen = triangles().map(|corners| {
        let [a, b, c] = corners.map(|point| (point - low).truncate() / ground);
        (b - a).perp_dot(c - a)
    });
    let (up, down) = seen.fold((0.0, 0.0), |(up, down), seen| (up + seen.max(0.0), down - seen.min(0.0)));
    let [least, most] = COVERED.map(|share| 2.0 * share);
    let is_field = f64::min(up, down) == 0.0 && (least..=most).contains(&f64::max(up, down));
    let is_map = || (0.5 * low + 0.5 * high).truncate().abs().max_element() > ground.max_element();
    is_field && (is_map() || is_grid(triangles().flatten().map(DVec3::truncate)))
}

/// Whether points lie on the places of a grid along both axes, on most of them.
fn is_grid(points: impl Iterator<Item = DVec2>) -> bool {
    // Numbers that are the same have the same bits, but for zeros.
    let mut places: Vec<[u64; 2]> = points.map(|point| (point + DVec2::ZERO).to_array().map(f64::to_bits)).collect();
    places.sort_unstable();
    places.dedup();
    let [columns, rows] = [0, 1].map(|axis| {
        let mut along: Vec<u64> = places.iter().map(|place| place[axis]).collect();
        along.sort_unstable();
        along.dedup();
        along.len()
    });
    let (least, share) = GRID;
    columns.min(rows) >= least && places.len() as f64 >= share * (columns as f64 * rows as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Mesh = (Vec<DVec3>, Vec<[u32; 3]>);

    /// A grid of hills over a ground from the origin on.
    fn hills(extent: DVec2, height: f64) -> Mesh {
        const N: u32 = 12;
        let at = |i: u32, j: u32| {
            let share = DVec2::new(f64::from(i), f64::from(j)) / f64::from(N);
            let hill = (5.0 * share.x).sin() * (4.0 * share.y).cos();
            (share * extent).extend(0.5 * height * hill)
        };
        let square = |i: u32, j: u32| {
            let a = j * (N + 1) + i;
            [[a, a + 1, a + N + 2], [a, a + N + 2, a + N + 1]]
        };
        let positions = (0..=N).flat_map(|j| (0..=N).map(move |i| at(i, j))).collect();
        (positions, (0..N).flat_map(|j| (0..N).flat_map(move |i| square(i, j))).collect())
    }

    fn moved((positions, triangles): &Mesh, change: impl Fn(DVec3) -> DVec3) -> Mesh {
        (positions.iter().map(|&position| change(position)).collect(), triangles.clone())
    }

    fn is((positions, triangles): &Mesh) -> bool {
        is_terrain(positions, triangles)
    }

    #[test]
    fn grids_and_maps_are_terrains() {
        let grid = hills(DVec2::new(900.0, 600.0), 60.0);
        let turned = moved(&grid, |p| DVec2::from_angle(0.3).rotate(p.truncate()).extend(p.z));
        let map = moved(&turned, |p| p + DVec3::new(432_000.0, 5_120_000.0, 800.0));
        assert!(is(&grid) && is(&map));
        assert!(!is(&turned), "neither a grid nor a map");
    }

    #[test]
    fn what_is_no_height_field_along_z_is_none() {
        let grid = hills(DVec2::splat(10.0), 1.0);
        let mut folded = grid.clone();
        folded.1[7].swap(0, 1);
        let cases = [
            ("Y up", moved(&grid, |p| DVec3::new(p.x, p.z, -p.y))),
            ("a picture", moved(&grid, |p| DVec3::new(p.x, p.y, 1e-3 * p.z))),
            ("a bowl", moved(&grid, |p| DVec3::new(p.x, p.y, 9.0 * p.z))),
            ("folded", folded),
            ("no number", moved(&grid, |p| p * f64::NAN)),
            ("nothing", (Vec::new(), Vec::new())),
        ];
        for (what, mesh) in cases {
            assert!(!is(&mesh), "{what}");
        }
    }
}
