//! Meshes that are hard for distance: the Delaunay tetrahedra of points at random, some taken out. What is left is flat in places,
//! full of holes that waves bend around, and hangs together by vertices and edges alone where that comes about.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashSet};

use glam::{DMat3, DVec3};
use heatwalk_volume::{TetMesh, TetSoup};
use rand::RngExt;
use rand_xoshiro::SplitMix64;

/// How far away the corners of the first tetrahedron are. Flat tetrahedra of the hull whose circumspheres reach there are left out.
const FAR: f64 = 1e3;

/// Delaunay tetrahedra of `points` places in the unit cube, without a share of them: those whose number at random is below `share`.
pub fn riddled(points: usize, share: f64, random: &mut SplitMix64) -> TetSoup {
    let positions: Vec<DVec3> = (0..points).map(|_| DVec3::from_array(random.random())).collect();
    let mut tetrahedra = delaunay(&positions);
    tetrahedra.retain(|_| random.random::<f64>() >= share);
    TetSoup { positions, tetrahedra }
}

/// By inserting one point after another (Bowyer 1981, Watson 1981).
fn delaunay(points: &[DVec3]) -> Vec<[u32; 4]> {
    let count = points.len() as u32;
    let corners = [
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(1.0, -1.0, -1.0),
        DVec3::new(-1.0, 1.0, -1.0),
        DVec3::new(-1.0, -1.0, 1.0),
    ];
    let mut places = points.to_vec();
    places.extend(corners.map(|corner| FAR * corner));
    let mut tetrahedra = vec![[count, count + 1, count + 2, count + 3]];
    for point in 0..count {
        let place = places[point as usize];
        let is_inside = |corners: &[u32; 4]| in_circumsphere(corners.map(|corner| places[corner as usize]), place);
        let mut rim: HashSet<[u32; 3]> = HashSet::new();
        tetrahedra.retain(|&corners| {
            let is_gone = is_inside(&corners);
            if is_gone {
                let [a, b, c, d] = corners;
                for mut face in [[b, c, d], [a, c, d], [a, b, d], [a, b, c]] {
                    face.sort_unstable();
                    // A face that two of them share is not on the rim of the hole.
                    if !rim.remove(&face) {
                        rim.insert(face);
                    }
                }
            }
            !is_gone
        });
        let mut rim: Vec<[u32; 3]> = rim.into_iter().collect();
        rim.sort_unstable();
        tetrahedra.extend(rim.into_iter().map(|[a, b, c]| [a, b, c, point]));
    }
    tetrahedra.retain(|corners| corners.iter().all(|&corner| corner < count));
    tetrahedra
}

fn in_circumsphere([a, b, c, d]: [DVec3; 4], place: DVec3) -> bool {
    let sides = DMat3::from_cols(b - a, c - a, d - a).transpose();
    let squares = 0.5 * DVec3::new(a.distance_squared(b), a.distance_squared(c), a.distance_squared(d));
    let center = sides.inverse() * squares;
    (place - a).distance_squared(center) < center.length_squared()
}

/// The neighbors along edges of each vertex, with the edge's length.
fn edges(mesh: &TetMesh) -> Vec<Vec<(usize, f64)>> {
    let mut edges = vec![Vec::new(); mesh.vertex_count()];
    for corners in mesh.tetrahedra() {
        for (a, b) in corners.iter().flat_map(|&a| corners.map(|b| (a as usize, b as usize))).filter(|(a, b)| a != b) {
            edges[a].push((b, mesh.positions()[a].distance(mesh.positions()[b])));
        }
    }
    edges
}

/// Of each vertex, the shortest way along edges to each vertex (Dijkstra 1959).
pub fn along_edges(mesh: &TetMesh) -> Vec<Vec<f64>> {
    let edges = edges(mesh);
    let from = |source: usize| {
        let mut lengths = vec![f64::INFINITY; edges.len()];
        let mut queue = BinaryHeap::from([Reverse((0, source))]);
        lengths[source] = 0.0;
        // Bits of non-negative floats order as the floats do.
        while let Some(Reverse((bits, vertex))) = queue.pop() {
            let length = f64::from_bits(bits);
            if length > lengths[vertex] {
                continue;
            }
            for &(other, edge) in &edges[vertex] {
                if length + edge < lengths[other] {
                    lengths[other] = length + edge;
                    queue.push(Reverse((lengths[other].to_bits(), other)));
                }
            }
        }
        lengths
    };
    (0..edges.len()).map(from).collect()
}
