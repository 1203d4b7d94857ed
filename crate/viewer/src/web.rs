//! The face of the renderer towards JavaScript: converts arrays, numbers and errors, decides nothing.

use glam::{Vec2, Vec3};
use js_sys::{Float32Array, Int8Array};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext};

use crate::camera::Insets;
use crate::capture::Capture;
use crate::context::{Backend, Context};
use crate::environment::Surroundings;
use crate::error::Error;
use crate::look::{Finish, Look, Pattern};
use crate::mesh::MeshArrays;
use crate::renderer::{Renderer, SurfaceHit, numbers_from_view, view_from_numbers};

/// A canvas that shows a surface.
#[wasm_bindgen]
pub struct Viewer {
    renderer: Renderer,
    canvas: HtmlCanvasElement,
    /// wgpu does not notice when the browser takes a WebGL context away; the context itself knows.
    webgl: Option<WebGl2RenderingContext>,
}

#[wasm_bindgen]
impl Viewer {
    /// Opens WebGPU where it works, else WebGL2, and builds the pipelines.
    ///
    /// # Errors
    /// Rejects with a plain sentence when neither works.
    pub async fn create(canvas: HtmlCanvasElement, force_webgl: bool) -> Result<Viewer, JsError> {
        console_error_panic_hook::set_once();
        let (width, height) = (canvas.width(), canvas.height());
        let target = wgpu::SurfaceTarget::Canvas(canvas.clone());
        let context = Context::new(target, (width, height), force_webgl).await?;
        let renderer = Renderer::new(context)?;
        let webgl = match renderer.backend() {
            // Asking again for the kind of context a canvas already has returns that context.
            Backend::WebGl2 => canvas.get_context("webgl2").ok().flatten().map(wasm_bindgen::JsCast::unchecked_into),
            Backend::WebGpu => None,
        };
        let mut viewer = Self { renderer, canvas, webgl };
        viewer.resize(width, height);
        Ok(viewer)
    }

    /// "WebGPU" or "WebGL2".
    #[must_use]
    pub fn backend(&self) -> String {
        self.renderer.backend().name().to_owned()
    }

