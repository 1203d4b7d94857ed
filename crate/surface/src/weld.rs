//! From soup to clean indexed triangles: vertices of equal position become one point where sheets join along edges,
//! useless triangles go.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::edges::Edges;
use crate::error::{Error, Result};
use crate::soup::Soup;
use crate::touching::Sheets;

/// Welded triangles over points, each used by a triangle.
pub struct Welded {
    /// `#P`, in order of the first soup vertex there.
    pub positions: Vec<DVec3>,
    /// `#V`, point of each soup vertex; [`NONE`] where no kept triangle uses it.
    pub point_of_input: Vec<u32>,
    /// `#F × 3` points.
    pub faces: Vec<[u32; 3]>,
    /// `#F`, the soup's triangle.
    pub triangle_of_face: Vec<u32>,
    pub edges: Edges,
    /// The corners `3 f + k` at each point.
    pub corners_of_point: Csr,
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
    let (mut point_of_input, mut positions) = merge(&soup.positions, &used);

    let mut faces = Vec::with_capacity(soup.triangles.len());
    let mut triangle_of_face = Vec::with_capacity(soup.triangles.len());
    for (triangle, corners) in soup.triangles.iter().enumerate() {
        let face @ [a, b, c] = corners.map(|vertex| point_of_input[vertex as usize]);
        let [p, q, r] = face.map(|point| positions[point as usize]);
        if a != b && b != c && c != a && (q - p).cross(r - p) != DVec3::ZERO {
            faces.push(face);
            triangle_of_face.push(triangle as u32);
        }
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
    let group = |points: usize, faces: &[[u32; 3]]| Csr::group(points, faces.iter().flatten().copied());
    let mut corners_of_point = group(positions.len(), &faces);
    let mut edges = Edges::new(&faces, &corners_of_point);
    let duplicates = edges.duplicates(&faces);
    if !duplicates.is_empty() {
        let mut is_kept = vec![true; faces.len()];
        for &face in &duplicates {
            is_kept[face as usize] = false;
        }
        edges = edges.kept(&is_kept);
        let (mut of_faces, mut of_triangles) = (is_kept.iter(), is_kept.iter());
        faces.retain(|_| of_faces.next() == Some(&true));
        triangle_of_face.retain(|_| of_triangles.next() == Some(&true));
        corners_of_point = group(positions.len(), &faces);
    }
    // Sheets part at whole edges, so that half-edges of an edge stay together; only points get other numbers.
    let is_merged = positions.len() < used.iter().filter(|&&used| used).count();
    let mut is_renumbered = is_merged && {
        let input = |corner: u32| soup.triangles[triangle_of_face[corner as usize / 3] as usize][corner as usize % 3];
        let sheets = Sheets { corners_of_point: &corners_of_point, edges: &edges, input };
        sheets.part_touching(&mut faces, &mut positions, &mut point_of_input)
    };
    if degenerate_faces > 0 {
        is_renumbered |= drop_unused(&mut faces, &mut positions, &mut point_of_input);
    }
    if is_renumbered {
        corners_of_point = group(positions.len(), &faces);
    }
    Ok(Welded {
        positions,
        point_of_input,
        faces,
        triangle_of_face,
        edges,
        corners_of_point,
        degenerate_faces,
        duplicate_faces: duplicates.len(),
    })
}

/// Point of each used vertex and position of each point, by an open-addressing hash table of the coordinates' bits.
fn merge(vertices: &[DVec3], used: &[bool]) -> (Vec<u32>, Vec<DVec3>) {
    // Half full at most, so that probes stay short.
    let bits = (vertices.len() * 2).next_power_of_two().trailing_zeros().max(1);
    let mask = (1_usize << bits) - 1;
    let mut table = vec![NONE; mask + 1];
    let mut point_of_input = vec![NONE; vertices.len()];
    let mut positions: Vec<DVec3> = Vec::with_capacity(vertices.len());
    for vertex in (0..vertices.len()).filter(|&vertex| used[vertex]) {
        // Adding 0 turns −0 into +0: one position, one bit pattern.
        let position = vertices[vertex] + 0.0;
        let hash = position.to_array().iter().fold(0_u64, |hash, coordinate| {
            // The odd constant of Fibonacci hashing, 2⁶⁴ / golden ratio, spreads low bits to the top.
            (hash.rotate_left(23) ^ coordinate.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15)
        });
        let mut slot = (hash >> (64 - bits)) as usize;
        while table[slot] != NONE && positions[table[slot] as usize] != position {
            slot = (slot + 1) & mask;
        }
        if table[slot] == NONE {
            table[slot] = positions.len() as u32;
            positions.push(position);
        }
        point_of_input[vertex] = table[slot];
    }
    (point_of_input, positions)
}

/// Drops points that no face uses, keeping the order of the others. Returns whether there were any.
fn drop_unused(faces: &mut [[u32; 3]], positions: &mut Vec<DVec3>, point_of_input: &mut [u32]) -> bool {
    let mut renumbered = vec![NONE; positions.len()];
    for &point in faces.iter().flatten() {
        renumbered[point as usize] = 0;
    }
    let mut kept = 0;
    for (point, number) in renumbered.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
        *number = kept;
        positions[kept as usize] = positions[point];
        kept += 1;
    }
    if kept as usize == positions.len() {
        return false;
    }
    positions.truncate(kept as usize);
    for point in faces.iter_mut().flatten().chain(point_of_input.iter_mut().filter(|point| **point != NONE)) {
        *point = renumbered[*point as usize];
    }
    true
}
