//! A device, and what it says of distances.

use std::sync::Arc;

use heatwalk::exact::exact_distance;
use heatwalk::{Soup, Surface, ToSource, go_on};
use heatwalk_gpu::{DistanceField, Layout, Progress};
use libtest_mimic::Failed;

pub const NONE: &str = "there is no software Vulkan device. On Debian, mesa-vulkan-drivers has one.";

/// What rounding of single precision takes from the length of a path through a few hundred triangles, as a share of it, with room.
const ROUNDING: f64 = 1e-4;

#[derive(Clone)]
pub struct Device {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
}

/// One with WebGPU's default limits.
pub fn open() -> Result<Device, Failed> {
    pollster::block_on(async {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let options = wgpu::RequestAdapterOptions { force_fallback_adapter: true, ..Default::default() };
        let adapter = instance.request_adapter(&options).await.map_err(|_| NONE)?;
        let required_limits = wgpu::Limits::default();
        let descriptor = wgpu::DeviceDescriptor { label: Some("tests"), required_limits, ..Default::default() };
        let (device, queue) = adapter.request_device(&descriptor).await?;
        Ok(Device { device, queue })
    })
}

pub fn surface(soup: &Soup) -> Arc<Surface> {
    Arc::new(Surface::build(soup).expect("a surface"))
}

impl Device {
    /// A field of all vertices of a surface in their order.
    pub fn field(&self, surface: &Arc<Surface>) -> Result<DistanceField, Failed> {
        let layout = Arc::new(Layout::new(surface)?);
        Ok(pollster::block_on(DistanceField::new(&self.device, &self.queue, layout, surface.vertices()))?)
    }
}

/// What a field says of distances from some sources.
pub fn solved<S: ToSource>(field: &mut DistanceField, sources: &[S]) -> Result<(Vec<f64>, Progress), Failed> {
    let progress = pollster::block_on(field.solve(sources))?;
    let values = pollster::block_on(field.read())?;
    Ok((values.into_iter().map(f64::from).collect(), progress))
}

pub fn exact<S: ToSource>(surface: &Arc<Surface>, sources: &[S]) -> Vec<f64> {
    exact_distance(surface, sources, &mut go_on).expect("valid sources").iter().copied().collect()
}

/// Fails where distances are below exact ones, or farther from them than so many per cent: in the mean as a share of the mean distance,
/// and anywhere of the distance there. Distances below a mean edge are not asked for the latter.
pub fn compare(values: &[f64], exact: &[f64], mean_edge: f64, [mean, most]: [f64; 2]) -> Result<(), Failed> {
    let (mut errors, mut sum, mut worst) = (0.0, 0.0, 0.0_f64);
    for (vertex, (&value, &exact)) in values.iter().zip(exact).enumerate() {
        if exact == f64::INFINITY || value == f64::INFINITY {
            if value != exact {
                return Err(format!("{value} for {exact} at vertex {vertex}").into());
            }
            continue;
        }
        if value < exact * (1.0 - ROUNDING) {
            return Err(format!("{value} is below {exact} at vertex {vertex}").into());
        }
        errors += (value - exact).abs();
        sum += exact;
        worst = worst.max((value - exact) / exact.max(mean_edge));
    }
    let found = [100.0 * errors / sum, 100.0 * worst];
    println!("mean {:.4} %, largest {:.3} %", found[0], found[1]);
    if found[0] <= mean && found[1] <= most {
        Ok(())
    } else {
        Err(format!("{found:?} % is more than {mean} % in the mean and {most} % anywhere").into())
    }
}

/// Per cent by which distances of two windows a half-edge may miss exact ones: those of the processor by as many windows have a mean
/// below 0.1 and a maximum below 2 on all meshes measured.
pub const BOUNDS: [f64; 2] = [0.1, 2.0];
