//! Surfaces of hostile form.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3};
use heatwalk::Soup;
use heatwalk_shapes as shapes;

/// A form by its name, of about so many triangles.
pub type Family = (&'static str, fn(usize) -> Soup);

/// Soups of about so many triangles.
pub const FAMILIES: [Family; 17] = [
    ("terrain", |count| shapes::terrain((count as f64 / 2.0).sqrt() as u32)),
    ("ladder", ladder),
    ("hub", |count| fan(count, 0.0, 0.0)),
    ("wavy hub", |count| fan(count, 0.0, 0.2)),
    ("cone", |count| fan(count, 2.0, 0.0)),
    ("two hubs", two_hubs),
    ("needles", needles),
    ("book", |count| book(count, 0.0)),
    ("winding book", |count| book(count, 0.5)),
    ("bouquet", bouquet),
    ("star", star),
    ("ladders side by side", |count| two_ladders(count, DMat3::IDENTITY)),
    ("ladders across", |count| two_ladders(count, DMat3::from_rotation_z(FRAC_PI_2))),
    ("chain", chain),
    ("crack", crack),
    ("spiral", spiral),
    ("boxes in one place", boxes),
];

/// A square cut across into slivers.
fn ladder(count: usize) -> Soup {
    let columns = count / 2;
    let positions = (0..=columns).flat_map(|column| {
        let x = column as f64 / columns as f64;
        [DVec3::new(x, 0.0, 0.0), DVec3::new(x, 1.0, 0.0)]
    });
    let triangles = (0..columns as u32).flat_map(|column| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * column + k);
        [[a, c, b], [b, c, d]]
    });
    Soup::single("ladder", positions.collect(), triangles.collect())
}

/// Triangles around a vertex that is higher than their rim, which goes up and down.
fn fan(count: usize, height: f64, waves: f64) -> Soup {
    let mut positions = vec![DVec3::new(0.0, height, 0.0)];
    positions.extend(rim(count, waves));
    Soup::single("fan", positions, around(0, count))
}

/// Triangles around two vertices with one rim.
pub fn two_hubs(count: usize) -> Soup {
    let count = count / 2;
    let mut positions = vec![DVec3::Y];
    positions.extend(rim(count, 0.0));
    positions.push(DVec3::NEG_Y);
    let below = around(count as u32 + 1, count).into_iter().map(|[a, b, c]| [a, c, b]);
    let triangles = around(0, count).into_iter().chain(below).collect();
    Soup::single("two hubs", positions, triangles)
}

fn rim(count: usize, waves: f64) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |index| {
        let angle = TAU * index as f64 / count as f64;
        DVec3::new(angle.cos(), waves * (7.0 * angle).sin(), angle.sin())
    })
}

/// A fan around a vertex over the vertices 1 to `count`.
fn around(hub: u32, count: usize) -> Vec<[u32; 3]> {
    let count = count as u32;
    (0..count).map(|index| [hub, (index + 1) % count + 1, index + 1]).collect()
}

/// A triangle cut from one corner into needles.
fn needles(count: usize) -> Soup {
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..=count).map(|index| DVec3::new(1.0, index as f64 / count as f64, 0.0)));
    let triangles = (1..=count as u32).map(|index| [0, index, index + 1]);
    Soup::single("needles", positions, triangles.collect())
}

/// Pages on one edge, the last of them less wide than the first by this share.
fn book(count: usize, less: f64) -> Soup {
    let mut positions = vec![DVec3::ZERO, DVec3::Y];
    let width = |index: usize| 1.0 - less * index as f64 / count as f64;
    positions.extend(rim(count, 0.0).enumerate().map(|(index, point)| width(index) * point + 0.5 * DVec3::Y));
    Soup::single("book", positions, (0..count as u32).map(|index| [0, 1, index + 2]).collect())
}

/// Triangles that have one corner in common.
fn bouquet(count: usize) -> Soup {
    let outward = directions(2 * count).flat_map(|direction| [direction, 1.1 * direction.any_orthogonal_vector()]);
    let positions = std::iter::once(DVec3::ZERO).chain(outward.take(2 * count)).collect();
    let triangles = (0..count as u32).map(|index| [0, 2 * index + 1, 2 * index + 2]);
    Soup::single("bouquet", positions, triangles.collect())
}

