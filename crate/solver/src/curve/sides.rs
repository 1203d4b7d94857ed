//! On which side of curves vertices are: that from which they see the nearest point.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use heatwalk_base::sort;
use heatwalk_surface::Place;

use crate::directions::Plane;
use crate::error::{Error, Result};
use crate::exact::{Heading, Legs, Root, SIDES, Wavefront};

/// A place where lines of curves begin or end.
#[derive(Debug)]
pub(super) struct Joint {
    pub place: Place,
    /// Each line's face and other end, and whether it begins here.
    pub rays: Vec<(u32, Place, bool)>,
}

impl Joint {
    /// Whether one line ends and one begins here.
    pub fn is_passed_once(&self) -> bool {
        matches!(self.rays[..], [(.., a), (.., b)] if a != b)
    }
}

/// From where a vertex sees the nearest point of curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    pub is_left: bool,
    /// Whether that point is the end of an open curve.
    pub is_end: bool,
}

/// That of each vertex (`#V`), and of each target, as the search from the curves has found; `joints` are its sources.
pub(super) fn sides(front: &Wavefront, joints: &[Joint]) -> Result<[Vec<Side>; 2]> {
    let inside = |is_left: bool| Side { is_left, is_end: false };
    let mut legs = Legs::new(front)?;
    let mut angles: Vec<Option<Angles>> = joints.iter().map(|_| None).collect();
    let before_targets = front.values().len() + front.end_values().len();
    let count = before_targets + front.target_values().len();
    let mut known: Vec<Option<Side>> = vec![None; count];
    let mut open = Vec::new();
    for stop in 0..count {
        open.push(stop);
        while let Some(&stop) = open.last() {
            let leg = match front.root_of_stop(stop) {
                Some(Root::Source(_)) => legs.of(stop),
                _ => None,
            };
            let root = leg.map(|leg| leg.root).or_else(|| front.root_of_stop(stop));
            let start = root.and_then(|root| front.stop_of_root(root));
            match start.filter(|&start| known[start].is_none()) {
                Some(start) => open.push(start),
                None => {
                    let side = match (root, leg, start) {
                        (_, _, Some(start)) => known[start],
                        (Some(Root::Side(side)), ..) => Some(inside(side % SIDES == 0)),
                        (Some(Root::Source(joint)), Some(leg), _) => {
                            let own = match &angles[joint] {
                                Some(own) => own,
                                None => angles[joint].insert(Angles::of(front, &joints[joint])?),
                            };
                            Some(own.side(&leg.departure))
                        }
                        _ => None,
                    };
                    known[stop] = Some(side.unwrap_or(inside(false)));
                    open.pop();
                }
            }
        }
    }
    let of = |range: Range<usize>| known[range].iter().map(|side| side.unwrap_or(inside(false))).collect();
    Ok([of(0..front.values().len()), of(before_targets..count)])
}

/// The directions of lines at a joint.
#[derive(Debug)]
struct Angles {
    plane: Plane,
    /// In order, each with whether the line begins here.
    rays: Vec<(f64, bool)>,
}

impl Angles {
    fn of(front: &Wavefront, joint: &Joint) -> Result<Self> {
        let geometry = front.geometry();
        let plane = Plane::at(geometry, joint.place).map_err(|error| match error {
            Error::BadParameter { value, range, .. } => {
                Error::BadParameter { name: "a place of the curve", value, range }
            }
            error => error,
        })?;
        let angle = |&(face, to, begins): &(u32, Place, bool)| {
            let heading = Heading::towards(geometry, face, [joint.place, to])?;
            Some((plane.angle(&heading).rem_euclid(TAU), begins))
        };
        let mut rays: Vec<(f64, bool)> = joint.rays.iter().filter_map(angle).collect();
        sort::sort_by(&mut rays, |a, b| a.0.total_cmp(&b.0));
        Ok(Self { plane, rays })
    }

    /// The side of what is in a direction, by the line that comes before it, counterclockwise.
    fn side(&self, heading: &Heading) -> Side {
        let angle = self.plane.angle(heading).rem_euclid(TAU);
        if let [(ray, begins)] = self.rays[..] {
            return Side { is_left: ((angle - ray).rem_euclid(TAU) < PI) == begins, is_end: true };
        }
        let before = self.rays.iter().rev().find(|&&(ray, _)| ray <= angle).or(self.rays.last());
        Side { is_left: before.is_some_and(|&(_, begins)| begins), is_end: false }
    }
}
