//! Questions about distance and paths inside, and their answers.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{EdgeKind, FaceField, MemoryLimit};
use heatwalk_bindings::{DrawPath, Failure, Field, Result, logarithms, parameters, reporter};
use heatwalk_volume::crowd::VolumePose;
use heatwalk_volume::io::write;
use heatwalk_volume::{TetMesh, TetSoup, VolumeCrowd, VolumeDistance, VolumeMethod, VolumeOptions, VolumeSolver};
use js_sys::{Array, Function, Object};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::results::{draw_path, field};
use crate::view::InnerView;

/// Most memory of factors where no limit is given. In three dimensions more take half a minute and longer, and what the work on
/// them leaves free in between need not hold the last of them even below 4 GiB.
const MOST_OF_FACTORS: MemoryLimit = MemoryLimit::Bytes(1 << 30);

/// Starts the crowd's random numbers: the same walkers every time.
const CROWD_SEED: u64 = 1;

/// Distances and paths inside, and what there is to see of them.
#[wasm_bindgen]
pub struct InnerSolver {
    mesh: Arc<TetMesh>,
    drawn: Drawn,
    solver: VolumeSolver,
    options: VolumeOptions,
    distance: Option<VolumeDistance>,
    crowd: Option<VolumeCrowd>,
}

impl InnerSolver {
    pub(crate) fn new(mesh: &Arc<TetMesh>, drawn: Drawn) -> Self {
        Self {
            mesh: Arc::clone(mesh),
            drawn,
            solver: VolumeSolver::new(Arc::clone(mesh)),
            options: VolumeOptions::default(),
            distance: None,
            crowd: None,
        }
    }

    fn answer(&mut self, sources: &Array, options: &VolumeOptions) -> Result<Field> {
        let sources = sources.iter().map(|source| self.drawn.source(&source)).collect::<Result<Vec<_>>>()?;
        let distance = self.solver.distance(&sources, options)?;
        let answer = field(&self.drawn, &distance, self.solver.time_factor());
        self.distance = Some(distance);
        self.lead_crowd()?;
        Ok(answer)
    }

    fn lead_crowd(&mut self) -> Result<()> {
        if let (Some(crowd), Some(distance)) = (&mut self.crowd, &self.distance) {
            crowd.follow(&self.solver, distance.clone())?;
        }
        Ok(())
    }

    fn solved(&self) -> Result<&VolumeDistance> {
        self.distance.as_ref().ok_or_else(|| heatwalk::Error::NoSource.into())
    }
}

#[wasm_bindgen]
impl InnerSolver {
    /// Factors for the heat method with these parameters, or again what the change needs; forgets the field. Factors of more than
    /// 2 GiB are refused before they are made, unless the parameters have another limit.
    pub fn configure(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Partial<Parameters>")] given: &Object,
        #[wasm_bindgen(unchecked_param_type = "Progress")] progress: &Function,
    ) -> Result<()> {
        self.options.heat = parameters(given)?;
        if self.options.heat.memory == MemoryLimit::Automatic {
            self.options.heat.memory = MOST_OF_FACTORS;
        }
        let by_heat = VolumeOptions { method: VolumeMethod::Heat, ..self.options };
        self.distance = None;
        Ok(self.solver.prepare(&by_heat, &mut reporter(progress))?)
    }

    /// Stored entries of all factors together; 0 where nothing is factored.
    pub fn factor_nonzeros(&self) -> f64 {
        self.solver.factor_nonzeros() as f64
    }

    /// Distance to the nearest of `sources` by heat; with a small exact region when `quick`.
    pub fn solve(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly object[]")] sources: &Array,
        quick: bool,
    ) -> Result<Field> {
        let options = VolumeOptions { method: VolumeMethod::Heat, ..self.options };
        self.answer(sources, &if quick { options.quick() } else { options })
    }

    /// Distance to the nearest of `sources` by the march of waves. Needs no factors.
    pub fn propagate(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly object[]")] sources: &Array,
    ) -> Result<Field> {
        let options = VolumeOptions { method: VolumeMethod::March, ..self.options };
        self.answer(sources, &options)
    }

    /// The path from a place to its nearest source.
    pub fn path(&self, #[wasm_bindgen(unchecked_param_type = "object")] from: &JsValue) -> Result<DrawPath> {
        let path = self.solver.path(self.solved()?, self.drawn.point(from)?)?;
        Ok(draw_path(&path, &self.drawn.transform))
    }

    /// The last field at a place, in the file's unit, Infinity where no source reaches it: see [`VolumeSolver::at`].
    pub fn distance_at(&self, #[wasm_bindgen(unchecked_param_type = "object")] place: &JsValue) -> Result<f64> {
        Ok(self.solver.at(self.solved()?, self.drawn.point(place)?)?)
    }

    /// `#F × 3`, the drawn triangles beside each drawn one, across the edges from its corners to the next; itself where there is none.
    pub fn neighbors(&self) -> Vec<u32> {
        self.drawn.neighbors()
    }

    /// The shortest line along edges from one vertex of the input to another, both included.
    pub fn line(&self, from: u32, to: u32) -> Result<Vec<u32>> {
        self.drawn.line([from, to])
    }

