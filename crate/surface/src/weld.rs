//! From soup to clean indexed triangles: input vertices of equal position become one vertex where surfaces join along edges,
//! useless triangles go.

use std::borrow::Cow;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;

use crate::cracks::{Closed, Triangles, WeldRule};
use crate::csr::NONE;
use crate::edges::{Corners, Edges};
use crate::element::{
    Element, FaceData, FaceId, HalfedgeId, InputTriangle, InputVertex, InputVertexData, VertexData, VertexId,
};
use crate::error::{Error, Result};
use crate::merge::merge;
use crate::order::{gather, sort_faces};
use crate::parallel;
use crate::soup::Soup;
use crate::touching::Fans;

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
/// [`Error::IndexOutOfRange`], [`Error::NotFinite`] (a vertex that no triangle uses may be anything), [`Error::Empty`].
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
    let degenerate = degenerate_faces(&faces, &positions, threads);
    remove(&degenerate, &mut faces);
    remove(&degenerate, &mut triangle_of_face);

    if faces.is_empty() {
        let reason = if all.triangles.is_empty() {
            "the file holds none; export the surface as triangles".to_owned()
        } else {
            format!("all {} have zero area; check the scale of the file", all.triangles.len())
        };
        return Err(Error::Empty { reason });
    }
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
    let is_merged = positions.len() < is_used.iter().filter(|&&is_used| is_used).count();
    let mut is_renumbered = is_merged && {
        let input = |corner: HalfedgeId| {
            let triangle = triangle_of_face[corner.triangle().index()];
            InputVertex(soup.triangles[triangle.index()][corner.corner()])
        };
        let fans = Fans { corners: &corners, edges: &edges, input };
        fans.part_touching(&mut faces, &mut positions, &mut vertex_of_input)
    };
    if !degenerate.is_empty() || closed.is_some() {
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
        degenerate_faces: degenerate.len(),
        duplicate_faces,
        crack_vertices: closed.as_ref().map_or(0, |closed| closed.count),
        crack_width: closed.map_or(0.0, |closed| closed.width),
    })
}

/// The triangles of the parts of a soup.
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
    let is_bad = |&vertex: &usize| is_used[vertex] && !soup.positions[vertex].is_finite();
    let bad = parallel::map(parallel::ranges(vertices, threads), |mut vertices| vertices.find(is_bad));
    match bad.into_iter().flatten().next() {
        Some(vertex) => Err(Error::NotFinite { vertex }),
        None => Ok(is_used),
    }
}

/// The faces with a repeated corner or no area, ascending.
fn degenerate_faces(faces: &[[VertexId; 3]], positions: &[DVec3], threads: NonZeroUsize) -> Vec<FaceId> {
    let is_degenerate = |&face: &FaceId| {
        let [a, b, c] = faces[face.index()];
        let [p, q, r] = [a, b, c].map(|vertex| positions[vertex.index()]);
        a == b || b == c || c == a || (q - p).cross(r - p) == DVec3::ZERO
    };
    let degenerate = |faces: Range<usize>| faces.map(FaceId::from_index).filter(is_degenerate).collect::<Vec<_>>();
    parallel::map(parallel::ranges(faces.len(), threads), degenerate).concat()
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
