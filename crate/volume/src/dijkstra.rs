//! Shortest paths along edges (Dijkstra 1959; towards one goal, Hart, Nilsson, Raphael 1968): lines of sources.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use heatwalk::VertexId;

use crate::error::{Error, Result};
use crate::mesh::TetMesh;
use crate::point::TetPoint;

/// The line of shortest paths along edges through vertices in order, and back to the first where it is `closed`. Where two paths meet,
/// their vertex is there once; a closed line does not repeat its first vertex at the end. Empty where no vertex is given.
///
/// ```
/// use heatwalk::VertexId;
/// use heatwalk_volume::{TetMesh, edge_polyline, shapes};
///
/// let mesh = TetMesh::build(&shapes::cube(4, 0.0))?;
/// // From a corner of the cube along its side.
/// let line = edge_polyline(&mesh, &[VertexId(0), VertexId(4)], false)?;
/// assert_eq!(line, [0, 1, 2, 3, 4].map(VertexId));
/// # Ok::<(), heatwalk_volume::Error>(())
/// ```
///
/// # Errors
/// [`Error::NoSuchVertex`]; [`Error::Unreachable`] where no edges join two of them.
pub fn edge_polyline(mesh: &TetMesh, through: &[VertexId], closed: bool) -> Result<Vec<VertexId>> {
    let Some(&first) = through.first() else { return Ok(Vec::new()) };
    for &vertex in through {
        TetPoint::Vertex(vertex).checked(mesh)?;
    }
    let mut line = vec![first];
    let back = closed.then_some(first);
    for &next in through[1..].iter().chain(&back) {
        let from = line[line.len() - 1];
        line.extend_from_slice(&path(mesh, from, next).ok_or(Error::Unreachable)?[1..]);
    }
    if closed && line.len() > 1 {
        line.pop();
    }
    Ok(line)
}

/// The shortest path along edges, both ends included.
fn path(mesh: &TetMesh, from: VertexId, to: VertexId) -> Option<Vec<VertexId>> {
    if mesh.components()[from.0 as usize] != mesh.components()[to.0 as usize] {
        return None;
    }
    // No path along edges is shorter than the straight line.
    let ahead = |vertex: u32| mesh.position(VertexId(vertex)).distance(mesh.position(to));
    // Of each vertex that was come to: the length, and the vertex before.
    let mut best: HashMap<u32, (f64, u32)> = HashMap::from([(from.0, (0.0, from.0))]);
    // Bits of non-negative floats order as the floats do.
    let mut queue = BinaryHeap::from([Reverse((0, from.0, 0.0_f64.to_bits()))]);
    loop {
        let Reverse((_, vertex, bits)) = queue.pop()?;
        let length = f64::from_bits(bits);
        if length > best[&vertex].0 {
            continue;
        }
        if vertex == to.0 {
            break;
        }
        for &other in mesh.adjacent().row(vertex) {
            let candidate = length + mesh.position(VertexId(vertex)).distance(mesh.position(VertexId(other)));
            if best.get(&other).is_none_or(|&(least, _)| candidate < least) {
                best.insert(other, (candidate, vertex));
                queue.push(Reverse(((candidate + ahead(other)).to_bits(), other, candidate.to_bits())));
            }
        }
    }
    let step_back = |&vertex: &u32| Some(best[&vertex].1).filter(|&before| before != vertex);
    let mut path: Vec<VertexId> = std::iter::successors(Some(to.0), step_back).map(VertexId).collect();
    path.reverse();
    Some(path)
}
