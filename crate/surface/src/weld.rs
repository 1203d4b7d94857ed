//! From soup to clean indexed triangles: input vertices of equal position become one vertex where surfaces join along edges,
//! useless triangles go.

use std::borrow::Cow;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use heatwalk_base::csr::NONE;
use heatwalk_base::parallel;
use heatwalk_base::union_find::UnionFind;

use crate::cracks::{Closed, Triangles, WeldRule};
use crate::edges::{Corners, Edges};
use crate::element::{
    Element, FaceData, FaceId, HalfedgeId, InputTriangle, InputVertex, InputVertexData, VertexData, VertexId,
};
use crate::error::{Error, Result};
use crate::merge::merge;
use crate::order::{gather, sort_faces};
use crate::soup::Soup;
use crate::touching::Fans;

/// Coordinates are at most this, up or down: squares of lengths and areas are numbers then, with room for sums of them.
pub const MOST_COORDINATE: f64 = 1e150;

/// Welded triangles over vertices, each used by a triangle.
pub struct Welded {
    /// `#V`, in order of the first input vertex there.
    pub positions: VertexData<DVec3>,
    /// Welded vertex of each input vertex; `None` where no kept triangle uses it.
    pub vertex_of_input: InputVertexData<Option<VertexId>>,
    /// `#F × 3`.
    pub faces: FaceData<[VertexId; 3]>,
    /// `#F`, the triangle of the input.
    pub triangle_of_face: FaceData<InputTriangle>,
    pub edges: Edges,
    pub corners: Corners,
    pub degenerate_faces: usize,
    pub duplicate_faces: usize,
    /// Vertices that became one with another across a crack, and how far the farthest of them moved.
    pub crack_vertices: usize,
    pub crack_width: f64,
}

/// Welds the soup.
///
/// # Errors
/// [`Error::IndexOutOfRange`], [`Error::NotFinite`] and [`Error::TooFar`] (a vertex that no triangle uses may be anything), [`Error::Empty`].
pub fn weld(soup: &Soup, rule: WeldRule, threads: NonZeroUsize) -> Result<Welded> {
    let all = Chosen::new(soup);
    let is_used = used_vertices(soup, &all, threads)?;
    let (mut vertex_of_input, mut positions) = merge(&soup.positions, &is_used, threads);
    let is_gathered = gather(&all.triangles, &mut positions, &mut vertex_of_input, threads);
    let mut faces = parallel::collect(all.triangles.len(), threads, |triangle| {
        all.triangles[triangle].map(|vertex| VertexId(vertex_of_input[vertex as usize]))
    });
    let mut triangle_of_face = if is_gathered {
        sort_faces(&mut faces, positions.len(), threads)
    } else {
        parallel::collect(faces.len(), threads, InputTriangle::from_index)
    };
    if !all.numbers.is_empty() {
        triangle_of_face.iter_mut().for_each(|triangle| *triangle = all.number(triangle.index()));
    }
    let collapsed = faces_where(&faces, threads, |[a, b, c]| a == b || b == c || c == a);
    remove(&collapsed, &mut faces);
    remove(&collapsed, &mut triangle_of_face);
    let group = |vertices: usize, faces: &[[VertexId; 3]]| Corners::group(vertices, faces.as_flattened(), threads);
    let connect = |faces: &mut Vec<_>, triangle_of_face: &mut Vec<_>| {
        let corners = group(positions.len(), faces);
        let (edges, duplicates) = Edges::new(faces, &corners, threads);
        if duplicates.is_empty() {
            return (corners, edges, 0);
        }
        remove(&duplicates, faces);
        remove(&duplicates, triangle_of_face);
        (group(positions.len(), faces), edges.without(&duplicates), duplicates.len())
    };
    let (mut corners, mut edges, mut duplicate_faces) = connect(&mut faces, &mut triangle_of_face);
    let flat = faces_where(&faces, threads, |face| {
        let [p, q, r] = face.map(|vertex| positions[vertex.index()]);
        (q - p).cross(r - p) == DVec3::ZERO
    });
    if flat.len() == faces.len() {
        let reason = if all.triangles.is_empty() {
            "the file holds none; export the surface as triangles".to_owned()
        } else {
            match all.triangles.len() {
                1 => "the only one has zero area; check the scale of the file".to_owned(),
                count => format!("all {count} have zero area; check the scale of the file"),
            }
        };
        return Err(Error::Empty { reason });
    }
    let is_merged = positions.len() < is_used.iter().filter(|&&is_used| is_used).count();
    let idle = idle_faces(&flat, &faces, &edges, &corners, !is_merged);
    if !idle.is_empty() {
        remove(&idle, &mut faces);
        remove(&idle, &mut triangle_of_face);
        (corners, edges) = (group(positions.len(), &faces), edges.without(&idle));
    }
    let triangles = Triangles { positions: &positions, faces: &faces, edges: &edges, corners: &corners };
    let closed = triangles.closed(rule);
    if let Some(Closed { target, .. }) = &closed {
        let vertices = vertex_of_input.iter_mut().filter(|vertex| **vertex != NONE);
        for vertex in vertices.chain(faces.as_flattened_mut().iter_mut().map(|vertex| &mut vertex.0)) {
            *vertex = target[*vertex as usize];
        }
        let more;
        (corners, edges, more) = connect(&mut faces, &mut triangle_of_face);
        duplicate_faces += more;
    }
    // Surfaces part at whole edges, so that half-edges of an edge stay together; only vertices get other numbers.
    let mut is_renumbered = is_merged && {
        let input = |corner: HalfedgeId| {
            let triangle = triangle_of_face[corner.triangle().index()];
            InputVertex(soup.triangles[triangle.index()][corner.corner()])
        };
        let fans = Fans { corners: &corners, edges: &edges, input };
        fans.part_touching(&mut faces, &mut positions, &mut vertex_of_input)
    };
    let degenerate_faces = collapsed.len() + idle.len();
    if degenerate_faces > 0 || closed.is_some() {
        is_renumbered |= drop_unused(&mut faces, &mut positions, &mut vertex_of_input);
    }
    if is_renumbered {
        corners = group(positions.len(), &faces);
    }
    let welded = |number: u32| Some(VertexId(number)).filter(|vertex| vertex.0 != NONE);
    Ok(Welded {
        positions: positions.into(),
        vertex_of_input: vertex_of_input.into_iter().map(welded).collect(),
        faces: faces.into(),
        triangle_of_face: triangle_of_face.into(),
        edges,
        corners,
        degenerate_faces,
        duplicate_faces,
        crack_vertices: closed.as_ref().map_or(0, |closed| closed.count),
        crack_width: closed.map_or(0.0, |closed| closed.width),
    })
}

