//! Commands that spread places, or divide the surface among some.

use std::path::PathBuf;

use clap::{ArgGroup, Args};
use glam::DVec3;

use super::common::{Bridging, Mesh, UpAxis};
use super::values::{at_least_one, direction, positive};
use crate::place::{SourcePlace, WeightedPlace};

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
#[command(group = ArgGroup::new("many").required(true))]
pub struct Sample {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// So many samples, or as many as there are vertices
    #[arg(long, value_name = "N", group = "many", value_parser = at_least_one)]
    pub count: Option<usize>,
    /// As many as it takes until no vertex is farther than this from one; no two are nearer to each other
    #[arg(long, value_name = "R", group = "many", value_parser = positive, allow_negative_numbers = true)]
    pub radius: Option<f64>,
    /// Then move the samples to the middles of what is nearest to each, for so many rounds; they need not be vertices any more
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub relax: usize,
    /// Begin with a vertex at random, the same for the same number; without it with the first one
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,
    /// Write vertices and their positions to a .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
pub struct Mean {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// A vertex V or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z, with @W if it counts for W instead of 1; may be repeated
    #[arg(long = "source", value_name = "P[@W]", required_unless_present = "source_files")]
    pub sources: Vec<WeightedPlace>,
    /// Sources of a text file, one a line as for --source; blank lines do not count, nor does what follows a #. May be repeated
    #[arg(long = "sources", value_name = "FILE")]
    pub source_files: Vec<PathBuf>,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Cells {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// The source of a cell: a vertex V or a place F:b0,b1,b2 in a triangle or nearest to coordinates @X,Y,Z, with @D if it starts from a distance D; may be repeated
    #[arg(long = "source", value_name = "S", required_unless_present = "source_files")]
    pub sources: Vec<SourcePlace>,
    /// Sources of a text file, one a line as for --source; blank lines do not count, nor does what follows a #. May be repeated
    #[arg(long = "sources", value_name = "FILE")]
    pub source_files: Vec<PathBuf>,
    /// Write the number of the nearest source, as they are given, and the distance of each vertex to a .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Tell the area of each cell
    #[arg(long)]
    pub areas: bool,
    /// Write the borders between cells to an .obj, .dxf, .svg or .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub borders: Option<PathBuf>,
    /// The direction from which an .svg shows the borders, after --up has turned the mesh
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, default_value = "1,1,1", allow_hyphen_values = true)]
    pub view: DVec3,
    #[command(flatten)]
    pub axis: UpAxis,
}
