//! Which axis of a file points up, where its format does not say.

use std::array;
use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use heatwalk::{Soup, Up};

/// A model stands on its lowest layer, so thick in heights of the model: the feet of scans are not level.
const LAYER: f64 = 0.02;
/// Least share of the rectangle around the footprint that the hull of the lowest layer covers.
const BROAD: f64 = 0.25;
/// Least height along Z in diagonals: a sheet across Z is more often a picture than a floor.
const TALL: f64 = 0.05;
/// Least share of the hull that triangles cover: table legs do, the rim of a bowl and the edge of a terrain do not.
const SOLID: f64 = 0.01;
/// Least cosine between the axis and the normals of triangles that count there: the side of a terrain is no floor, however fine its grid.
const LEVEL: f64 = 0.7;
/// Directions in which the hull is looked for: of a disc, it is found but for a hundredth.
const DIRECTIONS: usize = 32;

/// Z of terrains, and where the model would stand on its lowest layer along Z, on faces, and would not stand along Y; else Y. It would stand
/// where the convex hull of the layer is broad and has the centroid of the surface above it. Nothing is taken to be upside
/// down or X up: bowls have broad rims, and such files are rare.
pub fn upright(soup: &Soup) -> Up {
    if soup.is_terrain() {
        return Up::Z;
    }
    let body = Body::of(soup);
    let is_tall = body.extent.z >= TALL * body.extent.length();
    let stands = |axis| body.base(soup, axis).is_some();
    let is_solid = || body.base(soup, 2).is_some_and(|covered| covered >= SOLID);
    if is_tall && !stands(1) && is_solid() { Up::Z } else { Up::Y }
}

/// Of the triangles of a file, by their corners.
struct Body {
    low: DVec3,
    extent: DVec3,
    centroid: DVec3,
}

impl Body {
    fn of(soup: &Soup) -> Self {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut moment, mut area) = (DVec3::ZERO, 0.0);
        for [a, b, c] in triangles(soup) {
            low = low.min(a).min(b).min(c);
            high = high.max(a).max(b).max(c);
        }
        for [a, b, c] in triangles(soup) {
            let weight = (b - a).cross(c - a).length();
            moment += weight * ((a - low) + (b - low) + (c - low)) / 3.0;
            area += weight;
        }
        Self { low, extent: high - low, centroid: low + moment / area }
    }

    /// The share of its base that triangles cover, where the model would stand on its lowest layer along an axis. Numbers that
    /// are none make it fall.
    fn base(&self, soup: &Soup, axis: usize) -> Option<f64> {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let ground = |point: DVec3| DVec2::new(point[u] - self.low[u], point[v] - self.low[v]);
        let top = self.low[axis] + LAYER * self.extent[axis];
        let lowest = triangles(soup).flatten().filter(|point| point[axis] <= top).map(ground);
        let hull = hull(lowest);
        let edges = || hull.iter().zip(hull.iter().cycle().skip(1));
        let area: f64 = edges().map(|(p, q)| 0.5 * p.perp_dot(*q)).sum();
        let center = ground(self.centroid);
        let is_above = edges().all(|(p, q)| (q - p).perp_dot(center - p) >= 0.0);
        let floor = triangles(soup).filter(|corners| corners.iter().all(|point| point[axis] <= top));
        let normals = floor.map(|[a, b, c]| (b - a).cross(c - a));
        let level = normals.filter(|normal| normal[axis].abs() >= LEVEL * normal.length());
        let covered: f64 = level.map(|normal| 0.5 * normal[axis].abs()).sum();
        (is_above && area >= BROAD * self.extent[u] * self.extent[v]).then(|| covered / area)
    }
}

/// The farthest points in some directions: corners of the convex hull, counterclockwise, some of them more than once.
fn hull(points: impl Iterator<Item = DVec2>) -> [DVec2; DIRECTIONS] {
    let directions: [DVec2; DIRECTIONS] = array::from_fn(|k| DVec2::from_angle(TAU * k as f64 / DIRECTIONS as f64));
    let mut farthest = [(f64::NEG_INFINITY, DVec2::ZERO); DIRECTIONS];
    for point in points {
        for (direction, farthest) in directions.iter().zip(&mut farthest) {
            let reach = direction.dot(point);
            if reach > farthest.0 {
                *farthest = (reach, point);
            }
        }
    }
    farthest.map(|(_, point)| point)
}

fn triangles(soup: &Soup) -> impl Iterator<Item = [DVec3; 3]> {
    let position = |vertex: u32| soup.positions.get(vertex as usize).copied();
    soup.triangles.iter().filter_map(move |&[a, b, c]| Some([position(a)?, position(b)?, position(c)?]))
}

#[cfg(test)]
mod tests {
    use heatwalk::{Unit, UnitRule};
    use heatwalk_shapes as shapes;

    use super::*;