    /// Physical pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let css_width = self.canvas.client_width();
        // A canvas that is not laid out yet has no width.
        let pixel_ratio = if css_width > 0 { width as f32 / css_width as f32 } else { 1.0 };
        self.renderer.resize(width, height, pixel_ratio);
    }

    /// How far panels reach in from the edges, physical pixels: the view centres on what they leave free.
    pub fn set_insets(&mut self, left: f64, top: f64, right: f64, bottom: f64) {
        self.renderer.set_insets(Insets { left, top, right, bottom });
    }

    /// Replaces the surface; clears distance, pins, path and walker.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together or are too large for the device.
    pub fn set_surface(&mut self, positions: Vec<f32>, normals: Vec<f32>, triangles: Vec<u32>) -> Result<(), JsError> {
        Ok(self.renderer.set_surface(mesh_arrays(positions, normals, triangles)?)?)
    }

    /// Replaces the scenery; empty for none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together or are too large for the device.
    pub fn set_scenery(&mut self, positions: Vec<f32>, normals: Vec<f32>, triangles: Vec<u32>) -> Result<(), JsError> {
        Ok(self.renderer.set_scenery(mesh_arrays(positions, normals, triangles)?)?)
    }

    /// One value a drawn vertex, Infinity = unreachable, and the direction in which it grows, four numbers a drawn vertex,
    /// 127 for a unit; empty = no field.
    ///
    /// # Errors
    /// Throws when the numbers of values are not those of the surface's vertices.
    pub fn set_field(&mut self, values: &Float32Array, tangents: &Int8Array, max: f32) -> Result<(), JsError> {
        let count = values.length() as usize;
        let found = tangents.length() as usize;
        if found != 4 * count {
            return Err(Error::WrongLength { what: "tangents", expected: 4 * count, found }.into());
        }
        Ok(self.renderer.set_field(count, max, |distances, directions| {
            values.copy_to(distances);
            tangents.copy_to(directions);
        })?)
    }

    /// Stripes: period in model units, share of it covered, sharpness 0..1, height in periods.
    pub fn set_bands(&mut self, period: f32, width: f32, sharpness: f32, relief: f32) {
        self.change_look(|look| Look { period, pattern: Pattern::Bands { width, sharpness, relief }, ..look });
    }

    /// Thin lines: period in model units, width in CSS pixels.
    pub fn set_lines(&mut self, period: f32, width: f32) {
        self.change_look(|look| Look { period, pattern: Pattern::Lines { width }, ..look });
    }

    /// Share of the stripes' own colour, then metalness, roughness and glow of the surface and of the stripes.
    ///
    /// # Errors
    /// Throws when a finish has not three numbers.
    pub fn set_finish(&mut self, paint: f32, surface: &[f32], stripe: &[f32]) -> Result<(), JsError> {
        let (surface, stripe) = (finish("surface finish", surface)?, finish("stripe finish", stripe)?);
        self.change_look(|look| Look { paint, surface, stripe, ..look });
        Ok(())
    }

    /// Moves the pattern away from the sources; periods.
    pub fn set_offset(&mut self, offset: f32) {
        self.change_look(|look| Look { offset, ..look });
    }

    /// 256 × 4 sRGB bytes over distance / max for the surface, then as many for the stripes.
    ///
    /// # Errors
    /// Throws when the length differs.
    pub fn set_ramps(&mut self, ramps: &[u8]) -> Result<(), JsError> {
        Ok(self.renderer.set_ramps(ramps)?)
    }

    /// What lights the scene: "studio", "sky" or "night", facing a camera of this yaw in radians.
    ///
    /// # Errors
    /// Throws for another name.
    pub fn set_environment(&mut self, name: &str, yaw: f32) -> Result<(), JsError> {
        let surroundings = match name {
            "studio" => Surroundings::Studio,
            "sky" => Surroundings::Sky,
            "night" => Surroundings::Night,
            other => return Err(JsError::new(&format!("There are no surroundings '{other}'."))),
        };
        self.renderer.set_environment(surroundings, yaw);
        Ok(())
    }

    /// Draws the scene beside the canvas, `scale` times as large; `clear` leaves the background transparent.
    ///
    /// # Errors
    /// Throws when that is more than the device can draw.
    pub fn capture(&mut self, scale: f32, clear: bool) -> Result<Picture, JsError> {
        Ok(Picture(self.renderer.capture(scale, clear)?))
    }

    /// Colours of the upper and lower edge; sRGB 0..1.
    ///
    /// # Errors
    /// Throws when a colour has not three numbers.
    pub fn set_background(&mut self, top: &[f32], bottom: &[f32]) -> Result<(), JsError> {
        self.renderer.set_background(color("top color", top)?, color("bottom color", bottom)?);
        Ok(())
    }

    /// `#P × 3` positions and normals; selected −1 = none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together.
    pub fn set_pins(&mut self, positions: &[f32], normals: &[f32], selected: i32) -> Result<(), JsError> {
        let selected = usize::try_from(selected).ok();
        Ok(self.renderer.set_pins(&points("pin positions", positions)?, &points("pin normals", normals)?, selected)?)
    }

    /// `#P × 3` points and normals from start to source; empty = none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together.
    pub fn set_path(&mut self, path: &[f32], normals: &[f32]) -> Result<(), JsError> {
        Ok(self.renderer.set_path(&points("path points", path)?, &points("path normals", normals)?)?)
    }

    /// `#F × 3` vectors, of any length, drawn as arrows; empty = none.
    ///
    /// # Errors
    /// Throws when their number is not that of the surface's triangles.
    pub fn set_arrows(&mut self, vectors: &[f32]) -> Result<(), JsError> {
        Ok(self.renderer.set_arrows(&points("arrows", vectors)?)?)
    }

    /// Takes all edges away.
    pub fn clear_edges(&mut self) {
        self.renderer.clear_edges();
    }

    /// Adds `#E × 2 × 3` ends of edges in an sRGB colour, 0..1.
    ///
    /// # Errors
    /// Throws when the numbers are no pairs of points or the colour has not three numbers.
    pub fn add_edges(&mut self, ends: &[f32], rgb: &[f32]) -> Result<(), JsError> {
        let (pairs, rest) = ends.as_chunks::<6>();
        if !rest.is_empty() {
            return Err(Error::WrongLength { what: "edges", expected: 6 * pairs.len(), found: ends.len() }.into());
        }
        let ends: Vec<[Vec3; 2]> =
            pairs.iter().map(|&[a, b, c, d, e, f]| [Vec3::new(a, b, c), Vec3::new(d, e, f)]).collect();
        self.renderer.add_edges(&ends, color("edge color", rgb)?);
        Ok(())
    }

    /// Stands the walker at an arc length of the path.
    pub fn set_walker(&mut self, arc: f32) {
        self.renderer.set_walker(arc);
    }

    /// `#walkers × 10`: position, unit normal, unit heading, length walked; empty = none.
    ///
    /// # Errors
    /// Throws when the numbers are no tens.
    pub fn set_crowd(&mut self, poses: &[f32]) -> Result<(), JsError> {
        let (walkers, rest) = poses.as_chunks();
        if !rest.is_empty() {
            let expected = poses.len() - rest.len();
            return Err(Error::WrongLength { what: "poses", expected, found: poses.len() }.into());
        }
        self.renderer.set_crowd(walkers);
        Ok(())
    }

    /// Takes the walker away.
    pub fn hide_walker(&mut self) {
        self.renderer.hide_walker();
    }

    /// Turns around the target; CSS pixels.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        self.renderer.move_camera(|camera| camera.orbit(dx, dy));
    }

    /// A hand takes hold to turn.
    pub fn hold(&mut self) {
        self.renderer.move_camera(crate::camera::Camera::hold);
    }

    /// The hand lets go; the camera glides on or stops.
    pub fn let_go(&mut self, glides: bool) {
        self.renderer.move_camera(|camera| camera.let_go(glides));
    }

    /// Turns by itself, in radians a second; 0 stops.
    pub fn set_spin(&mut self, spin: f64) {
        self.renderer.move_camera(|camera| camera.set_spin(spin));
    }

    /// Moves the target along the screen; CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.renderer.move_camera(|camera| camera.pan(dx, dy));
    }

    /// Above 1 is nearer.
    pub fn zoom(&mut self, factor: f64) {
        self.renderer.move_camera(|camera| camera.zoom(factor));
    }

    /// Fits surface and scenery into the window, smoothly.
    pub fn frame(&mut self) {
        self.renderer.move_camera(crate::camera::Camera::frame);
    }

    /// Moves the target to a world point, smoothly.
    pub fn focus(&mut self, x: f32, y: f32, z: f32) {
        self.renderer.move_camera(|camera| camera.focus(Vec3::new(x, y, z)));
    }

    /// Yaw and pitch in radians, distance and target offset in bounding radii.
    #[must_use]
    pub fn camera(&self) -> Vec<f64> {
        numbers_from_view(self.renderer.view()).to_vec()
    }

    /// Sets what `camera` returns, at once.
    ///
    /// # Errors
    /// Throws when there are not six finite numbers.
    pub fn set_camera(&mut self, camera: &[f64]) -> Result<(), JsError> {
        let numbers = <[f64; 6]>::try_from(camera)
            .ok()
            .filter(|numbers| numbers.iter().all(|number| number.is_finite()))
            .ok_or_else(|| JsError::new("A camera is six finite numbers."))?;
        self.renderer.move_camera(|camera| camera.set_view(view_from_numbers(numbers)));
        Ok(())
    }

    /// The nearest place of the surface under a physical pixel that scenery does not hide.
    #[must_use]
    pub fn pick(&self, x: f32, y: f32) -> Option<Hit> {
        self.renderer.pick(Vec2::new(x, y)).map(Hit)
    }

    /// Physical pixel and depth of a world point; undefined behind the camera.
    #[must_use]
    pub fn project(&self, x: f32, y: f32, z: f32) -> Option<Vec<f32>> {
        self.renderer.project(Vec3::new(x, y, z)).map(|pixel| pixel.to_array().to_vec())
    }

    /// True if something changed since the last frame or an animation runs.
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.is_taken() || self.renderer.needs_frame()
    }

    /// Draws one frame; false when the canvas was lost and the viewer must be created again.
    pub fn render(&mut self, seconds: f64) -> bool {
        !self.is_taken() && self.renderer.render(seconds)
    }
}