/// The triangles of a soup that are part of the surface.
struct Chosen<'a> {
    triangles: Cow<'a, [[u32; 3]]>,
    /// Of each of them, which one of the input it is; empty where these are all.
    numbers: Vec<u32>,
}

impl<'a> Chosen<'a> {
    fn new(soup: &'a Soup) -> Self {
        let ranges = soup.ranges();
        if matches!(&ranges[..], [range] if range.len() == soup.triangles.len()) {
            return Self { triangles: Cow::Borrowed(&soup.triangles), numbers: Vec::new() };
        }
        let triangles = ranges.iter().flat_map(|range| &soup.triangles[range.clone()]).copied().collect();
        let numbers = ranges.into_iter().flatten().map(|triangle| triangle as u32).collect();
        Self { triangles, numbers }
    }

    fn number(&self, index: usize) -> InputTriangle {
        self.numbers.get(index).map_or_else(|| InputTriangle::from_index(index), |&number| InputTriangle(number))
    }
}

/// Per input vertex, whether a triangle uses it.
fn used_vertices(soup: &Soup, all: &Chosen, threads: NonZeroUsize) -> Result<Vec<bool>> {
    let vertices = soup.positions.len();
    let is_used: Vec<AtomicBool> = (0..vertices).map(|_| AtomicBool::new(false)).collect();
    let mark = |triangles: Range<usize>| {
        for triangle in triangles {
            for vertex in all.triangles[triangle] {
                let Some(is_used) = is_used.get(vertex as usize) else {
                    let triangle = all.number(triangle).index();
                    return Err(Error::IndexOutOfRange { triangle, vertex: vertex.into(), vertices });
                };
                is_used.store(true, Ordering::Relaxed);
            }
        }
        Ok(())
    };
    parallel::map(parallel::ranges(all.triangles.len(), threads), mark).into_iter().collect::<Result<()>>()?;
    let is_used: Vec<bool> = is_used.into_iter().map(AtomicBool::into_inner).collect();
    let is_far = |vertex: usize| soup.positions[vertex].abs().max_element() > MOST_COORDINATE;
    let is_bad = |&vertex: &usize| is_used[vertex] && (is_far(vertex) || !soup.positions[vertex].is_finite());
    let bad = parallel::map(parallel::ranges(vertices, threads), |mut vertices| vertices.find(is_bad));
    match bad.into_iter().flatten().next() {
        Some(vertex) if soup.positions[vertex].is_finite() => Err(Error::TooFar { vertex }),
        Some(vertex) => Err(Error::NotFinite { vertex }),
        None => Ok(is_used),
    }
}

/// The faces of some kind, ascending.
fn faces_where(
    faces: &[[VertexId; 3]],
    threads: NonZeroUsize,
    is_such: impl Fn([VertexId; 3]) -> bool + Sync,
) -> Vec<FaceId> {
    let found =
        |own: Range<usize>| own.filter(|&face| is_such(faces[face])).map(FaceId::from_index).collect::<Vec<_>>();
    parallel::map(parallel::ranges(faces.len(), threads), found).concat()
}

