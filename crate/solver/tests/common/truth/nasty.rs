//! Random triangles on few vertices: of any shape, many on an edge, nearly equal vertices, repeated and of no area.

use glam::DVec3;

use super::{Case, Random};

/// Makes triangles.
type Make = fn(&mut Random) -> Vec<[u32; 3]>;

pub fn case(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let (kind, make): (_, Make) =
        random.pick(&[("soup", soup), ("fans on edges", fans), ("flipped strip", strip), ("patches", patches)]);
    let mut triangles = make(&mut random);
    for _ in 0..random.pick(&[0, 0, 1, 3]) {
        let again = random.pick(&triangles);
        triangles.push(if random.chance(0.5) { again } else { [again[0], again[1], again[0]] });
    }
    let vertices = 1 + triangles.iter().flatten().copied().max().unwrap_or(0) as usize;
    let positions = positions(vertices, &mut random);
    Case::placed(kind, &mut random, (positions, triangles), None)
}

/// Anywhere, in a plane, on a line, or on a grid; some beside others and on the lines between others.
fn positions(count: usize, random: &mut Random) -> Vec<DVec3> {
    let squeeze =
        random.pick(&[DVec3::ONE, DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 1e-3, 1e-6), DVec3::new(1.0, 1e-5, 0.0)]);
    let is_on_grid = random.chance(0.3);
    let share_of_special = random.pick(&[0.0, 0.2, 0.5]);
    let mut positions: Vec<DVec3> = Vec::new();
    while positions.len() < count {
        let any = random.point();
        let mut position = squeeze * if is_on_grid { (1.5 * any).round() } else { any };
        if !positions.is_empty() && random.chance(share_of_special) {
            let [p, q] = [(); 2].map(|()| random.pick(&positions));
            let near = random.log_between(1e-14, 1e-10) * random.point();
            let off = random.pick(&[0.0, 1e-12, 1e-8, 1e-5, 1e-3]) * random.point();
            position = if random.chance(0.5) { p + near } else { p.lerp(q, random.between(0.0, 1.0)) + off };
        }
        positions.push(position);
    }
    positions
}

fn any_triangle(vertices: usize, random: &mut Random) -> [u32; 3] {
    [(); 3].map(|()| random.below(vertices) as u32)
}

fn soup(random: &mut Random) -> Vec<[u32; 3]> {
    let vertices = random.count(4, 12);
    (0..random.count(2, 3 * vertices)).map(|_| any_triangle(vertices, random)).collect()
}

/// Triangles that share the edges of a few.
fn fans(random: &mut Random) -> Vec<[u32; 3]> {
    let vertices = random.count(5, 12);
    let mut triangles = vec![[0, 1, 2]];
    for _ in 0..random.count(3, 20) {
        let k = random.below(3);
        let of = random.pick(&triangles);
        triangles.push([of[k], of[(k + 1) % 3], random.below(vertices) as u32]);
    }
    triangles
}

/// A strip of triangles, each of the last two vertices and a new one.
fn strip(random: &mut Random) -> Vec<[u32; 3]> {
    let count = random.count(3, 20) as u32;
    let mut triangles: Vec<[u32; 3]> = (0..count).map(|k| [k, k + 1, k + 2]).collect();
    if random.chance(0.3) {
        triangles.push([count, count + 1, 0]);
        triangles.push([count + 1, 0, 1]);
    }
    triangles
}

/// Grids of any points, one or two, that may share vertices.
fn patches(random: &mut Random) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    let mut first = 0;
    for _ in 0..random.count(1, 2) {
        let [rows, columns] = [random.count(1, 3) as u32, random.count(1, 4) as u32];
        for i in 0..rows {
            for j in 0..columns {
                let a = first + i * (columns + 1) + j;
                let [b, c, d] = [a + columns + 1, a + columns + 2, a + 1];
                triangles.extend(if random.chance(0.5) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
            }
        }
        first += random.below((rows as usize + 1) * (columns as usize + 1) + 1) as u32;
    }
    triangles
}
