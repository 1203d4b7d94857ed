//! Meshes of implicit surfaces: Surface Nets (Gibson 1998) on a grid, then vertices relaxed along the surface and
//! projected on it in f64.

use fast_surface_nets::ndshape::{RuntimeShape, Shape};
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::{DVec3, UVec3};

/// Side of the blocks, in cells, that are skipped where they are far from the surface.
const BLOCK: u32 = 8;
/// Fields here grow no faster than distance; ellipsoids and blends may err by this factor.
const LIPSCHITZ_MARGIN: f64 = 2.0;
const RELAXATIONS: usize = 20;
/// Fraction of the way to the neighbours' centroid at each relaxation.
const RELAXATION_STEP: f64 = 0.5;
const NEWTON_STEPS: usize = 2;
/// Step of the central differences, in cells: small against any feature, large against rounding.
const GRADIENT_STEP: f64 = 1e-4;

/// Vertices and outward triangles of the surface `field = 0`. `field` is negative inside and about the distance near the
/// surface, which must lie within `lower..upper`. `spacing` is about the length of an edge.
///
/// # Panics
/// If the surface reaches the bounds.
pub fn mesh(
    field: &impl Fn(DVec3) -> f64,
    lower: DVec3,
    upper: DVec3,
    spacing: f64,
) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let cells = ((upper - lower) / spacing).ceil().as_uvec3() + 1;
    let shape = RuntimeShape::<u32, 3>::new(cells.to_array());
    let samples = sample(field, &shape, lower, spacing);
    let mut net = SurfaceNetsBuffer::default();
    surface_nets(&samples, &shape, [0; 3], (cells - 1).to_array(), &mut net);
    let mut positions: Vec<DVec3> =
        net.positions.iter().map(|&position| lower + spacing * glam::Vec3::from(position).as_dvec3()).collect();
    let triangles: Vec<[u32; 3]> = net.indices.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    relax(field, spacing, &mut positions, &triangles);
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

fn indices(start: UVec3, end: UVec3) -> impl Iterator<Item = UVec3> {
    (start.z..end.z)
        .flat_map(move |z| (start.y..end.y).flat_map(move |y| (start.x..end.x).map(move |x| UVec3::new(x, y, z))))
}

/// Moves each vertex towards the centroid of its neighbours within the tangent plane, then on the surface.
fn relax(field: &impl Fn(DVec3) -> f64, spacing: f64, positions: &mut Vec<DVec3>, triangles: &[[u32; 3]]) {
    for _ in 0..RELAXATIONS {
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
        let moved = (0..positions.len()).map(|vertex| {
            let position = positions[vertex];
            let normal = gradient(field, position, spacing).normalize_or_zero();
            let step = sums[vertex] / counts[vertex] - position;
            project(field, position + RELAXATION_STEP * (step - normal * step.dot(normal)), spacing)
        });
        *positions = moved.collect();
    }
}

/// Newton's method along the gradient.
fn project(field: &impl Fn(DVec3) -> f64, mut point: DVec3, spacing: f64) -> DVec3 {
    for _ in 0..NEWTON_STEPS {
        let gradient = gradient(field, point, spacing);
        let step = gradient * (field(point) / gradient.length_squared());
        // In the crease of a blend the gradient may vanish: no step then, and never one beyond the cell.
        if step.is_finite() {
            point -= step.clamp_length_max(spacing);
        }
    }
    point
}

fn gradient(field: &impl Fn(DVec3) -> f64, point: DVec3, spacing: f64) -> DVec3 {
    let h = GRADIENT_STEP * spacing;
    DVec3::from_array([DVec3::X, DVec3::Y, DVec3::Z].map(|axis| field(point + h * axis) - field(point - h * axis)))
        / (2.0 * h)
}