    /// A shortest path between two places, by the march from the second; the field stays as it is.
    pub fn measure(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "object")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "object")] to: &JsValue,
    ) -> Result<DrawPath> {
        let [from, to] = [self.drawn.point(from)?, self.drawn.point(to)?];
        let options = VolumeOptions { method: VolumeMethod::March, ..VolumeOptions::default() };
        let distance = self.solver.distance(&[to], &options)?;
        Ok(draw_path(&self.solver.path(&distance, from)?, &self.drawn.transform))
    }

    /// `#D × 4`: direction in which the last field grows, 127 for a unit; the fourth number is 0.
    pub fn tangents(&self) -> Result<Vec<i8>> {
        let gradients = self.solved()?.gradient(&self.mesh)?;
        let mut directions = vec![DVec3::ZERO; self.mesh.vertex_count()];
        for (corners, gradient) in self.mesh.tetrahedra().iter().zip(gradients) {
            for &corner in corners {
                directions[corner as usize] += gradient;
            }
        }
        directions.iter_mut().for_each(|direction| *direction = direction.normalize_or_zero());
        Ok(self.drawn.spread_directions(&directions))
    }

    /// `#F × 3`: unit vectors along the gradient of "heat", or the gradient of "distance", in the tetrahedra at the drawn triangles.
    pub fn gradients(&self, #[wasm_bindgen(unchecked_param_type = "FaceField")] kind: &str) -> Result<Vec<f32>> {
        let distance = self.solved()?;
        let vectors = match kind.parse()? {
            FaceField::Distance => distance.gradient(&self.mesh)?,
            FaceField::Heat => distance.heat_directions(&self.mesh)?,
        };
        Ok(self.drawn.spread_vectors(&vectors))
    }

    /// `#D`: log10 of the last field's heat over its maximum, −∞ where there is none.
    pub fn heat(&self) -> Result<Vec<f32>> {
        let heat = self.solved()?.heat().ok_or(heatwalk::Error::NoHeat)?;
        Ok(self.drawn.spread(&logarithms(heat).collect::<Vec<_>>()))
    }

    /// `#E × 2 × 3`: ends of the edges of the boundary for "mesh", as they are drawn; of other kinds there are none.
    pub fn edges(&self, #[wasm_bindgen(unchecked_param_type = "EdgeKind")] kind: &str) -> Result<Vec<f32>> {
        let EdgeKind::Mesh = kind.parse()? else { return Ok(Vec::new()) };
        let boundary = self.mesh.boundary();
        let sides = boundary.soup.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        // Each edge has two triangles, which go along it in opposite directions.
        let ends = sides.filter(|[a, b]| a < b).flatten().map(|vertex| boundary.soup.positions[vertex as usize]);
        Ok(self.drawn.transform.places(ends))
    }

    /// What is seen of the inside.
    pub fn view(&self, #[wasm_bindgen(unchecked_param_type = "InnerCut")] wanted: &JsValue) -> Result<InnerView> {
        InnerView::new(&self.mesh, &self.drawn, self.distance.as_ref(), wanted)
    }

    /// A file of the tetrahedra with the last field, one value a vertex of the input: "csv", "vtu" or "msh". All lengths are
    /// multiplied by `scale`, and then in the unit of this symbol, which may be empty.
    pub fn file(&self, kind: &str, scale: f64, unit: &str) -> Result<Vec<u8>> {
        let mut distances = self.mesh.to_inputs(&self.solved()?.values, f64::INFINITY);
        distances.iter_mut().for_each(|distance| *distance *= scale);
        let mut soup = TetSoup::clone(self.drawn.soup());
        soup.positions.iter_mut().for_each(|position| *position *= scale);
        let unit = (!unit.is_empty()).then_some(unit);
        match kind {
            "csv" => Ok(write::csv(&distances, unit)),
            "vtu" => Ok(write::vtu(&soup, Some(&distances))),
            "msh" => Ok(write::msh(&soup, Some(&distances))),
            _ => Err(Failure::misuse("tetrahedra are written as csv, vtu or msh")),
        }
    }

    /// Changes the number of walkers; 0 sends all away.
    pub fn set_crowd(&mut self, count: u32) -> Result<()> {
        match &mut self.crowd {
            _ if count == 0 => self.crowd = None,
            Some(crowd) => crowd.set_count(count as usize),
            None => {
                self.crowd = Some(VolumeCrowd::new(Arc::clone(&self.mesh), count as usize, CROWD_SEED));
                self.lead_crowd()?;
            }
        }
        Ok(())
    }

    /// Moves the crowd by `step` down the last field and gives each walker's pose, `#walkers × 10`: position, unit vector upward and
    /// unit heading (three numbers each), and the length walked so far. Empty without a field or a crowd.
    pub fn step_crowd(&mut self, step: f64) -> Result<Vec<f32>> {
        let (Some(crowd), Some(_)) = (&mut self.crowd, &self.distance) else { return Ok(Vec::new()) };
        crowd.advance(step)?;
        let transform = &self.drawn.transform;
        let up = DVec3::from_array(DVec3::AXES.map(|axis| transform.direction(axis).y));
        let numbers = |pose: VolumePose| {
            let [up, heading] = [pose.up, pose.heading].map(|vector| transform.direction(vector).as_vec3());
            let vectors = [transform.place(pose.position), up, heading];
            vectors.into_iter().flat_map(|vector| vector.to_array()).chain([transform.length(pose.arc)])
        };
        Ok(crowd.poses(up).flat_map(numbers).collect())
    }
}