    /// A box between two corners, its six sides cut in triangles.
    fn cuboid(low: DVec3, high: DVec3) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let corner = |k: usize| DVec3::from_array(array::from_fn(|axis| [low, high][k >> axis & 1][axis]));
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        ((0..8).map(corner).collect(), triangles)
    }

    fn boxes(boxes: &[[[f64; 3]; 2]]) -> Soup {
        let mut soup = Soup::single("boxes", Vec::new(), Vec::new());
        for &[low, high] in boxes {
            let (positions, triangles) = cuboid(low.into(), high.into());
            soup.add(positions, &triangles);
        }
        soup
    }

    fn pyramid(tip: DVec3) -> Soup {
        let base = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        let triangles = vec![[0, 2, 1], [0, 3, 2], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        Soup::single("pyramid", [base.as_slice(), &[tip]].concat(), triangles)
    }

    /// A pyramid without its base.
    fn open() -> Soup {
        let mut soup = pyramid(DVec3::new(0.0, 0.0, -3.0));
        soup.triangles.drain(..2);
        soup
    }

    fn changed(mut soup: Soup, change: impl Fn(DVec3) -> DVec3) -> Soup {
        soup.positions.iter_mut().for_each(|position| *position = change(*position));
        soup
    }

    #[test]
    fn what_stands_along_z_alone_is_z_up() {
        assert_eq!(upright(&pyramid(DVec3::new(0.0, 0.0, 3.0))), Up::Z);
        // A table, whose four feet are its base.
        let foot = |x: f64, y: f64| [[x, y, 0.0], [x + 0.1, y + 0.1, 1.0]];
        let mut table = vec![[[-0.1, -0.3, 1.0], [1.3, 1.2, 1.1]]];
        table.extend([(0.0, 0.0), (1.0, 0.0), (0.0, 0.7), (1.0, 0.7)].map(|(x, y)| foot(x, y)));
        table.push([[0.5, 1.15, 1.1], [0.6, 1.4, 1.3]]);
        table.push([[0.5, -0.5, 1.0], [0.6, -0.2, 1.2]]);
        assert_eq!(upright(&boxes(&table)), Up::Z);
        // One that was scanned on uneven ground.
        for (foot, lift) in table[1..5].iter_mut().zip([0.0, 0.008, 0.02, 0.012]) {
            foot[0][2] += lift;
        }
        assert_eq!(upright(&boxes(&table)), Up::Z);
    }

    #[test]
    fn terrains_are_z_up_and_in_meters() {
        let at = |k: u32| DVec3::new(f64::from(k % 6) * 30.0, f64::from(k / 6) * 30.0, f64::from(k * k % 7) * 3.0);
        let square = |a: u32| [[a, a + 1, a + 7], [a, a + 7, a + 6]];
        let squares = (0..30).filter(|k| k % 6 < 5).flat_map(square).collect();
        let terrain = Soup::single("terrain", (0..36).map(at).collect(), squares);
        assert_eq!(upright(&terrain), Up::Z);
        assert_eq!(terrain.length_unit(UnitRule::Automatic).unit, Some(Unit::Meter));
        let turned = changed(terrain, |p| DVec3::new(p.x, p.z, -p.y));
        assert_eq!(upright(&turned), Up::Y);
        assert_eq!(turned.length_unit(UnitRule::Automatic).unit, Some(Unit::Millimeter));
    }

    #[test]
    fn what_is_unclear_is_y_up() {
        let cases = [
            ("a pyramid along Y", changed(pyramid(DVec3::new(0.0, 0.0, 3.0)), |p| DVec3::new(p.y, p.z, p.x))),
            ("a pyramid along X", changed(pyramid(DVec3::new(0.0, 0.0, 3.0)), |p| DVec3::new(p.z, p.x, p.y))),
            ("a pyramid on its tip", pyramid(DVec3::new(0.0, 0.0, -3.0))),
            ("a tower that falls over", pyramid(DVec3::new(9.0, 0.0, 3.0))),
            ("a box", boxes(&[[[0.0; 3], [1.0, 2.0, 3.0]]])),
            ("a bowl on its rim", changed(open(), |p| DVec3::new(p.x, p.y, -p.z))),
            ("a board", boxes(&[[[0.0; 3], [1.0, 0.01, 1.5]]])),
            ("a sheet", changed(boxes(&[[[0.0; 3], [1.0, 2.0, 1.0]]]), |p| DVec3::new(p.x, p.y, 0.01 * p.z))),
            ("what has no size", boxes(&[[[1.0; 3]; 2]])),
            ("what is no number", pyramid(DVec3::NAN)),
            ("nothing", Soup::single("nothing", Vec::new(), Vec::new())),
        ];
        for (what, soup) in cases {
            assert_eq!(upright(&soup), Up::Y, "{what}");
        }
    }

    #[test]
    fn shapes_are_y_up_and_turned_ones_that_stand_are_not() {
        for name in shapes::names() {
            assert_eq!(upright(&shapes::by_name(name).expect("a shape").soup), Up::Y, "{name}");
        }
        for name in ["skull", "horse"] {
            let turned = changed(shapes::by_name(name).expect("a shape").soup, |p| DVec3::new(p.x, -p.z, p.y));
            assert_eq!(upright(&turned), Up::Z, "{name}");
        }
    }

    #[test]
    fn size_and_place_do_not_matter() {
        let tower = || pyramid(DVec3::new(0.2, 0.1, 2.0));
        for (size, shift) in [(1e-30, 0.0), (1e30, 0.0), (1.3, 500_000.0)] {
            assert_eq!(upright(&changed(tower(), |p| size * p + DVec3::splat(shift))), Up::Z, "{size} at {shift}");
        }
    }
}
