//! What modules answer with: messages are plain objects, and those that both solvers give are here.

use heatwalk_message::Message;
use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;

/// A plain object with these properties.
#[must_use]
pub fn object(properties: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in properties {
        // Setting a property of a plain object cannot fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}

/// A distance field at the drawn vertices.
#[derive(Message)]
pub struct Field {
    /// One value a drawn vertex of the surface, or a corner of a drawn triangle (see `byCorner`); Infinity where no source can be reached.
    pub distance: Vec<f32>,
    /// Of tetrahedra: one value a vertex of the input; undefined for a surface.
    pub inner: Option<Vec<f32>>,
    /// Whether values are those of corners, `#F × 3`: walls part vertices.
    pub by_corner: bool,
    /// Largest finite distance, on the surface or inside.
    pub max_distance: f64,
    /// Vertices that no source reaches, those in walls apart.
    pub unreachable_vertices: usize,
    /// Values below this are exact; Infinity when all are.
    pub exact_below: f64,
    /// Share of the reachable vertices whose value is exact, 0 to 1.
    pub exact_share: f64,
    /// m in t = m h², as asked for or chosen; undefined where the field was not found by heat.
    pub time_factor: Option<f64>,
    /// Windows of each half-edge that the field was found by, 0 where vertices alone carried it; undefined where there are none.
    pub windows: Option<u16>,
    /// How far the field was off before it was refined; undefined until all of it is exact.
    pub error: Option<FieldError>,
}

/// Relative to the exact distance, over the reachable vertices off the sources; 0.01 is one percent.
#[derive(Message)]
pub struct FieldError {
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

/// A path from its start to the source, on the surface or inside, as it is drawn.
#[derive(Message)]
pub struct DrawPath {
    /// `#P × 3`, from the start to the source, as they are drawn.
    pub points: Vec<f32>,
    /// `#P × 3`, the same points in the axes and the unit of the file.
    pub places: Vec<f64>,
    /// `#P × 3`, unit normals of the surface at the points; inside, upward across the path.
    pub normals: Vec<f32>,
    /// Its length in the file's unit, in the pose that distances are measured in.
    pub length: f64,
    /// How far its ends are apart, in the file's unit.
    pub straight: f64,
    /// What walking it costs: its length, each segment times what a unit of it costs.
    pub cost: f64,
    /// `#P − 1`, what a unit of each segment costs; empty where all cost 1.
    pub segment_costs: Vec<f32>,
    /// Length of the line through the points, as it is drawn.
    pub drawn_length: f32,
}
