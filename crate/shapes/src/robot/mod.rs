//! A robot: parts that pierce each other, stand on each other or stay a hair apart, as models from a workshop do; painted, and
//! with joints that move.

mod motion;
mod paint;
mod png;

use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec2, DVec3};
use heatwalk_model::Model;
use heatwalk_model::appearance::{Appearance, Material, Run};
use heatwalk_surface::{Part, Soup};

use super::solids::{add_box, add_turned, ball, cylinder};
use motion::{Joint, Limb, joint_motion};

/// A gap that nobody sees.
const HAIR: f64 = 0.0015;

#[derive(Clone, Copy)]
enum Finish {
    Paint,
    Cream,
    Rubber,
    Brass,
    Light,
    Chest,
    Face,
}

fn materials() -> Vec<Material> {
    let material = |[red, green, blue]: [f32; 3], metalness, roughness| Material {
        base_color: [red, green, blue, 1.0],
        metalness,
        roughness,
        ..Material::default()
    };
    vec![
        material([0.02, 0.30, 0.36], 0.3, 0.35),
        material([0.80, 0.68, 0.45], 0.0, 0.40),
        material([0.02, 0.02, 0.025], 0.0, 0.60),
        material([0.95, 0.62, 0.22], 1.0, 0.28),
        Material { emission: [0.3, 1.6, 1.9], ..material([0.05, 0.35, 0.40], 0.0, 0.30) },
        paint::textured(0),
        paint::textured(1),
    ]
}

/// Parts of the assembly, as they are added.
struct Workshop {
    soup: Soup,
    runs: Vec<Run>,
    spacing: f64,
    /// What the next parts are fixed to.
    joint: Joint,
    /// Of each part, what it is fixed to and its vertices.
    fixed: Vec<(Joint, std::ops::Range<usize>)>,
    /// Of the vertices that have a picture on them, and of those before.
    texcoords: Vec<[f32; 4]>,
}

impl Workshop {
    fn end(&mut self, name: &str, finish: Finish) {
        let start = self.soup.parts.iter().map(Part::len).sum();
        self.soup.end_part(name);
        self.runs.push(Run { triangles: start..self.soup.triangles.len(), material: Some(finish as usize) });
        let first = self.fixed.last().map_or(0, |(_, vertices)| vertices.end);
        self.fixed.push((self.joint, first..self.soup.positions.len()));
    }

    /// Lays a picture on the front of the last part, a block, and on its back in the mirror.
    fn lay_picture(&mut self, center: DVec3, half: DVec3) {
        let Some((_, vertices)) = self.fixed.last().cloned() else { return };
        self.texcoords.resize(vertices.start, [0.0; 4]);
        self.texcoords.extend(self.soup.positions[vertices].iter().map(|place| {
            let share = 0.5 + 0.5 * (place - center) / half;
            [share.x as f32, 1.0 - share.y as f32, 0.0, 0.0]
        }));
    }

    fn block(&mut self, name: &str, finish: Finish, center: DVec3, half: DVec3) {
        let rounding = 0.35 * half.min_element();
        add_box(&mut self.soup, half, rounding, self.spacing, DAffine3::from_translation(center));
        self.end(name, finish);
    }

    fn ball(&mut self, name: &str, finish: Finish, center: DVec3, radius: f64) {
        let steps = (std::f64::consts::PI * radius / self.spacing).ceil().max(6.0) as u32;
        add_turned(&mut self.soup, &ball(radius, steps), self.spacing, DAffine3::from_translation(center));
        self.end(name, finish);
    }

    /// A rod between two points.
    fn rod(&mut self, name: &str, finish: Finish, [from, to]: [DVec3; 2], radius: f64) {
        self.turned(name, finish, &cylinder(radius, from.distance(to) / 2.0), from.midpoint(to), to - from);
    }

    fn turned(&mut self, name: &str, finish: Finish, profile: &[DVec2], center: DVec3, axis: DVec3) {
        let turn = DQuat::from_rotation_arc(DVec3::Y, axis.normalize());
        let place = DAffine3::from_rotation_translation(turn, center);
        add_turned(&mut self.soup, profile, self.spacing, place);
        self.end(name, finish);
    }
}

