//! Meshes of implicit surfaces: Surface Nets (Gibson 1998) on a grid, then vertices relaxed along the surface and
//! projected on it in f64.

use std::collections::HashMap;
use std::f64::consts::PI;

use fast_surface_nets::ndshape::{RuntimeShape, Shape};
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::{DVec3, UVec3};

/// Side of the blocks, in cells, that are skipped where they are far from the surface.
const BLOCK: u32 = 4;
/// Fields here grow no faster than distance; ellipsoids and blends may err by this factor.
const LIPSCHITZ_MARGIN: f64 = 2.0;
/// Edge flips give the vertices of Surface Nets, which have four to twelve neighbours, more nearly six.
const ROUNDS: usize = 3;
const RELAXATIONS_A_ROUND: usize = 4;
/// Fraction of the way to the neighbours' centroid at each relaxation.
const RELAXATION_STEP: f64 = 0.5;
/// In radians: edges of squares, which could go either way, stay.
const FLIP_MARGIN: f64 = 1e-3;
/// Relaxation begins near the surface, so one step a time is enough; the last positions are polished.
const POLISHING_STEPS: usize = 3;
/// Step of the differences, in cells: small against any feature, large against rounding.
const GRADIENT_STEP: f64 = 1e-4;

/// Vertices and outward triangles of the surface `field = 0`. `field` is negative inside and about the distance near the
/// surface, which must lie within `lower..upper`. `spacing` is about the length of an edge.
///
/// # Panics
/// If the surface reaches the bounds.
pub fn mesh(field: &impl Fn(DVec3) -> f64, lower: DVec3, upper: DVec3, spacing: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let cells = ((upper - lower) / spacing).ceil().as_uvec3() + 1;
    let shape = RuntimeShape::<u32, 3>::new(cells.to_array());
    let mut samples = sample(field, &shape, lower, spacing);
    make_manifold(&mut samples, &shape);
    let mut net = SurfaceNetsBuffer::default();
    surface_nets(&samples, &shape, [0; 3], (cells - 1).to_array(), &mut net);
    let mut positions: Vec<DVec3> =
        net.positions.iter().map(|&position| lower + spacing * glam::Vec3::from(position).as_dvec3()).collect();
    let mut triangles: Vec<[u32; 3]> = net.indices.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let mut gradients = vec![DVec3::ZERO; positions.len()];
    for _ in 0..ROUNDS {
        for (position, gradient) in positions.iter_mut().zip(&mut gradients) {
            (*position, *gradient) = newton_step(field, *position, spacing);
        }
        for _ in 0..RELAXATIONS_A_ROUND {
            relax(field, spacing, &mut positions, &gradients, &triangles);
        }
        flip_edges(&positions, &mut triangles);
    }
    for position in &mut positions {
        let gradient;
        (*position, gradient) = newton_step(field, *position, spacing);
        for _ in 1..POLISHING_STEPS {
            *position = along_gradient(field(*position), gradient, *position, spacing);
        }
    }
    (positions, triangles)
}

/// The field at the grid points. A block whose centre is far from the surface takes the centre's value throughout:
/// only the sign counts there.
fn sample(field: &impl Fn(DVec3) -> f64, shape: &RuntimeShape<u32, 3>, lower: DVec3, spacing: f64) -> Vec<f32> {
    let size = UVec3::from_array(shape.as_array());
    let mut samples = vec![0.0; shape.usize()];
    let point = |index: UVec3| lower + spacing * index.as_dvec3();
    let blocks = size.map(|size| size.div_ceil(BLOCK));
    for block in indices(UVec3::ZERO, blocks) {
        let start = block * BLOCK;
        let end = (start + BLOCK).min(size);
        let centre = (point(start) + point(end - 1)) / 2.0;
        let radius = point(end - 1).distance(centre);
        let value = field(centre);
        let far = value.abs() > LIPSCHITZ_MARGIN * (radius + spacing);
        for index in indices(start, end) {
            let value = if far { value } else { field(point(index)) };
            let on_border = index.min_element() == 0 || (size - index).min_element() == 1;
            assert!(value > 0.0 || !on_border, "the surface reaches the bounds of its grid");
            samples[shape.linearize(index.to_array()) as usize] = value as f32;
        }
    }
    samples
}

/// Fills corners of cells through which two sheets of the surface pass, since Surface Nets has one vertex a cell and
/// would join the sheets there. Filling only adds material, so this ends.
fn make_manifold(samples: &mut [f32], shape: &RuntimeShape<u32, 3>) {
    let size = UVec3::from_array(shape.as_array());
    let joins_sheets: Vec<bool> = (0..=u8::MAX).map(joins_sheets).collect();
    let mut changed = true;
    while changed {
        changed = false;
        for cell in indices(UVec3::ZERO, size - 1) {
            let corners: [usize; 8] = std::array::from_fn(|corner| {
                let offset = UVec3::new(corner as u32 & 1, corner as u32 >> 1 & 1, corner as u32 >> 2);
                shape.linearize((cell + offset).to_array()) as usize
            });
            let inside =
                (0..8).filter(|&corner| samples[corners[corner]] < 0.0).fold(0_u8, |mask, corner| mask | 1 << corner);
            if !joins_sheets[usize::from(inside)] {
                continue;
            }
            let outside = corners.into_iter().filter(|&corner| samples[corner] >= 0.0);
            if let Some(nearest) = outside.min_by(|&a, &b| samples[a].total_cmp(&samples[b])) {
                samples[nearest] = -f32::MIN_POSITIVE;
                changed = true;
            }
        }
    }
}

