//! Sources of all kinds.

use std::sync::Arc;

use heatwalk::{Element as _, FaceId, HalfedgeId, Place, Surface, VertexId};
use heatwalk_gpu::{DistanceField, Layout};
use heatwalk_shapes as shapes;
use libtest_mimic::Failed;

use crate::device::{BOUNDS, Device, compare, exact, solved, surface};

fn body() -> Arc<Surface> {
    surface(&shapes::torus(2.0, 0.8, 48, 20))
}

pub fn a_source_in_a_face_or_on_an_edge(device: &Device) -> Result<(), Failed> {
    // Obtuse triangles are flipped, so that places have to be found again.
    let mut sheared = shapes::grid(20, 20);
    sheared.positions.iter_mut().for_each(|position| position.x += 1.7 * position.z);
    for surface in [body(), surface(&sheared)] {
        let mut field = device.field(&surface)?;
        let middle = FaceId::from_index(surface.face_count() / 2);
        let places = [
            Place::Face { face: middle, weights: [0.2, 0.3, 0.5] },
            Place::Face { face: FaceId(7), weights: [0.9, 0.1, 0.0] },
            Place::Edge { halfedge: middle.halfedge(1), fraction: 0.3 },
            Place::Edge { halfedge: HalfedgeId(0), fraction: 0.5 },
        ];
        for place in places {
            let (values, _) = solved(&mut field, &[place])?;
            compare(&values, &exact(&surface, &[place]), surface.mean_edge(), BOUNDS)?;
        }
    }
    Ok(())
}

pub fn the_nearest_of_several_sources(device: &Device) -> Result<(), Failed> {
    let surface = body();
    let mut field = device.field(&surface)?;
    let places = [
        Place::Vertex(VertexId(3)),
        Place::Face { face: FaceId(900), weights: [0.1, 0.2, 0.7] },
        Place::Face { face: FaceId(900), weights: [0.3, 0.3, 0.4] },
        Place::Vertex(VertexId(555)),
    ];
    let (values, _) = solved(&mut field, &places)?;
    compare(&values, &exact(&surface, &places), surface.mean_edge(), BOUNDS)
}

pub fn a_later_source_counts_from_its_initial_distance(device: &Device) -> Result<(), Failed> {
    let surface = body();
    let mut field = device.field(&surface)?;
    let sources = [(Place::Vertex(VertexId(0)), 1.5), (Place::Vertex(VertexId(600)), 0.2)];
    let (values, _) = solved(&mut field, &sources)?;
    let exact = exact(&surface, &sources);
    assert!(exact.iter().all(|&value| value >= 0.2));
    compare(&values, &exact, surface.mean_edge(), BOUNDS)
}

pub fn an_answer_does_not_depend_on_the_one_before(device: &Device) -> Result<(), Failed> {
    let surface = body();
    let mut field = device.field(&surface)?;
    let (first, _) = solved(&mut field, &[VertexId(0)])?;
    solved(&mut field, &[VertexId(500)])?;
    let (again, _) = solved(&mut field, &[VertexId(0)])?;
    // Workgroups take turns as they like, but keep as near to the exact distance.
    compare(&again, &exact(&surface, &[VertexId(0)]), surface.mean_edge(), BOUNDS)?;
    let difference: f64 = first.iter().zip(&again).map(|(a, b)| (a - b).abs()).sum();
    assert!(difference <= 1e-3 * first.iter().sum::<f64>(), "{difference}");
    Ok(())
}

pub fn the_buffer_has_the_order_of_the_caller(device: &Device) -> Result<(), Failed> {
    let surface = body();
    let (all, _) = solved(&mut device.field(&surface)?, &[VertexId(9)])?;
    let order = [9, 4, 4, 959, 0].map(VertexId);
    let layout = Arc::new(Layout::new(&surface)?);
    let mut field = pollster::block_on(DistanceField::new(&device.device, &device.queue, layout, order))?;
    let (chosen, _) = solved(&mut field, &[VertexId(9)])?;
    assert_eq!(field.buffer().size(), 4 * order.len() as u64);
    for (vertex, value) in order.into_iter().zip(chosen) {
        assert!((value - all[vertex.index()]).abs() <= 1e-3 * value, "{value} at {vertex:?}");
    }
    Ok(())
}
