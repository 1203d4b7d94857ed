//! Commands that find lines on the surface.

use std::path::PathBuf;

use anyhow::Result;
use clap::{ArgGroup, Args};
use glam::DVec3;
use heatwalk::{DistanceOptions, MultiSource};

use super::common::{Bridging, Mesh, UpAxis};
use super::fields::Solving;
use super::values::{direction, positive};
use crate::method::MethodOptions;
use crate::place::Place;

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Path {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Where the path begins: a vertex V, or a place F:b0,b1,b2 in a triangle, T:b0,b1,b2,b3 in a tetrahedron or nearest to coordinates @X,Y,Z
    #[arg(long, value_name = "S")]
    pub from: Place,
    /// Where it goes on its way; may be repeated, in order
    #[arg(long, value_name = "S")]
    pub via: Vec<Place>,
    /// Where it ends; may be repeated, for a path to each
    #[arg(long, value_name = "S", required = true)]
    pub to: Vec<Place>,
    #[command(flatten)]
    pub solving: Solving,
    /// Straighten the path until it is locally shortest
    #[arg(long)]
    pub straighten: bool,
    /// An exact shortest path instead of one that descends distances
    #[arg(long, conflicts_with_all = ["straighten", "method"])]
    pub exact: bool,
    /// The Bézier curve that --from, --via and --to control, by exact shortest paths, which is only at its ends on them
    #[arg(long, requires = "via", conflicts_with_all = ["straighten", "method", "exact"])]
    pub bezier: bool,
    /// Write the points to an .obj or .csv file; those of several paths with its number in each row
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
#[command(group = ArgGroup::new("around").required(true))]
pub struct Loop {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// Where the loop goes: a vertex V, or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z; may be repeated, in order. Through one or two it goes around
    /// a handle or a hole
    #[arg(long, value_name = "P", group = "around")]
    pub through: Vec<Place>,
    /// Let go of the places: tighten the loop to a closed geodesic that it can be deformed into
    #[arg(long, requires = "through", conflicts_with = "handles")]
    pub free: bool,
    /// Closed geodesics around the handles and through them, two of each
    #[arg(long, group = "around")]
    pub handles: bool,
    /// Write the points to an .obj or .csv file; those of several loops with its number in each row
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Walk {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Where it begins: a vertex V, or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z
    #[arg(long, value_name = "P")]
    pub from: Place,
    /// The direction there, of any length; its part along the surface counts
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub direction: DVec3,
    /// How far, in the unit of the mesh
    #[arg(long, value_name = "L", value_parser = positive, allow_negative_numbers = true)]
    pub length: f64,
    /// The triangle at the place that the direction is projected to; without it, that which agrees with it best
    #[arg(long, value_name = "F")]
    pub triangle: Option<usize>,
    /// Write the points to an .obj or .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

impl Path {
    /// Where each path goes, in order.
    pub fn routes(&self) -> impl Iterator<Item = Vec<Place>> {
        self.to.iter().map(|&to| [&[self.from], self.via.as_slice(), &[to]].concat())
    }

    /// What is asked of the solver.
    ///
    /// # Errors
    /// Options that would have no effect.
    pub fn distance_options(&self) -> Result<DistanceOptions> {
        let exact = self.exact || self.bezier;
        let given = MethodOptions { heat: self.solving.heat_option(), exact, search: None };
        self.solving.distance_options(&given, MultiSource::default())
    }
}
