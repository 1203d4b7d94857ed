//! Surfaces with a parametrisation, and subdivided polyhedra.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_surface::{Part, Soup};

/// Unit sphere from an icosahedron whose triangles are split in four `subdivisions` times: `20 · 4^subdivisions`
/// triangles, nearly equilateral.
pub fn icosphere(subdivisions: u32) -> Soup {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut positions = Vec::with_capacity(12);
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        positions.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)].map(DVec3::normalize));
    }
    let edge = positions.iter().skip(1).map(|p: &DVec3| p.distance(positions[0])).fold(f64::INFINITY, f64::min);
    // The faces are the triples of mutually nearest vertices; the second nearest are 1.6 times as far.
    let near = |a: usize, b: usize| positions[a].distance(positions[b]) < 1.2 * edge;
    let mut triangles = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in (b + 1..12).filter(|&c| near(a, b) && near(b, c) && near(c, a)) {
                let outward = (positions[b] - positions[a]).cross(positions[c] - positions[a]).dot(positions[a]) > 0.0;
                triangles.push(if outward { [a, b, c] } else { [a, c, b] }.map(|vertex| vertex as u32));
            }
        }
    }
    for _ in 0..subdivisions {
        triangles = split_in_four(&mut positions, &triangles);
    }
    Soup::single("icosphere", positions, triangles)
}

fn split_in_four(positions: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut midpoints: HashMap<(u32, u32), u32> = HashMap::with_capacity(triangles.len() * 3 / 2);
    let mut split = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(a, b)| {
            *midpoints.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        });
        split.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    split
}

/// Unit sphere of `segments × rings` quads as modelling programs export it: the seam and the poles hold one vertex for
/// each texture coordinate, so that only welding makes it closed. At least 3 segments and 2 rings.
pub fn uv_sphere(segments: u32, rings: u32) -> Soup {
    let (segments, rings) = (segments.max(3), rings.max(2));
    let mut positions = Vec::new();
    for ring in 0..=rings {
        let polar = PI * f64::from(ring) / f64::from(rings);
        // sin π is not 0 in floating point, and the poles must weld.
        let radius = if ring == 0 || ring == rings { 0.0 } else { polar.sin() };
        for segment in 0..=segments {
            let azimuth = TAU * f64::from(segment % segments) / f64::from(segments);
            positions.push(DVec3::new(radius * azimuth.cos(), polar.cos(), -radius * azimuth.sin()));
        }
    }
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for segment in 0..segments {
            let a = ring * (segments + 1) + segment;
            let (b, c, d) = (a + segments + 1, a + segments + 2, a + 1);
            if ring + 1 < rings {
                triangles.push([a, b, c]);
            }
            if ring > 0 {
                triangles.push([a, c, d]);
            }
        }
    }
    // At the poles one of the quad's two triangles has no area: [a, c, d] above, [a, b, c] below; the other remains.
    Soup::single("uv_sphere", positions, triangles)
}

/// Torus around the y axis, `segments` along the ring of radius `major`, `sides` around its tube of radius `minor`.
pub fn torus(major: f64, minor: f64, segments: u32, sides: u32) -> Soup {
    let (segments, sides) = (segments.max(3), sides.max(3));
    let mut positions = Vec::new();
    for segment in 0..segments {
        let (sin, cos) = (TAU * f64::from(segment) / f64::from(segments)).sin_cos();
        for side in 0..sides {
            let (height, out) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
            let radius = major + minor * out;
            positions.push(DVec3::new(radius * cos, minor * height, -radius * sin));
        }
    }
    let vertex = |segment: u32, side: u32| (segment % segments) * sides + side % sides;
    let triangles = lattice(segments, sides, vertex);
    Soup::single("torus", positions, triangles)
}

