//! Times distances from random vertices on the graphics device, and compares some with exact ones.
//!
//! `cargo run --release -p heatwalk-gpu --example fields -- MESH.off|SHAPE [FIELDS [COMPARED]]`
//!
//! The device is that of the system with most power; `--software` as last argument takes the one that the processor imitates.

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::exact_distance;
use heatwalk::{RelativeError, Soup, Surface, VertexId, go_on};
use heatwalk_gpu::{DistanceField, Layout};
use heatwalk_model::io;
use heatwalk_shapes as shapes;
use rand::{RngExt as _, SeedableRng as _};
use rand_xoshiro::SplitMix64;

const SEED: u64 = 22;

fn main() -> Result<(), Box<dyn Error>> {
    pollster::block_on(run())
}

async fn run() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_software = arguments.pop_if(|last| last == "--software").is_some();
    let [mesh, counts @ ..] = &arguments[..] else { return Err("give a mesh".into()) };
    let count = |index: usize, default| counts.get(index).map_or(Ok(default), |count| count.parse::<usize>());
    let (fields, compared) = (count(0, 50)?, count(1, 2)?);

    let surface = Arc::new(Surface::build(&read(mesh)?)?);
    let begin = Instant::now();
    let layout = Arc::new(Layout::new(&surface)?);
    let laid = begin.elapsed();
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = instance
        .request_adapter(&wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            force_fallback_adapter: is_software,
            ..Default::default()
        })
        .await?;
    let required_limits = wgpu::Limits {
        max_buffer_size: adapter.limits().max_buffer_size,
        max_storage_buffer_binding_size: adapter.limits().max_storage_buffer_binding_size,
        ..Default::default()
    };
    let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
    let (device, queue) = adapter.request_device(&descriptor).await?;
    let mut field = DistanceField::new(&device, &queue, layout, surface.vertices()).await?;
    println!(
        "{}: {} triangles, layout {:.0} ms",
        adapter.get_info().name,
        surface.face_count(),
        1e3 * laid.as_secs_f64()
    );

    let mut random = SplitMix64::seed_from_u64(SEED);
    let mut any = || VertexId(random.random_range(0..surface.vertex_count() as u32));
    // The first time takes what the later ones need no more.
    field.solve(&[any()]).await?;
    let mut times = Vec::new();
    let mut rounds = Vec::new();
    for _ in 0..fields {
        let source = any();
        let begin = Instant::now();
        rounds.push(field.solve(&[source]).await?.rounds);
        times.push(1e3 * begin.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    rounds.sort_unstable();
    let at = |share: f64| ((fields as f64 * share) as usize).min(fields - 1);
    let (median, most) = (at(0.5), at(0.9));
    println!("median {:.2} ms, 90th percentile {:.2} ms; {} rounds", times[median], times[most], rounds[median]);

    for _ in 0..compared {
        let source = any();
        field.solve(&[source]).await?;
        let values: Vec<f64> = field.read().await?.into_iter().map(f64::from).collect();
        let exact = exact_distance(&surface, &[source], &mut go_on)?;
        let error = RelativeError::between(&values, &exact);
        println!("vertex {}: mean error {:.4} %, largest {:.3} %", source.0, 100.0 * error.mean, 100.0 * error.max);
    }
    Ok(())
}

fn read(mesh: &str) -> Result<Soup, Box<dyn Error>> {
    let is_shape = shapes::names().contains(&mesh);
    Ok(if is_shape { shapes::by_name(mesh)?.soup } else { io::read(mesh, &std::fs::read(mesh)?, &|_| None)?.soup })
}