/// A robot 2.5 high that stands on the ground and faces +z, in 33 parts; it can wave and walk. `spacing` is the length of an edge.
pub fn robot(spacing: f64) -> Model {
    let mut robot = Workshop {
        soup: Soup::default(),
        runs: Vec::new(),
        spacing,
        joint: Joint::Body,
        fixed: Vec::new(),
        texcoords: Vec::new(),
    };
    let v = DVec3::new;
    let (chest, chest_half) = (v(0.0, 1.25, 0.0), v(0.42, 0.34, 0.27));
    robot.block("torso", Finish::Chest, chest, chest_half);
    robot.lay_picture(chest, chest_half);
    robot.block("hips", Finish::Cream, v(0.0, 0.83, 0.0), v(0.31, 0.11, 0.20));
    robot.rod("waist", Finish::Rubber, [v(0.0, 0.80, 0.0), v(0.0, 1.00, 0.0)], 0.17);
    robot.block("pack", Finish::Cream, v(0.0, 1.30, -0.27 - 0.11 - HAIR), v(0.26, 0.24, 0.11));
    robot.turned("dial", Finish::Brass, &cylinder(0.17, 0.03), v(0.0, 1.32, 0.27 + 0.03 + HAIR), DVec3::Z);
    robot.turned("lens", Finish::Light, &ball(0.10, 8), v(0.0, 1.32, 0.30), DVec3::Z);
    robot.rod("neck", Finish::Rubber, [v(0.0, 1.54, 0.0), v(0.0, 1.74, 0.0)], 0.11);
    robot.joint = Joint::Head;
    let (head, head_half) = (v(0.0, 1.93, 0.0), v(0.33, 0.23, 0.26));
    robot.block("head", Finish::Face, head, head_half);
    robot.lay_picture(head, head_half);
    robot.block("grille", Finish::Brass, v(0.0, 1.80, 0.26), v(0.16, 0.035, 0.03));
    robot.rod("antenna", Finish::Brass, [v(0.0, 2.10, 0.0), v(0.0, 2.40, 0.0)], 0.022);
    robot.ball("tip", Finish::Light, v(0.0, 2.43, 0.0), 0.065);
    for (side, name) in [(1.0, "left"), (-1.0, "right")] {
        let is_left = side > 0.0;
        let named = |part: &str| format!("{name} {part}");
        let v = |x: f64, y: f64, z: f64| DVec3::new(side * x, y, z);
        robot.joint = Joint::Head;
        robot.ball(&named("eye"), Finish::Light, v(0.14, 1.98, 0.25), 0.075);
        robot.turned(&named("ear"), Finish::Paint, &cylinder(0.10, 0.04), v(0.33 + 0.04, 1.94, 0.0), v(1.0, 0.0, 0.0));
        let at = |limb: Limb| Joint::Limb(limb, is_left);
        let [shoulder, elbow, hip, knee, ankle] =
            [Limb::Arm, Limb::Forearm, Limb::Thigh, Limb::Shin, Limb::Foot].map(|limb| at(limb).place());
        let wrist = v(0.60, 0.74, 0.24);
        robot.joint = at(Limb::Arm);
        robot.ball(&named("shoulder"), Finish::Brass, shoulder, 0.15);
        robot.rod(&named("upper arm"), Finish::Paint, [shoulder, elbow], 0.085);
        robot.joint = at(Limb::Forearm);
        robot.ball(&named("elbow"), Finish::Rubber, elbow, 0.105);
        robot.rod(&named("forearm"), Finish::Cream, [elbow, wrist], 0.08);
        robot.ball(&named("hand"), Finish::Rubber, wrist, 0.12);
        robot.joint = at(Limb::Thigh);
        robot.rod(&named("thigh"), Finish::Paint, [hip, knee], 0.105);
        robot.joint = at(Limb::Shin);
        robot.ball(&named("knee"), Finish::Brass, knee, 0.125);
        robot.rod(&named("shin"), Finish::Paint, [knee, ankle], 0.10);
        robot.joint = at(Limb::Foot);
        robot.block(&named("foot"), Finish::Rubber, v(0.25, 0.09, 0.07), DVec3::new(0.15, 0.09, 0.25));
    }
    let Workshop { soup, runs, fixed, mut texcoords, .. } = robot;
    texcoords.resize(soup.positions.len(), [0.0; 4]);
    let (materials, images) = (materials(), [paint::chest(), paint::face()].concat());
    let appearance = Arc::new(Appearance { texcoords, runs, materials, images, ..Appearance::default() });
    let motion = Arc::new(joint_motion(&soup.positions, fixed));
    Model { appearance, motion, ..soup.into() }
}
