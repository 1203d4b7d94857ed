//! A drawing that moves: drawn vertices in the poses of a model.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use heatwalk::surface::{Result, triangle};
use heatwalk::{Surface, VertexData};
use heatwalk_model::motion::Pose;
use heatwalk_model::{Model, Motion};

use crate::drawing::DrawMesh;
use crate::transform::DrawTransform;

/// Drawn vertices in a pose.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DrawPose {
    /// `#D × 3`, as the transform places them.
    pub positions: Vec<f32>,
    /// `#D × 3`, unit length, as the transform turns them.
    pub normals: Vec<f32>,
}

/// Moves a drawing from pose to pose.
#[derive(Debug, Clone)]
pub struct Posing {
    motion: Arc<Motion>,
    /// That of the file.
    rest: Pose,
    /// The present one.
    pose: Pose,
    /// `#D`, input vertices.
    inputs: Vec<u32>,
    /// `#D`, drawn vertices.
    first_of_sector: Vec<u32>,
    /// `#F × 3`, drawn vertices.
    triangles: Vec<[u32; 3]>,
}

impl Posing {
    /// Of a drawing of the surface that was built from this model; none where the model does not move.
    pub fn new(model: &Model, drawing: &DrawMesh) -> Option<Self> {
        if !model.motion.moves() {
            return None;
        }
        let rest = model.pose();
        Some(Self {
            motion: Arc::clone(&model.motion),
            pose: rest.clone(),
            rest,
            inputs: drawing.input_of_drawn.iter().map(|input| input.0).collect(),
            first_of_sector: drawing.first_of_sector.clone(),
            triangles: drawing.triangles.as_chunks().0.to_vec(),
        })
    }

    /// Takes the pose so many seconds after the beginning of a clip; without one, that of the file.
    ///
    /// # Errors
    /// As [`Motion::apply`].
    pub fn take(&mut self, moment: Option<(usize, f64)>) -> Result<()> {
        match moment {
            Some((clip, seconds)) => self.motion.apply(clip, seconds, &mut self.pose),
            None => {
                self.pose.clone_from(&self.rest);
                Ok(())
            }
        }
    }

    /// Where the vertices of the surface are, which was built from the soup.
    pub fn positions(&self, surface: &Surface) -> VertexData<DVec3> {
        surface.vertices().map(|vertex| self.pose.positions[surface.inputs_of_vertex(vertex)[0].0 as usize]).collect()
    }

    /// The drawing in the present pose. Normals are those of the file, on the side of those of the triangles; without one, the
    /// mean of the face normals around, weighted by angle, up to the creases of the drawing.
    pub fn draw(&self, transform: &DrawTransform) -> DrawPose {
        let mut sums = vec![DVec3::ZERO; self.inputs.len()];
        for corners in &self.triangles {
            let [p, q, r] = corners.map(|drawn| self.place(drawn));
            let normal = triangle::unit(triangle::area_vector([p, q, r]));
            let angles = [triangle::angle([p, q, r]), triangle::angle([q, r, p]), triangle::angle([r, p, q])];
            for (&drawn, angle) in corners.iter().zip(angles).filter(|(_, angle)| angle.is_finite()) {
                sums[self.first_of_sector[drawn as usize] as usize] += normal * angle;
            }
        }
        let mut drawn =
            DrawPose { positions: Vec::with_capacity(3 * sums.len()), normals: Vec::with_capacity(3 * sums.len()) };
        for (number, &input) in (0..).zip(&self.inputs) {
            drawn.positions.extend(transform.place(self.place(number)).to_array());
            let of_triangles = triangle::unit(sums[self.first_of_sector[number as usize] as usize]);
            let of_file = self.pose.normals.get(input as usize).copied().unwrap_or(Vec3::ZERO).as_dvec3();
            let normal = match of_file {
                DVec3::ZERO => of_triangles,
                normal if normal.dot(of_triangles) < 0.0 => -normal,
                normal => normal,
            };
            // Where a pose leaves nothing of the triangles around, any direction will do.
            let normal = if normal == DVec3::ZERO { DVec3::Y } else { normal };
            drawn.normals.extend(transform.direction(normal).as_vec3().to_array());
        }
        drawn
    }

    fn place(&self, drawn: u32) -> DVec3 {
        self.pose.positions[self.inputs[drawn as usize] as usize]
    }
}

#[cfg(test)]
mod tests {
    use glam::DQuat;
    use heatwalk_model::motion::{
        Channel, Clip, Deformer, Influences, Interpolation, Node, NodeTree, Placement, Target, Track,
    };
    use heatwalk_shapes as shapes;

    use super::*;
    use crate::drawing::draw_mesh;

    /// A box that turns about y once in a second, by a quarter turn at each keyframe.
    fn turning() -> Model {
        let mut model = shapes::by_name("ring").expect("a shape");
        let deformer = Deformer {
            vertices: 0..model.soup.positions.len(),
            node: 0,
            skin: None,
            positions: model.soup.positions.clone(),
            normals: Vec::new(),
            influences: Influences::default(),
            targets: Vec::new(),
            weights: Vec::new(),
        };
        let turn = |quarter: f32| DQuat::from_rotation_y(f64::from(quarter) * std::f64::consts::FRAC_PI_2);
        let times = [0.0, 0.25, 0.5, 0.75, 1.0_f32];
        let values = times.iter().map(|time| turn(4.0 * time).as_quat().to_array()).collect();
        let track = Track::new(times.to_vec(), values, Interpolation::Linear).expect("keyframes");
        let channels = vec![Channel { node: 0, target: Target::Rotation(track) }];
        let hierarchy = NodeTree::new(vec![Node { parent: None, placement: Placement::IDENTITY }]).expect("a node");
        let clip = Clip { name: "turn".to_owned(), channels, left_out: 0 };
        model.motion = Arc::new(Motion::new(hierarchy, Vec::new(), vec![deformer], vec![clip]).expect("a motion"));
        model
    }

    #[test]
    fn a_turned_drawing_is_the_drawing_of_the_turned_surface() {
        let model = turning();
        let surface = Surface::build(&model.soup).expect("a surface");
        let drawing = draw_mesh(&surface, &model.appearance, 0.8, &DrawTransform::IDENTITY);
        let mut posing = Posing::new(&model, &drawing).expect("it moves");
        for seconds in [0.0, 0.1, 0.6] {
            posing.take(Some((0, seconds))).expect("a pose");
            let posed = posing.draw(&DrawTransform::IDENTITY);
            let moved = surface.posed(posing.positions(&surface));
            let expected = draw_mesh(&moved, &model.appearance, 0.8, &DrawTransform::IDENTITY);
            assert_eq!(posed.positions, expected.positions);
            // Of angles in single precision.
            let apart = |(a, b): (&f32, &f32)| (a - b).abs() > 1e-5;
            assert!(!posed.normals.iter().zip(&expected.normals).any(apart), "{seconds}");
        }
        posing.take(None).expect("the pose of the file");
        assert_eq!(posing.draw(&DrawTransform::IDENTITY).positions, drawing.positions);
    }
}
