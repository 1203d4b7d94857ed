//! What is refused.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{Place, Soup, VertexId};
use heatwalk_gpu::{DistanceField, Error, Layout};
use heatwalk_shapes as shapes;
use libtest_mimic::Failed;

use crate::device::{BOUNDS, Device, compare, exact, solved, surface};

/// A device that was opened with smaller buffers is asked for no larger ones.
pub fn meshes_that_do_not_fit_are_refused(_: &Device) -> Result<(), Failed> {
    let surface = surface(&shapes::icosphere(3));
    let layout = Arc::new(Layout::new(&surface)?);
    let opened = |required_limits: wgpu::Limits| {
        pollster::block_on(async {
            let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
            let options = wgpu::RequestAdapterOptions { force_fallback_adapter: true, ..Default::default() };
            let adapter = instance.request_adapter(&options).await.expect("there is one");
            let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
            let (device, queue) = adapter.request_device(&descriptor).await.expect("as small as this");
            DistanceField::new(&device, &queue, Arc::clone(&layout), [VertexId(0)])
                .await
                .map(|_| ())
                .expect_err("too small")
        })
    };
    let small = wgpu::Limits { max_storage_buffer_binding_size: 1 << 16, ..Default::default() };
    assert!(matches!(opened(small), Error::TooLarge { what: "windows", needed: 122_880, limit: 65_536, .. }));
    let error = opened(wgpu::Limits::downlevel_webgl2_defaults());
    assert!(matches!(error, Error::Device { .. }), "{error}");
    Ok(())
}

pub fn orders_that_are_none_are_refused(Device { device, queue }: &Device) -> Result<(), Failed> {
    let layout = Arc::new(Layout::new(&surface(&shapes::grid(1, 1)))?);
    let refused = |order: &[VertexId]| {
        let field = DistanceField::new(device, queue, Arc::clone(&layout), order.iter().copied());
        pollster::block_on(field).map(|_| ()).expect_err("no order")
    };
    assert_eq!(refused(&[]), Error::NoVertex);
    assert!(matches!(refused(&[VertexId(3), VertexId(4)]), Error::Source(_)));
    Ok(())
}

pub fn a_front_that_goes_on_for_long_is_given_up(device: &Device) -> Result<(), Failed> {
    let surface = surface(&shapes::strip(1.0, 400.0, 2));
    let mut field = device.field(&surface)?;
    field.limit_rounds(1);
    let error = pollster::block_on(field.solve(&[VertexId(0)])).expect_err("no front is so fast");
    assert!(matches!(error, Error::NotFinished { rounds: 1.. }), "{error}");
    field.limit_rounds(1000);
    // What was left of it is forgotten.
    let (values, _) = solved(&mut field, &[VertexId(1)])?;
    compare(&values, &exact(&surface, &[VertexId(1)]), surface.mean_edge(), BOUNDS)
}

pub fn sources_that_are_not_there_are_refused(device: &Device) -> Result<(), Failed> {
    let surface = surface(&Soup::single("triangle", vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]));
    let mut field = device.field(&surface)?;
    let none = pollster::block_on(field.solve::<Place>(&[])).expect_err("no source");
    assert_eq!(none, Error::NoSource);
    let beyond = pollster::block_on(field.solve(&[VertexId(3)])).expect_err("no such vertex");
    assert_eq!(beyond.to_string(), "vertex 3 does not exist; there are 3, counted from 0");
    pollster::block_on(field.solve(&[VertexId(2)]))?;
    let values = pollster::block_on(field.read())?;
    for (value, right) in values.into_iter().zip([1.0, 2_f32.sqrt(), 0.0]) {
        assert!((value - right).abs() <= 4.0 * f32::EPSILON, "{value} for {right}: a few roundings");
    }
    Ok(())
}
