//! What the page gets: objects whose properties, made plain by `toJSON`, are the messages of the page's protocol.

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_scene::DrawTransform;
use heatwalk_volume::fill::FillReport;
use heatwalk_volume::io::CellCounts;
use heatwalk_volume::{TetMesh, VolumeDistance, VolumeMethod, VolumePath};
use js_sys::Float32Array;
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;

/// How tetrahedra came about.
pub(crate) enum Origin {
    File(CellCounts),
    Code,
    Fill(FillReport),
}

/// What tetrahedra are and how they came about, in counts and in the file's unit.
#[wasm_bindgen(inspectable)]
pub struct InnerReport {
    /// Number of tetrahedra.
    pub tetrahedra: u32,
    /// Number of their vertices.
    pub vertices: u32,
    /// Vertices of the input.
    #[wasm_bindgen(js_name = inputVertices)]
    pub input_vertices: u32,
    /// Connected components.
    pub components: u32,
    /// Of all tetrahedra, in the unit cubed.
    pub volume: f64,
    /// The least dihedral angle, in degrees.
    #[wasm_bindgen(js_name = leastAngle)]
    pub least_angle: f64,
    /// The largest dihedral angle, in degrees.
    #[wasm_bindgen(js_name = largestAngle)]
    pub largest_angle: f64,
    /// Mean length of the edges.
    #[wasm_bindgen(js_name = meanEdge)]
    pub mean_edge: f64,
    /// Left out because they have no volume, or repeat another.
    #[wasm_bindgen(js_name = leftOut)]
    pub left_out: u32,
    /// Turned to be oriented alike.
    pub turned: u32,
    /// Whether a surface was filled.
    #[wasm_bindgen(js_name = isFilled)]
    pub is_filled: bool,
    /// Holes of the surface that were closed when it was filled.
    pub holes: u32,
    /// How far the boundary is from the surface that was filled, at most.
    pub deviation: f64,
    remark: String,
}

impl InnerReport {
    pub(crate) fn new(mesh: &TetMesh, origin: &Origin) -> Self {
        let (report, quality) = (mesh.report(), mesh.quality());
        let (holes, deviation) = match origin {
            Origin::Fill(filled) => (filled.holes, filled.deviation),
            Origin::File(_) | Origin::Code => (0, 0.0),
        };
        Self {
            tetrahedra: report.tetrahedra as u32,
            vertices: report.vertices as u32,
            input_vertices: report.input_vertices as u32,
            components: report.components as u32,
            volume: report.volume,
            least_angle: quality.least_angle,
            largest_angle: quality.largest_angle,
            mean_edge: mesh.mean_edge(),
            left_out: (report.flat_tetrahedra + report.duplicate_tetrahedra) as u32,
            turned: report.inverted_tetrahedra as u32,
            is_filled: matches!(origin, Origin::Fill(_)),
            holes: holes as u32,
            deviation,
            remark: if let Origin::File(cells) = origin { cells.to_string() } else { String::new() },
        }
    }
}

#[wasm_bindgen]
impl InnerReport {
    /// What was done to the cells of the file, in words; empty where nothing was.
    #[wasm_bindgen(getter)]
    pub fn remark(&self) -> String {
        self.remark.clone()
    }
}

/// Distance inside, at the drawn vertices.
#[wasm_bindgen(inspectable)]
pub struct InnerField {
    values: Vec<f32>,
    inner: Vec<f32>,
    max: f64,
    unreachable: u32,
    exact_below: f64,
    exact_share: f64,
    time_factor: Option<f64>,
}

impl InnerField {
    pub(crate) fn new(drawn: &Drawn, distance: &VolumeDistance, time_factor: Option<f64>) -> Self {
        let count = distance.values.len();
        let unreachable = distance.unreachable();
        let (exact_below, exact) = match distance.method {
            VolumeMethod::Heat => {
                let below = distance.exact_below;
                (below, distance.values.iter().filter(|&&value| value < below).count())
            }
            VolumeMethod::March => {
                let bent = (0..count).filter(|&vertex| !distance.is_straight(VertexId(vertex as u32)));
                let bent = bent.map(|vertex| distance.values[vertex]).filter(|value| value.is_finite());
                let (least, bent) =
                    bent.fold((f64::INFINITY, 0), |(least, count), value| (least.min(value), count + 1));
                (least, count - unreachable - bent)
            }
        };
        Self {
            values: drawn.spread(&distance.values),
            inner: drawn.to_inputs(&distance.values),
            max: distance.max(),
            unreachable: unreachable as u32,
            exact_below,
            exact_share: exact as f64 / (count - unreachable).max(1) as f64,
            time_factor: time_factor.filter(|_| distance.method == VolumeMethod::Heat),
        }
    }
}