/// Triangles that all pierce each other near one point.
fn star(count: usize) -> Soup {
    let corners = |direction: DVec3| {
        let (x, y) = direction.any_orthonormal_pair();
        [x, y - 0.5 * x, -y - 0.5 * x]
    };
    let triangles = (0..count as u32).map(|index| [0, 1, 2].map(|k| 3 * index + k));
    Soup::single("star", directions(count).flat_map(corners).collect(), triangles.collect())
}

/// Unit vectors all around, on a spiral.
fn directions(count: usize) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |index| {
        let height = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
        let (y, x) = (2.4 * index as f64).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        DVec3::new(radius * x, radius * y, height)
    })
}

/// Two squares of slivers, one near above the other and turned.
fn two_ladders(count: usize, turn: DMat3) -> Soup {
    let mut both = ladder(count / 2);
    let first = both.positions.len() as u32;
    let middle = DVec3::new(0.5, 0.5, 0.0);
    let above = |point: &DVec3| turn * (*point - middle) + middle + 1e-4 * DVec3::Z;
    both.positions.extend_from_within(..);
    both.positions[first as usize..].iter_mut().for_each(|point| *point = above(point));
    let above: Vec<_> = both.triangles.iter().map(|corners| corners.map(|corner| corner + first)).collect();
    both.triangles.extend(above);
    Soup::single("ladders", both.positions, both.triangles)
}

/// Triangles of which each pierces the next.
fn chain(count: usize) -> Soup {
    let corners = |index: usize| {
        let (at, angle) = (index as f64 / 2.0, index as f64);
        [DVec3::new(at, 0.0, 0.0), DVec3::new(at + 1.0, 0.0, 0.0), DVec3::new(at + 0.5, angle.cos(), angle.sin())]
    };
    let triangles = (0..count as u32).map(|index| [0, 1, 2].map(|k| 3 * index + k));
    Soup::single("chain", (0..count).flat_map(corners).collect(), triangles.collect())
}

/// Two strips of a square's width side by side, one twice as fine, whose vertices miss each other by little.
fn crack(count: usize) -> Soup {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (columns, from) in [(count as u32 / 6, 0.0), (count as u32 / 3, 1.0 + 1e-7)] {
        let first = positions.len() as u32;
        let width = f64::from(columns).recip();
        for column in 0..=columns {
            positions.extend([from, from + 1.0].map(|y| DVec3::new(f64::from(column) * width, y, 0.0)));
        }
        triangles.extend((0..columns).flat_map(|column| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| first + 2 * column + k);
            [[a, c, b], [b, c, d]]
        }));
    }
    Soup::single("crack", positions, triangles)
}

/// A strip that winds around a point, its turns near each other.
fn spiral(count: usize) -> Soup {
    let turns = (count as f64).sqrt() / 8.0;
    let positions = (0..=count / 2).flat_map(|index| {
        let angle = TAU * turns * (2.0 * index as f64 / count as f64).sqrt();
        let (y, x) = angle.sin_cos();
        [angle, angle + 0.9 * TAU].map(|radius| DVec3::new(radius * x, radius * y, 0.0))
    });
    let triangles = (0..count as u32 / 2).flat_map(|index| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * index + k);
        [[a, b, c], [b, d, c]]
    });
    Soup::single("spiral", positions.collect(), triangles.collect())
}

/// Boxes around one point, each turned and a little larger than the one before.
fn boxes(count: usize) -> Soup {
    const CORNERS: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let boxes = count / 12;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for index in 0..boxes {
        let turn = DMat3::from_rotation_x(index as f64) * DMat3::from_rotation_z(2.4 * index as f64);
        let size = 1.0 + index as f64 / boxes as f64;
        let sign = |corner: usize, axis: usize| if corner >> axis & 1 == 0 { -size } else { size };
        let first = positions.len() as u32;
        positions.extend((0..8).map(|corner| turn * DVec3::new(sign(corner, 0), sign(corner, 1), sign(corner, 2))));
        let faces = CORNERS.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
        triangles.extend(faces.map(|corners| corners.map(|corner| corner + first)));
    }
    Soup::single("boxes", positions, triangles)
}