/// Whether the corners inside, one bit each, or those outside fall into pieces that no edge of the cell connects.
fn joins_sheets(inside: u8) -> bool {
    let connected = |corners: u8| {
        let mut reached = corners & corners.wrapping_neg();
        loop {
            let x = (reached & 0x55) << 1 | (reached & 0xaa) >> 1;
            let y = (reached & 0x33) << 2 | (reached & 0xcc) >> 2;
            let z = reached.rotate_left(4);
            let next = reached | ((x | y | z) & corners);
            if next == reached {
                return reached == corners;
            }
            reached = next;
        }
    };
    !connected(inside) || !connected(!inside)
}

fn indices(start: UVec3, end: UVec3) -> impl Iterator<Item = UVec3> {
    (start.z..end.z)
        .flat_map(move |z| (start.y..end.y).flat_map(move |y| (start.x..end.x).map(move |x| UVec3::new(x, y, z))))
}

/// Moves each vertex towards the centroid of its neighbours within the tangent plane, then on the surface. The gradients
/// may be those of a few relaxations before: a vertex moves by a fraction of a cell.
fn relax(
    field: &impl Fn(DVec3) -> f64,
    spacing: f64,
    positions: &mut [DVec3],
    gradients: &[DVec3],
    triangles: &[[u32; 3]],
) {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    let mut counts = vec![0.0; positions.len()];
    for triangle in triangles {
        for corner in 0..3 {
            // On a closed surface every edge is met once in each direction.
            let (from, to) = (triangle[corner] as usize, triangle[(corner + 1) % 3] as usize);
            sums[from] += positions[to];
            counts[from] += 1.0;
        }
    }
    for (vertex, position) in positions.iter_mut().enumerate() {
        let normal = gradients[vertex].normalize_or_zero();
        let step = sums[vertex] / counts[vertex] - *position;
        let moved = *position + RELAXATION_STEP * (step - normal * step.dot(normal));
        *position = along_gradient(field(moved), gradients[vertex], moved, spacing);
    }
}

/// Flips each edge whose opposite angles sum to more than π, once, where that neither doubles an edge nor turns a
/// triangle over.
fn flip_edges(positions: &[DVec3], triangles: &mut [[u32; 3]]) {
    let mut sides = HashMap::with_capacity(3 * triangles.len());
    for (index, triangle) in triangles.iter().enumerate() {
        for corner in 0..3 {
            sides.insert((triangle[corner], triangle[(corner + 1) % 3]), index);
        }
    }
    let normal = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|vertex| positions[vertex as usize]);
        (b - a).cross(c - a)
    };
    for left in 0..triangles.len() {
        for corner in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| triangles[left][(corner + i) % 3]);
            let Some(&right) = sides.get(&(b, a)) else { continue };
            let Some(d) = triangles[right].into_iter().find(|&vertex| vertex != a && vertex != b) else { continue };
            let angle = |apex: u32| {
                let apex = positions[apex as usize];
                (positions[a as usize] - apex).angle_between(positions[b as usize] - apex)
            };
            if angle(c) + angle(d) <= PI + FLIP_MARGIN || sides.contains_key(&(c, d)) || sides.contains_key(&(d, c)) {
                continue;
            }
            let (first, second) = ([a, d, c], [d, b, c]);
            let before = normal(triangles[left]) + normal(triangles[right]);
            if normal(first).dot(before) <= 0.0 || normal(second).dot(before) <= 0.0 {
                continue;
            }
            sides.remove(&(a, b));
            sides.remove(&(b, a));
            (triangles[left], triangles[right]) = (first, second);
            for (triangle, index) in [(first, left), (second, right)] {
                for corner in 0..3 {
                    sides.insert((triangle[corner], triangle[(corner + 1) % 3]), index);
                }
            }
            break;
        }
    }
}

/// One step of Newton's method along the gradient, and the gradient before it.
fn newton_step(field: &impl Fn(DVec3) -> f64, point: DVec3, spacing: f64) -> (DVec3, DVec3) {
    let value = field(point);
    let h = GRADIENT_STEP * spacing;
    let gradient = DVec3::from_array([DVec3::X, DVec3::Y, DVec3::Z].map(|axis| field(point + h * axis) - value)) / h;
    (along_gradient(value, gradient, point, spacing), gradient)
}

fn along_gradient(value: f64, gradient: DVec3, point: DVec3, spacing: f64) -> DVec3 {
    let step = gradient * (value / gradient.length_squared());
    // In the crease of a blend the gradient may vanish: no step then, and never one beyond the cell.
    if step.is_finite() { point - step.clamp_length_max(spacing) } else { point }
}
