//! From soup to clean indexed triangles: input vertices of equal position become one vertex where surfaces join along edges,
//! useless triangles go.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::edges::{Corners, Edges};
use crate::element::{
    Element, FaceData, HalfedgeId, InputTriangle, InputVertex, InputVertexData, VertexData, VertexId,
};
use crate::error::{Error, Result};
use crate::order::gather;
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
}

/// Welds the soup.
///
/// # Errors
/// [`Error::IndexOutOfRange`], [`Error::NotFinite`] (a vertex that no triangle uses may be anything), [`Error::Empty`].
pub fn weld(soup: &Soup) -> Result<Welded> {
    let vertices = soup.positions.len();
    let mut used = vec![false; vertices];
    for (triangle, corners) in soup.triangles.iter().enumerate() {
        for &vertex in corners {
            let Some(is_used) = used.get_mut(vertex as usize) else {
                return Err(Error::IndexOutOfRange { triangle, vertex: vertex.into(), vertices });
            };
            *is_used = true;
        }
    }
    if let Some(vertex) = (0..vertices).find(|&vertex| used[vertex] && !soup.positions[vertex].is_finite()) {
        return Err(Error::NotFinite { vertex });
    }
    let (mut vertex_of_input, mut positions) = merge(&soup.positions, &used);
    let order = gather(&soup.triangles, &mut positions, &mut vertex_of_input);

    let mut faces = Vec::with_capacity(soup.triangles.len());
    let mut triangle_of_face = Vec::with_capacity(soup.triangles.len());
    let mut take = |triangle: InputTriangle| {
        let corners = soup.triangles[triangle.index()];
        let face @ [a, b, c] = corners.map(|vertex| VertexId(vertex_of_input[vertex as usize]));
        let [p, q, r] = face.map(|vertex| positions[vertex.index()]);
        if a != b && b != c && c != a && (q - p).cross(r - p) != DVec3::ZERO {
            faces.push(face);
            triangle_of_face.push(triangle);
        }
    };
    match order {
        Some(order) => order.into_iter().for_each(&mut take),
        None => (0..soup.triangles.len()).map(InputTriangle::from_index).for_each(&mut take),
    }
    let degenerate_faces = soup.triangles.len() - faces.len();

    if faces.is_empty() {
        let reason = if soup.triangles.is_empty() {
            "the file holds none; export the surface as triangles".to_owned()
        } else {
            format!("all {} have zero area; check the scale of the file", soup.triangles.len())
        };
        return Err(Error::Empty { reason });
    }
    let group = |vertices: usize, faces: &[[VertexId; 3]]| -> Corners {
        Csr::group(vertices, faces.iter().flatten().copied().map(Some))
    };
    let mut corners = group(positions.len(), &faces);
    let mut edges = Edges::new(&faces, &corners);
    let duplicates = edges.duplicates(&faces);
    if !duplicates.is_empty() {
        let mut is_kept = vec![true; faces.len()];
        for &face in &duplicates {
            is_kept[face.index()] = false;
        }
        edges = edges.kept(&is_kept);
        let (mut of_faces, mut of_triangles) = (is_kept.iter(), is_kept.iter());
        faces.retain(|_| of_faces.next() == Some(&true));
        triangle_of_face.retain(|_| of_triangles.next() == Some(&true));
        corners = group(positions.len(), &faces);
    }
    // Surfaces part at whole edges, so that half-edges of an edge stay together; only vertices get other numbers.
    let is_merged = positions.len() < used.iter().filter(|&&used| used).count();
    let mut is_renumbered = is_merged && {
        let input = |corner: HalfedgeId| {
            let triangle = triangle_of_face[corner.triangle().index()];
            InputVertex(soup.triangles[triangle.index()][corner.corner()])
        };
        let fans = Fans { corners: &corners, edges: &edges, input };
        fans.part_touching(&mut faces, &mut positions, &mut vertex_of_input)
    };
    if degenerate_faces > 0 {
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
        duplicate_faces: duplicates.len(),
    })
}

/// Welded vertex of each used input vertex ([`NONE`] elsewhere) and position of each welded one, by an open-addressing
/// hash table of the coordinates' bits.
fn merge(vertices: &[DVec3], used: &[bool]) -> (Vec<u32>, Vec<DVec3>) {
    // Half full at most, so that probes stay short.
    let bits = (vertices.len() * 2).next_power_of_two().trailing_zeros().max(1);
    let mask = (1_usize << bits) - 1;
    let mut table = vec![NONE; mask + 1];
    let mut vertex_of_input = vec![NONE; vertices.len()];
    let mut positions: Vec<DVec3> = Vec::with_capacity(vertices.len());
    for vertex in (0..vertices.len()).filter(|&vertex| used[vertex]) {
        // Adding 0 turns −0 into +0: one position, one bit pattern.
        let position = vertices[vertex] + 0.0;
        let hash = position.to_array().iter().fold(0_u64, |hash, coordinate| {
            // The odd constant of Fibonacci hashing, 2⁶⁴ / golden ratio, spreads low bits to the top.
            (hash.rotate_left(23) ^ coordinate.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15)
        });
        let mut bucket = (hash >> (64 - bits)) as usize;
        while table[bucket] != NONE && positions[table[bucket] as usize] != position {
            bucket = (bucket + 1) & mask;
        }
        if table[bucket] == NONE {
            table[bucket] = positions.len() as u32;
            positions.push(position);
        }
        vertex_of_input[vertex] = table[bucket];
    }
    (vertex_of_input, positions)
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
