//! Commands that find vectors.

use std::path::PathBuf;

use clap::{ArgGroup, Args};
use glam::DVec3;
use heatwalk::{Choice, Method};

use super::common::{Bridging, Mesh, UpAxis};
use super::values::direction;
use crate::place::{Place, PlacedVector};

#[derive(Args)]
pub struct LogMap {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// The source: a vertex V, or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z
    #[arg(long, value_name = "P")]
    pub source: Place,
    /// The direction there that u is along, of any length; its part along the surface counts. Without it the x axis, or the y axis where
    /// the surface faces along x
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub direction: Option<DVec3>,
    /// How directions are found: along exact shortest paths, by propagated distances, or by heat, which is smooth where several paths are as
    /// short
    #[arg(long, value_name = "METHOD", value_parser = [Method::Exact.name(), Method::Propagation.name(), Method::Heat.name()],
        default_value = Method::Exact.name())]
    pub method: String,
    /// Write u and v of each vertex to a .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Transport {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// A vector at a vertex V or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z, of which the part along the surface counts; may be repeated, and each
    /// vertex then takes that of the nearest
    #[arg(long = "vector", value_name = "P:X,Y,Z", required = true, allow_hyphen_values = true)]
    pub vectors: Vec<PlacedVector>,
    /// How vectors are carried: along exact shortest paths, or by heat, which is smooth where several are as short
    #[arg(long, value_name = "METHOD", value_parser = [Method::Exact.name(), Method::Heat.name()], default_value = Method::Exact.name())]
    pub method: String,
    /// Write the vector of each vertex to a .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}
