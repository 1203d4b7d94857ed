//! From soup to clean indexed triangles: vertices of equal position become one point where sheets join along edges,
//! useless triangles go.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::error::{Error, Result};
use crate::soup::Soup;
use crate::touching::part_touching;

/// Welded triangles over points, each used by a triangle.
pub(crate) struct Welded {
    /// `#P`, in order of the first soup vertex there.
    pub(crate) positions: Vec<DVec3>,
    /// `#V`, point of each soup vertex; [`NONE`] where no kept triangle uses it.
    pub(crate) point_of_input: Vec<u32>,
    /// `#F × 3` points.
    pub(crate) faces: Vec<[u32; 3]>,
    /// `#F`, the soup's triangle.
    pub(crate) triangle_of_face: Vec<u32>,
    pub(crate) degenerate_faces: usize,
    pub(crate) duplicate_faces: usize,
}

/// Welds the soup.
///
/// # Errors
/// [`Error::IndexOutOfRange`], [`Error::NotFinite`] (a vertex that no triangle uses may be anything), [`Error::Empty`].
pub(crate) fn weld(soup: &Soup) -> Result<Welded> {
    let vertices = soup.positions.len();
    let mut used = vec![false; vertices];
    for (triangle, corners) in soup.triangles.iter().enumerate() {
        for &vertex in corners {
            let out_of_range = Error::IndexOutOfRange { triangle, vertex: vertex.into(), vertices };
            *used.get_mut(vertex as usize).ok_or(out_of_range)? = true;
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

    let duplicate = duplicates(positions.len(), &faces);
    let duplicate_faces = duplicate.iter().filter(|&&duplicate| duplicate).count();
    if duplicate_faces > 0 {
        let (mut of_faces, mut of_triangles) = (duplicate.iter(), duplicate.iter());
        faces.retain(|_| of_faces.next() == Some(&false));
        triangle_of_face.retain(|_| of_triangles.next() == Some(&false));
    }
    if faces.is_empty() {
        let reason = if soup.triangles.is_empty() {
            "the file holds none; export the surface as triangles".to_owned()
        } else {
            format!("all {} have zero area; check the scale of the file", soup.triangles.len())
        };
        return Err(Error::Empty { reason });
    }
    part_touching(soup, &triangle_of_face, &mut faces, &mut positions, &mut point_of_input);
    drop_unused(&mut faces, &mut positions, &mut point_of_input);
    Ok(Welded { positions, point_of_input, faces, triangle_of_face, degenerate_faces, duplicate_faces })
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

/// Marks each face whose three points an earlier face has, in any order.
fn duplicates(points: usize, faces: &[[u32; 3]]) -> Vec<bool> {
    let sorted = |face: u32| {
        let mut points = faces[face as usize];
        points.sort_unstable();
        points
    };
    let by_lowest = Csr::group(points, faces.iter().map(|&[a, b, c]| a.min(b).min(c)));
    let mut duplicate = vec![false; faces.len()];
    let mut row: Vec<([u32; 3], u32)> = Vec::new();
    for candidates in by_lowest.rows().filter(|candidates| candidates.len() > 1) {
        row.clear();
        row.extend(candidates.iter().map(|&face| (sorted(face), face)));
        row.sort_unstable();
        for pair in row.windows(2) {
            duplicate[pair[1].1 as usize] = pair[0].0 == pair[1].0;
        }
    }
    duplicate
}

/// Drops points that no face uses, keeping the order of the others.
fn drop_unused(faces: &mut [[u32; 3]], positions: &mut Vec<DVec3>, point_of_input: &mut [u32]) {
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
        return;
    }
    positions.truncate(kept as usize);
    for point in faces.iter_mut().flatten().chain(point_of_input.iter_mut().filter(|point| **point != NONE)) {
        *point = renumbered[*point as usize];
    }
}