#[wasm_bindgen]
impl InnerField {
    /// One value a drawn vertex; Infinity where no source can be reached.
    #[wasm_bindgen(getter)]
    pub fn distance(&self) -> Float32Array {
        self.values.as_slice().into()
    }

    /// One value a vertex of the input; Infinity where no source can be reached.
    #[wasm_bindgen(getter)]
    pub fn inner(&self) -> Float32Array {
        self.inner.as_slice().into()
    }

    /// Values are those of vertices.
    #[wasm_bindgen(getter, js_name = byCorner)]
    pub fn is_by_corner(&self) -> bool {
        false
    }

    /// Largest finite distance, inside or on the boundary.
    #[wasm_bindgen(getter, js_name = maxDistance)]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// Vertices that no source reaches.
    #[wasm_bindgen(getter, js_name = unreachableVertices)]
    pub fn unreachable(&self) -> u32 {
        self.unreachable
    }

    /// Values below this are exact; Infinity when all are.
    #[wasm_bindgen(getter, js_name = exactBelow)]
    pub fn exact_below(&self) -> f64 {
        self.exact_below
    }

    /// Share of the reachable vertices whose value is exact, 0 to 1.
    #[wasm_bindgen(getter, js_name = exactShare)]
    pub fn exact_share(&self) -> f64 {
        self.exact_share
    }

    /// Undefined: there are no windows.
    #[wasm_bindgen(getter)]
    pub fn windows(&self) -> Option<u16> {
        None
    }

    /// m in t = m h²; undefined where the field was found by the march.
    #[wasm_bindgen(getter, js_name = timeFactor)]
    pub fn time_factor(&self) -> Option<f64> {
        self.time_factor
    }
}

/// A path inside, from its start to the source.
#[wasm_bindgen(inspectable)]
pub struct InnerPath {
    points: Vec<f32>,
    normals: Vec<f32>,
    length: f64,
    straight: f64,
    drawn_length: f32,
    cost: f64,
}

impl InnerPath {
    pub(crate) fn new(path: &VolumePath, transform: &DrawTransform) -> Self {
        let places: Vec<DVec3> = path.points.iter().map(|&point| transform.place(point).as_dvec3()).collect();
        let heading = |at: usize| {
            let [before, after] = [at.saturating_sub(1), (at + 1).min(places.len() - 1)];
            (places[after] - places[before]).normalize_or(DVec3::X)
        };
        Self {
            points: places.iter().flat_map(|place| place.as_vec3().to_array()).collect(),
            normals: (0..places.len()).flat_map(|at| upright(heading(at)).as_vec3().to_array()).collect(),
            length: path.length,
            straight: match (path.points.first(), path.points.last()) {
                (Some(first), Some(last)) => first.distance(*last),
                _ => 0.0,
            },
            drawn_length: transform.length(path.length),
            cost: path.cost,
        }
    }
}

/// Upward as it is drawn, across a heading.
fn upright(heading: DVec3) -> DVec3 {
    let across = |up: DVec3| (up - heading * heading.dot(up)).try_normalize();
    // Straight up or down there is no such direction: forward is as good.
    if heading.y.abs() < STEEPEST { across(DVec3::Y) } else { across(DVec3::Z) }.unwrap_or(DVec3::Y)
}

/// Share of a unit heading that is upward from which on walkers lie on their backs.
const STEEPEST: f64 = 0.999;

#[wasm_bindgen]
impl InnerPath {
    /// `#P × 3`, from the start to the source, as they are drawn.
    #[wasm_bindgen(getter)]
    pub fn points(&self) -> Float32Array {
        self.points.as_slice().into()
    }

    /// `#P × 3`, unit vectors upward at the points, across the path.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.normals.as_slice().into()
    }

    /// Its length in the file's unit.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// How far its ends are apart, in the file's unit.
    #[wasm_bindgen(getter)]
    pub fn straight(&self) -> f64 {
        self.straight
    }

    /// What it costs.
    #[wasm_bindgen(getter)]
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// Empty: all cost 1.
    #[wasm_bindgen(getter, js_name = segmentCosts)]
    pub fn segment_costs(&self) -> Float32Array {
        Float32Array::default()
    }

    /// Length of the line through the points.
    #[wasm_bindgen(getter, js_name = drawnLength)]
    pub fn drawn_length(&self) -> f32 {
        self.drawn_length
    }
}
