use glam::Vec3;

use crate::buffer::Instances;
use crate::context::Context;
use crate::error::Error;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::solid::{Detail, Solid, SolidBuffers};
use crate::vertex::vertex_layout;
use heatwalk_bake::Picker;

/// Arrows at most: more would hide the surface, and each other.
const MOST: usize = 4_000;
/// Length of an arrow, as a share of the side of the square that it has for itself, and in bounding radii at most.
const LENGTH: f32 = 0.7;
const LONGEST: f32 = 0.05;

/// World space.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Arrow {
    middle: Vec3,
    vector: Vec3,
}

const ARROW: wgpu::VertexBufferLayout<'static> = vertex_layout!(Arrow, per Instance: 3 => middle, 4 => vector);

/// Draws a vector field, an arrow a triangle, and one within the solid.
pub(crate) struct Arrows {
    pipeline: wgpu::RenderPipeline,
    /// Of those within the solid, once there were some.
    inner_pipeline: Option<wgpu::RenderPipeline>,
    solid: SolidBuffers,
    instances: Instances<Arrow>,
    inner: Instances<Arrow>,
}

impl Arrows {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let mut solid = Solid::new(Detail::COARSE);
        // A dart: blunt behind, pointed ahead.
        solid.turned(Vec3::NEG_Y * 0.5, Vec3::Y, &[(0.0, 0.001), (0.0, 0.17), (0.06, 0.17), (1.0, 0.004)], [0.0; 2]);
        Ok(Self {
            pipeline: pipeline(context, shared, ["vs_arrow", "fs_arrow"]),
            inner_pipeline: None,
            solid: solid.upload(context)?,
            instances: Instances::new("arrows"),
            inner: Instances::new("inner arrows"),
        })
    }

    /// One vector a triangle; those of no length have no arrow. On a fine mesh some triangles go without, evenly over the
    /// surface. `radius` is the surface's bounding radius.
    pub(crate) fn set(&mut self, context: &Context, picker: &Picker, vectors: &[Vec3], radius: f32) {
        let step = vectors.len().div_ceil(MOST).max(1);
        let arrows = picker.in_leaf_order().iter().step_by(step).filter_map(|&triangle| {
            let direction = vectors[triangle as usize].try_normalize()?;
            let [a, b, c] = picker.corners(triangle).map(|vertex| picker.positions()[vertex as usize]);
            let side = (0.5 * (b - a).cross(c - a).length() * step as f32).sqrt();
            let vector = (LENGTH * side).min(LONGEST * radius) * direction;
            Some(Arrow { middle: (a + b + c) / 3.0, vector })
        });
        self.instances.set(context, arrows);
    }

    /// Takes those of the surface away.
    pub(crate) fn clear(&mut self) {
        self.instances.clear();
    }

    /// Takes those within the solid away.
    pub(crate) fn clear_inner(&mut self) {
        self.inner.clear();
    }

    /// Replaces the arrows within the solid, one vector a place; those of no length have none. Where places are close, some go
    /// without, evenly over the solid. `radius` is the surface's bounding radius.
    pub(crate) fn set_inner(
        &mut self,
        (context, shared): (&Context, &Shared),
        places: &[Vec3],
        vectors: &[Vec3],
        radius: f32,
    ) {
        let size = LONGEST * radius;
        let arrows = apart(places, size / LENGTH).into_iter().filter_map(|index| {
            let direction = vectors[index].try_normalize()?;
            Some(Arrow { middle: places[index], vector: size * direction })
        });
        self.inner.set(context, arrows);
        if !self.inner.is_empty() {
            let build = || pipeline(context, shared, ["vs_inner_arrow", "fs_inner_arrow"]);
            self.inner_pipeline.get_or_insert_with(build);
        }
    }

    /// Draws those of the surface.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(count) = self.instances.bind(pass, 1) else { return };
        pass.set_pipeline(&self.pipeline);
        self.solid.draw(pass, count);
    }

    /// Draws those within the solid.
    pub(crate) fn draw_inner(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(pipeline), Some(count)) = (&self.inner_pipeline, self.inner.bind(pass, 1)) else { return };
        pass.set_pipeline(pipeline);
        self.solid.draw(pass, count);
    }
}

fn pipeline(context: &Context, shared: &Shared, [vertex, fragment]: [&str; 2]) -> wgpu::RenderPipeline {
    PipelineRecipe {
        label: "arrow",
        layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout)],
        module: &shader_module!(context, "arrow"),
        vertex,
        fragment,
        buffers: &[Some(SolidBuffers::LAYOUT), Some(ARROW)],
        topology: wgpu::PrimitiveTopology::TriangleList,
        place: Place::Solid,
    }
    .build(context)
}

/// Indices of at most [`MOST`] places: of each cell of a grid the one that is nearest to its middle. Cells are `side` wide, or
/// more where they would be too many.
fn apart(places: &[Vec3], side: f32) -> Vec<usize> {
    let mut side = side;
    loop {
        let listed = |(index, &place): (usize, &Vec3)| {
            let cell = (place / side).floor();
            ((place / side - cell - 0.5).length_squared(), cell.as_ivec3().to_array(), index)
        };
        let mut listed: Vec<_> = places.iter().enumerate().map(listed).collect();
        listed.sort_unstable_by(|one, other| one.1.cmp(&other.1).then(one.0.total_cmp(&other.0)));
        listed.dedup_by_key(|&mut (_, cell, _)| cell);
        if listed.len() <= MOST {
            return listed.into_iter().map(|(_, _, index)| index).collect();
        }
        // At twice the volume about half of them are left.
        side *= 2_f32.cbrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_inside_are_few_and_keep_apart() {
        let axis = || (0..40).map(|step| step as f32 / 40.0);
        let places: Vec<Vec3> =
            axis().flat_map(|x| axis().flat_map(move |y| axis().map(move |z| Vec3::new(x, y, z)))).collect();
        let few = apart(&places, 0.2);
        assert_eq!(few.len(), 5 * 5 * 5);
        let nearest_to_a_middle = few.iter().all(|&index| (places[index] % 0.2 - 0.1).abs().max_element() < 0.02);
        assert!(nearest_to_a_middle);
        let many = apart(&places, 0.01).len();
        assert!(many <= MOST && many > MOST / 4, "{many} of {}", places.len());
    }
}
