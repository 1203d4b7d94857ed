//! What the page gets of tetrahedra.

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_bindings::{DrawPath, Field, Message};
use heatwalk_scene::DrawTransform;
use heatwalk_volume::fill::FillReport;
use heatwalk_volume::io::CellCounts;
use heatwalk_volume::{TetMesh, VolumeDistance, VolumeMethod, VolumePath};

use crate::drawn::Drawn;

/// How tetrahedra came about.
pub(crate) enum Origin {
    File(CellCounts),
    Code,
    Fill(FillReport),
}

/// What tetrahedra are and how they came about, in counts and in the file's unit.
#[derive(Message)]
pub struct InnerReport {
    /// Number of tetrahedra.
    pub tetrahedra: usize,
    /// Number of their vertices.
    pub vertices: usize,
    /// Vertices of the input.
    pub input_vertices: usize,
    /// Connected components.
    pub components: usize,
    /// Of all tetrahedra, in the unit cubed.
    pub volume: f64,
    /// The least dihedral angle, in degrees.
    pub least_angle: f64,
    /// The largest dihedral angle, in degrees.
    pub largest_angle: f64,
    /// Mean length of the edges.
    pub mean_edge: f64,
    /// Left out because they have no volume, or repeat another.
    pub left_out: usize,
    /// Turned to be oriented alike.
    pub turned: usize,
    /// Whether a surface was filled.
    pub is_filled: bool,
    /// Holes of the surface that were closed when it was filled.
    pub holes: usize,
    /// How far the boundary is from the surface that was filled, at most.
    pub deviation: f64,
    /// What was done to the cells of the file, in words; empty where nothing was.
    pub remark: String,
}

impl InnerReport {
    pub(crate) fn new(mesh: &TetMesh, origin: &Origin) -> Self {
        let (report, quality) = (mesh.report(), mesh.quality());
        let (holes, deviation) = match origin {
            Origin::Fill(filled) => (filled.holes, filled.deviation),
            Origin::File(_) | Origin::Code => (0, 0.0),
        };
        Self {
            tetrahedra: report.tetrahedra,
            vertices: report.vertices,
            input_vertices: report.input_vertices,
            components: report.components,
            volume: report.volume,
            least_angle: quality.least_angle,
            largest_angle: quality.largest_angle,
            mean_edge: mesh.mean_edge(),
            left_out: (report.flat_tetrahedra + report.duplicate_tetrahedra),
            turned: report.inverted_tetrahedra,
            is_filled: matches!(origin, Origin::Fill(_)),
            holes,
            deviation,
            remark: if let Origin::File(cells) = origin { cells.to_string() } else { String::new() },
        }
    }
}

/// Distance inside, at the drawn vertices and at those of the input.
pub(crate) fn field(drawn: &Drawn, distance: &VolumeDistance, time_factor: Option<f64>) -> Field {
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
            let (least, bent) = bent.fold((f64::INFINITY, 0), |(least, count), value| (least.min(value), count + 1));
            (least, count - unreachable - bent)
        }
    };
    Field {
        distance: drawn.spread(&distance.values),
        inner: Some(drawn.to_inputs(&distance.values)),
        by_corner: false,
        max_distance: distance.max(),
        unreachable_vertices: unreachable,
        exact_below,
        exact_share: exact as f64 / (count - unreachable).max(1) as f64,
        time_factor: time_factor.filter(|_| distance.method == VolumeMethod::Heat),
        windows: None,
        error: None,
    }
}

/// A path inside, from its start to the source.
pub(crate) fn draw_path(path: &VolumePath, transform: &DrawTransform) -> DrawPath {
    let places: Vec<DVec3> = path.points.iter().map(|&point| transform.place(point).as_dvec3()).collect();
    let heading = |at: usize| {
        let [before, after] = [at.saturating_sub(1), (at + 1).min(places.len() - 1)];
        (places[after] - places[before]).normalize_or(DVec3::X)
    };
    DrawPath {
        points: places.iter().flat_map(|place| place.as_vec3().to_array()).collect(),
        places: path.points.iter().flat_map(|point| point.to_array()).collect(),
        normals: (0..places.len()).flat_map(|at| upright(heading(at)).as_vec3().to_array()).collect(),
        length: path.length,
        straight: match (path.points.first(), path.points.last()) {
            (Some(first), Some(last)) => first.distance(*last),
            _ => 0.0,
        },
        cost: path.cost,
        segment_costs: Vec::new(),
        drawn_length: transform.length(path.length),
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