impl Viewer {
    fn change_look(&mut self, change: impl FnOnce(Look) -> Look) {
        self.renderer.set_look(change(self.renderer.look()));
    }

    fn is_taken(&self) -> bool {
        self.webgl.as_ref().is_some_and(WebGl2RenderingContext::is_context_lost)
    }
}

/// A place on the surface.
#[wasm_bindgen]
pub struct Hit(SurfaceHit);

#[wasm_bindgen]
impl Hit {
    /// Index of the triangle.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn triangle(&self) -> u32 {
        self.0.triangle
    }

    /// Barycentric weights of its corners.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn weights(&self) -> Vec<f32> {
        self.0.weights.to_array().to_vec()
    }

    /// World position.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn point(&self) -> Vec<f32> {
        self.0.point.to_array().to_vec()
    }

    /// Unit normal.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn normal(&self) -> Vec<f32> {
        self.0.normal.to_array().to_vec()
    }
}

/// A picture on its way from the graphics device.
#[wasm_bindgen]
pub struct Picture(Capture);

#[wasm_bindgen]
impl Picture {
    /// Pixels across.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn width(&self) -> u32 {
        self.0.size().0
    }

    /// Pixels down.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn height(&self) -> u32 {
        self.0.size().1
    }

    /// To be asked until it is true.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.0.is_ready()
    }

    /// RGBA, sRGB bytes from the top row, when ready; frees the picture.
    #[must_use]
    pub fn into_pixels(self) -> Vec<u8> {
        self.0.into_pixels()
    }
}