/// Two triangles for each quad of a lattice, their diagonals alternating so that no direction is preferred. `u × v`
/// must point outward.
fn lattice(columns: u32, rows: u32, vertex: impl Fn(u32, u32) -> u32) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(2 * columns as usize * rows as usize);
    for u in 0..columns {
        for v in 0..rows {
            let [a, b, c, d] = [vertex(u, v), vertex(u + 1, v), vertex(u + 1, v + 1), vertex(u, v + 1)];
            triangles.extend(if (u + v) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    triangles
}

/// Flat unit square in the plane y = 0 of `nx × nz` quads, facing up. Vertex `(i, j)` is number `i (nz + 1) + j`.
pub fn grid(nx: u32, nz: u32) -> Soup {
    let (nx, nz) = (nx.max(1), nz.max(1));
    Soup { parts: one_part("grid", nx, nz), ..rectangle(1.0, 1.0, nx, nz) }
}

/// Flat strip of `width × length` along x, `across` quads wide, the quads nearly square.
pub fn strip(width: f64, length: f64, across: u32) -> Soup {
    let across = across.max(1);
    let along = (f64::from(across) * length / width).round().max(1.0) as u32;
    Soup { parts: one_part("strip", along, across), ..rectangle(length, width, along, across) }
}

fn one_part(name: &str, nx: u32, nz: u32) -> Vec<Part> {
    let mut part = Part::new(name);
    part.add(0..2 * nx as usize * nz as usize);
    vec![part]
}

/// A rectangle in the plane y = 0 from the origin along +x and −z, facing up; without a part.
fn rectangle(x: f64, z: f64, nx: u32, nz: u32) -> Soup {
    let mut positions = Vec::new();
    for i in 0..=nx {
        for j in 0..=nz {
            positions.push(DVec3::new(x * f64::from(i) / f64::from(nx), 0.0, -z * f64::from(j) / f64::from(nz)));
        }
    }
    Soup { positions, triangles: lattice(nx, nz, |i, j| i * (nz + 1) + j), ..Soup::default() }
}

/// Open cylinder of unit radius around the y axis, from y = 0 to `height`: two boundary loops.
pub fn cylinder(height: f64, segments: u32, rows: u32) -> Soup {
    let (segments, rows) = (segments.max(3), rows.max(1));
    let mut positions = Vec::new();
    for segment in 0..segments {
        let (sin, cos) = (TAU * f64::from(segment) / f64::from(segments)).sin_cos();
        positions.extend((0..=rows).map(|row| DVec3::new(cos, height * f64::from(row) / f64::from(rows), -sin)));
    }
    let triangles = lattice(segments, rows, |segment, row| (segment % segments) * (rows + 1) + row);
    Soup::single("cylinder", positions, triangles)
}

/// Profile of the stand of the hemisphere, `(radius, y)`: a plinth whose rim stands around the boundary.
const STAND: [(f64, f64); 12] = [
    (0.97, -0.03),
    (1.02, -0.03),
    (1.025, -0.015),
    (1.035, -0.005),
    (1.05, 0.0),
    (1.10, 0.0),
    (1.115, -0.005),
    (1.125, -0.015),
    (1.13, -0.03),
    (1.13, -0.17),
    (1.125, -0.19),
    (1.11, -0.20),
];

/// Part 0: the upper unit hemisphere, its boundary exactly in the plane y = 0, of `4 frequency²` triangles. Part 1: the
/// round stand under it.
pub fn hemisphere(frequency: u32) -> Soup {
    let frequency = frequency.max(1);
    let mut soup = Soup { positions: vec![DVec3::Y], ..Soup::default() };
    // Ring k of an octahedron's upper half has 4k vertices, k of them a quarter.
    let first = |ring: u32| if ring == 0 { 0 } else { 1 + 2 * ring * (ring - 1) };
    for ring in 1..=frequency {
        let polar = PI / 2.0 * f64::from(ring) / f64::from(frequency);
        for step in 0..4 * ring {
            let (sin, cos) = (TAU * f64::from(step) / f64::from(4 * ring)).sin_cos();
            let height = if ring == frequency { 0.0 } else { polar.cos() };
            soup.positions.push(DVec3::new(polar.sin() * cos, height, -polar.sin() * sin));
        }
    }
    for ring in 1..=frequency {
        let outer = |step: u32| first(ring) + step % (4 * ring);
        let inner = |step: u32| if ring == 1 { 0 } else { first(ring - 1) + step % (4 * (ring - 1)) };
        for quarter in 0..4 {
            for step in 0..ring {
                let (o, i) = (quarter * ring + step, quarter * (ring - 1) + step);
                soup.triangles.push([outer(o), outer(o + 1), inner(i)]);
                if step + 1 < ring {
                    soup.triangles.push([inner(i), outer(o + 1), inner(i + 1)]);
                }
            }
        }
    }
    soup.end_part("dome");
    revolve(&mut soup, &STAND, 96);
    soup.end_part("stand");
    soup
}

/// Adds the closed surface that a profile of `(radius, y)` sweeps around the y axis. The profile goes from the top to the
/// underside, both of which are closed by a cap.
pub fn revolve(soup: &mut Soup, profile: &[(f64, f64)], segments: u32) {
    let start = soup.positions.len() as u32;
    let rows = profile.len() as u32;
    for segment in 0..segments {
        let (sin, cos) = (TAU * f64::from(segment) / f64::from(segments)).sin_cos();
        soup.positions.extend(profile.iter().map(|&(radius, y)| DVec3::new(radius * cos, y, -radius * sin)));
    }
    let vertex = |segment: u32, row: u32| start + (segment % segments) * rows + row;
    for segment in 0..segments {
        for row in 0..rows - 1 {
            let [a, b] = [vertex(segment, row), vertex(segment, row + 1)];
            let [c, d] = [vertex(segment + 1, row + 1), vertex(segment + 1, row)];
            soup.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let top = soup.positions.len() as u32;
    soup.positions.extend([profile[0], profile[profile.len() - 1]].map(|(_, y)| DVec3::new(0.0, y, 0.0)));
    for segment in 0..segments {
        soup.triangles.push([top, vertex(segment, 0), vertex(segment + 1, 0)]);
        soup.triangles.push([top + 1, vertex(segment + 1, rows - 1), vertex(segment, rows - 1)]);
    }
}
