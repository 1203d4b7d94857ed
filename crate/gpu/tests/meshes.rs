//! Meshes of all kinds.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{Soup, Surface, VertexId};
use heatwalk_gpu::{DistanceField, Layout, PatchSize};
use heatwalk_shapes as shapes;
use libtest_mimic::Failed;

use crate::device::{BOUNDS, Device, compare, exact, solved, surface};

/// Compares distances from these vertices, one after another.
fn check(device: &Device, surface: &Arc<Surface>, sources: &[u32], bounds: [f64; 2]) -> Result<(), Failed> {
    let mut field = device.field(surface)?;
    for &source in sources {
        let source = [VertexId(source)];
        let (values, progress) = solved(&mut field, &source)?;
        println!("{} faces, {} rounds", surface.face_count(), progress.rounds);
        compare(&values, &exact(surface, &source), surface.mean_edge(), bounds)?;
    }
    Ok(())
}

pub fn a_plane_is_straight(device: &Device) -> Result<(), Failed> {
    check(device, &surface(&shapes::grid(1, 1)), &[0, 3], BOUNDS)?;
    check(device, &surface(&shapes::grid(24, 30)), &[0, 400], BOUNDS)
}

pub fn large_patches_give_the_same(device: &Device) -> Result<(), Failed> {
    let surface = surface(&shapes::torus(2.0, 0.7, 60, 30));
    let layout = Arc::new(Layout::with_patches(&surface, PatchSize::Large)?);
    let Device { device, queue } = device;
    let mut field = pollster::block_on(DistanceField::new(device, queue, layout, surface.vertices()))?;
    let (values, _) = solved(&mut field, &[VertexId(5)])?;
    compare(&values, &exact(&surface, &[VertexId(5)]), surface.mean_edge(), BOUNDS)
}

pub fn curved_surfaces_are_near_to_the_exact_distance(device: &Device) -> Result<(), Failed> {
    check(device, &surface(&shapes::icosphere(4)), &[0, 1000], BOUNDS)?;
    check(device, &surface(&shapes::torus(2.0, 0.7, 60, 30)), &[0, 777], BOUNDS)
}

/// A sheet of opposite curvatures, with a slit into its midst.
fn saddle(n: u32) -> Soup {
    let mut soup = shapes::grid(n, n);
    for position in &mut soup.positions {
        let [x, z] = [position.x - 0.5, position.z + 0.5];
        position.y = 2.0 * (x * x - z * z);
    }
    let beside = |triangle: &[u32; 3]| {
        let center = triangle.iter().map(|&corner| soup.positions[corner as usize]).sum::<DVec3>() / 3.0;
        !((center.x - 0.5).abs() < 1.0 / f64::from(n) && center.z < -0.4)
    };
    let triangles = soup.triangles.iter().copied().filter(beside).collect();
    Soup::single("saddle", soup.positions.clone(), triangles)
}

pub fn paths_bend_at_saddles_and_at_the_boundary(device: &Device) -> Result<(), Failed> {
    check(device, &surface(&saddle(30)), &[0, 200, 640], BOUNDS)
}

pub fn components_without_a_source_are_not_reached(device: &Device) -> Result<(), Failed> {
    let mut soup = shapes::icosphere(3);
    let other = shapes::icosphere(2);
    let positions = other.positions.iter().map(|position| *position + DVec3::new(5.0, 0.0, 0.0));
    soup.add(positions, &other.triangles);
    let surface = surface(&soup);
    let first = (surface.vertex_count() - 1) as u32;
    check(device, &surface, &[0, first], BOUNDS)
}

/// Triangles sheared so far that they are flipped, on a cylinder.
pub fn flipped_triangles_keep_the_metric(device: &Device) -> Result<(), Failed> {
    let mut soup = shapes::cylinder(2.0, 24, 40);
    for position in &mut soup.positions {
        let angle = position.z.atan2(position.x) + 3.0 * position.y;
        *position = DVec3::new(angle.cos(), position.y, angle.sin());
    }
    check(device, &surface(&soup), &[0, 500], BOUNDS)
}

/// More triangles around a pole than a patch has.
pub fn many_patches_around_one_vertex(device: &Device) -> Result<(), Failed> {
    let surface = surface(&shapes::uv_sphere(300, 6));
    let hub = |vertex: &VertexId| surface.corners_of_vertex(*vertex).count();
    let hub = surface.vertices().max_by_key(hub).expect("a vertex");
    // Two windows of an edge see little of what lies behind slivers: those of the processor err as much there.
    check(device, &surface, &[hub.0, 700], [0.5, 3.0])
}

/// Beside a fine sheet a coarse one is reached long before its turn, and keeps what comes to it until then.
pub fn patches_that_wait_keep_what_has_come(device: &Device) -> Result<(), Failed> {
    let mut soup = shapes::grid(40, 40);
    let coarse = shapes::grid(16, 16);
    // Ten times as large, opposite the corner at the origin.
    soup.add(coarse.positions.iter().map(|&position| -10.0 * position), &coarse.triangles);
    let surface = surface(&soup);
    let corner = surface.vertices().find(|&vertex| surface.position(vertex) == DVec3::ZERO).expect("a corner");
    check(device, &surface, &[corner.0, 800], BOUNDS)
}