fn finish(what: &'static str, numbers: &[f32]) -> Result<Finish, Error> {
    let &[metalness, roughness, glow] = numbers else {
        return Err(Error::WrongLength { what, expected: 3, found: numbers.len() });
    };
    Ok(Finish { metalness, roughness, glow })
}

fn points(what: &'static str, numbers: &[f32]) -> Result<Vec<Vec3>, Error> {
    let (triples, rest) = numbers.as_chunks::<3>();
    if rest.is_empty() {
        Ok(triples.iter().copied().map(Vec3::from_array).collect())
    } else {
        Err(Error::WrongLength { what, expected: 3 * triples.len(), found: numbers.len() })
    }
}

fn color(what: &'static str, numbers: &[f32]) -> Result<Vec3, Error> {
    <[f32; 3]>::try_from(numbers).map(Vec3::from_array).map_err(|_| Error::WrongLength {
        what,
        expected: 3,
        found: numbers.len(),
    })
}

/// Takes an array over as triples, without a copy.
fn triples<N: bytemuck::Pod, T: bytemuck::Pod>(what: &'static str, numbers: Vec<N>) -> Result<Vec<T>, Error> {
    let found = numbers.len();
    bytemuck::allocation::try_cast_vec(numbers).map_err(|_| Error::WrongLength { what, expected: found / 3 * 3, found })
}

fn mesh_arrays(positions: Vec<f32>, normals: Vec<f32>, triangles: Vec<u32>) -> Result<MeshArrays, Error> {
    Ok(MeshArrays {
        positions: triples("positions", positions)?,
        normals: triples("normals", normals)?,
        triangles: triples("triangle indices", triangles)?,
    })
}
