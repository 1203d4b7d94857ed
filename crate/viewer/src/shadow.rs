//! Shadow maps: the scene's depth seen from the key light.
//!
//! What stands still and what moves have one each, so that a walker's step does not draw the whole surface again.

use glam::{Mat4, Vec2, Vec3};

use crate::context::{Context, DEPTH_FORMAT};
use heatwalk_bake::BoundingSphere;

/// Texels along a side.
const SIZE: u32 = 1024;
/// Room around the scene, as a factor on its bounding sphere: pins and walkers stand out from it.
const MARGIN: f32 = 1.25;

/// How far from the middle of the maps the scene's shadow can be, in clip space; soft over some texels.
pub(crate) const SHADOW_REACH: f32 = 1.0 / MARGIN + 0.02;

/// The two shadow maps.
pub(crate) struct ShadowMaps {
    pub(crate) still: wgpu::TextureView,
    pub(crate) moving: wgpu::TextureView,
}

/// Whose shadows a map holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Casters {
    Still,
    Moving,
}

/// The key light's view of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowView {
    /// Clip space of the maps.
    pub(crate) clip_from_world: Mat4,
    /// World size of a texel.
    pub(crate) texel: f32,
}

impl ShadowView {
    /// Covers a scene, with light from a direction (unit length).
    pub(crate) fn new(scene: BoundingSphere, towards: Vec3) -> Self {
        let reach = MARGIN * scene.radius;
        let (right, up) = towards.any_orthonormal_pair();
        let axes = [right, up, -towards];
        // Depth runs from the light, 0, to behind the scene, 1.
        let rows = [axes[0] / reach, axes[1] / reach, axes[2] / (2.0 * reach)];
        let offset = Vec3::new(0.0, 0.0, 0.5) - Vec3::from_array(rows.map(|row| row.dot(scene.center)));
        let columns = [0, 1, 2].map(|axis| Vec3::from_array(rows.map(|row| row[axis])).extend(0.0));
        let clip_from_world = Mat4::from_cols(columns[0], columns[1], columns[2], offset.extend(1.0));
        Self { clip_from_world, texel: 2.0 * reach / SIZE as f32 }
    }

    /// Least and greatest x and y of shadows that balls (centre, radius) cast, in clip space.
    pub(crate) fn cover(&self, balls: impl Iterator<Item = (Vec3, f32)>) -> [Vec2; 2] {
        let pixel = 2.0 / SIZE as f32;
        balls.fold([Vec2::INFINITY, Vec2::NEG_INFINITY], |[low, high], (center, radius)| {
            let place = self.clip_from_world.transform_point3(center).truncate();
            // Shadows are soft over a few texels.
            let reach = Vec2::splat(pixel * (radius / self.texel + 4.0));
            [low.min(place - reach), high.max(place + reach)]
        })
    }
}

impl ShadowMaps {
    pub(crate) fn new(context: &Context) -> Self {
        let map = |label| {
            let texture = context.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: DEPTH_FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor { label: Some(label), ..Default::default() })
        };
        Self { still: map("still shadows"), moving: map("moving shadows") }
    }

    /// Draws a map anew.
    pub(crate) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        casters: Casters,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let (label, view) = match casters {
            Casters::Still => ("still shadows", &self.still),
            Casters::Moving => ("moving shadows", &self.moving),
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(label),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        record(&mut pass);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scene_fits_and_depth_grows_away_from_the_light() {
        let scene = BoundingSphere { center: Vec3::new(3.0, -1.0, 2.0), radius: 2.0, lowest: -3.0, side: 4.0 };
        let towards = Vec3::new(-0.4, 0.8, 0.3).normalize();
        let view = ShadowView::new(scene, towards);
        let clip = |point: Vec3| view.clip_from_world.transform_point3(point);
        assert!((clip(scene.center) - Vec3::new(0.0, 0.0, 0.5)).length() < 1e-5);
        let (near, far) = (clip(scene.center + 2.0 * towards), clip(scene.center - 2.0 * towards));
        assert!(near.z > 0.0 && near.z < 0.5 && far.z > 0.5 && far.z < 1.0);
        let [low, high] = view.cover(std::iter::once((scene.center, 1.0)));
        assert!((low + high).length() < 1e-5, "around the middle");
        // Half the scene's radius, which the margin takes to 0.4, and four texels.
        assert!((high.x - 0.4 - 8.0 / SIZE as f32).abs() < 1e-5);
        for rim in [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| clip(scene.center + 2.0 * axis)) {
            assert!(rim.x.abs() < 1.0 && rim.y.abs() < 1.0);
        }
    }
}