/// Those of some faces without area that sew nothing, ascending: all that they have in common with other faces is an edge or a
/// vertex, or edges that two others share. The others close T-junctions, between a long edge and the shorter ones along it, and the
/// surface would be slit without them. `touch`: whether faces also meet at vertices alone.
fn idle_faces(flat: &[FaceId], faces: &[[VertexId; 3]], edges: &Edges, corners: &Corners, touch: bool) -> Vec<FaceId> {
    if flat.is_empty() {
        return Vec::new();
    }
    let mut is_idle = vec![false; faces.len()];
    let mut at_vertex: Vec<usize> = corners.rows().map(|(_, corners)| corners.len()).collect();
    let (mut edge_of, mut on_edge) = (vec![0; 3 * faces.len()], Vec::new());
    for halfedge in edges.representatives() {
        let count = edges.around(halfedge).inspect(|side| edge_of[side.index()] = on_edge.len()).count();
        on_edge.push(count);
    }
    let mut left = flat.to_vec();
    while let Some(face) = left.pop() {
        if is_idle[face.index()] {
            continue;
        }
        let vertices = faces[face.index()].map(VertexId::index);
        let sides = [0, 1, 2].map(|k| edge_of[face.halfedge(k).index()]);
        let others = sides.map(|edge| on_edge[edge] - 1);
        let is_met = |&k: &usize| touch && at_vertex[vertices[k]] > 1 && others[k] == 0 && others[(k + 2) % 3] == 0;
        let (met, sewn) = ((0..3).filter(is_met).count(), others.iter().filter(|&&others| others > 0).count());
        // Edges that two others share are sewn without it.
        let needs_it = met > 0 || others.contains(&1);
        if needs_it && met + sewn > 1 {
            continue;
        }
        is_idle[face.index()] = true;
        // What has this face alone beside it may do nothing without it.
        for k in 0..3 {
            (at_vertex[vertices[k]], on_edge[sides[k]]) = (at_vertex[vertices[k]] - 1, on_edge[sides[k]] - 1);
            let stays = |side: &HalfedgeId| !is_idle[side.triangle().index()];
            let on_side = (on_edge[sides[k]] == 1).then(|| edges.around(face.halfedge(k)).find(stays)).flatten();
            let around = || corners.row(faces[face.index()][k]).iter().copied().find(stays);
            let at_corner = (at_vertex[vertices[k]] == 1).then(around).flatten();
            let next = [on_side, at_corner].into_iter().flatten().map(HalfedgeId::triangle);
            left.extend(next.filter(|next| flat.binary_search(next).is_ok()));
        }
    }
    // Of those left out, what joins edges that no other one joins stays.
    let edges_of = |face: FaceId| [0, 1, 2].map(|k| edge_of[face.halfedge(k).index()]);
    let joined = UnionFind::new(on_edge.len());
    let join = |edges: &[usize]| {
        let apart = edges.windows(2).map(|pair| [pair[0] as u32, pair[1] as u32]);
        let apart = apart.filter(|&[a, b]| joined.least(a) != joined.least(b));
        apart.map(|[a, b]| joined.join(a, b)).count() > 0
    };
    for &face in flat.iter().filter(|face| !is_idle[face.index()]) {
        join(&edges_of(face));
    }
    for &face in flat {
        if is_idle[face.index()] {
            let sewn: Vec<usize> = edges_of(face).into_iter().filter(|&edge| on_edge[edge] > 0).collect();
            is_idle[face.index()] = !join(&sewn);
        }
    }
    flat.iter().copied().filter(|face| is_idle[face.index()]).collect()
}

/// Removes the values of some faces, ascending.
fn remove<T>(removed: &[FaceId], values: &mut Vec<T>) {
    if removed.is_empty() {
        return;
    }
    let (mut face, mut removed) = ((0..).map(FaceId), removed.iter().copied().peekable());
    values.retain(|_| removed.next_if_eq(&face.next().expect("a face")).is_none());
}

/// Drops vertices that no face uses, keeping the order of the others. Returns whether there were any.
fn drop_unused(faces: &mut [[VertexId; 3]], positions: &mut Vec<DVec3>, vertex_of_input: &mut [u32]) -> bool {
    let mut renumbered = vec![NONE; positions.len()];
    for vertex in faces.iter().flatten() {
        renumbered[vertex.index()] = 0;
    }
    let mut kept = 0;
    for (vertex, number) in renumbered.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
        *number = kept;
        positions[kept as usize] = positions[vertex];
        kept += 1;
    }
    if kept as usize == positions.len() {
        return false;
    }
    positions.truncate(kept as usize);
    for vertex in faces.iter_mut().flatten() {
        *vertex = VertexId(renumbered[vertex.index()]);
    }
    for vertex in vertex_of_input.iter_mut().filter(|vertex| **vertex != NONE) {
        *vertex = renumbered[*vertex as usize];
    }
    true
}
