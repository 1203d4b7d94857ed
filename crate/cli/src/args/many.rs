//! Commands that find many distances at once.

use std::path::PathBuf;

use anyhow::Result;
use clap::{ArgGroup, Args};
use heatwalk::{DistanceOptions, MultiSource};

use super::common::{Bridging, Mesh, UpAxis};
use super::fields::Solving;
use super::values::{at_least_one, positive};
use crate::labels::Between;
use crate::method::MethodOptions;
use crate::number::Number;

#[derive(Args)]
pub struct Pairs {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// A text file with a pair of places a line, each a vertex V, F:b0,b1,b2 in a triangle or @X,Y,Z, apart by blanks; two vertices may be apart by a
    /// comma
    #[arg(long, value_name = "FILE")]
    pub pairs: PathBuf,
    /// Answer from an index that heatwalk index has made of this mesh, without a search: pairs of vertices, with bounds
    #[arg(long, value_name = "FILE")]
    pub index: Option<PathBuf>,
    /// Write the distances to a .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Make an index that answers distances of pairs of vertices at once
///
/// Memory holds the index, which is some hundred to a thousand numbers of 32 bits a vertex, and a search for each thread. Components are not joined: paths
/// cross no bridges.
#[derive(Args)]
pub struct Index {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Write the index to this file, for pairs --index
    #[arg(long, value_name = "FILE")]
    pub output: PathBuf,
}

/// Distances from each of many sources, a row each
///
/// Rows are written as they are found. Beside the surface, memory holds a search for each thread and rows of 64 MiB at most, or one a thread where
/// that is more. A run that is ended in the middle, however that is, leaves OUTPUT.part, and the same command goes on from there; its file is that of
/// an undisturbed run to the last bit, for any number of threads.
#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
#[command(group = ArgGroup::new("rows").required(true))]
pub struct Matrix {
    #[command(flatten)]
    pub mesh: Mesh,
    /// A row for each vertex of the file
    #[arg(long, group = "rows")]
    pub all: bool,
    /// A row for each place of a text file, one a line: a vertex V, F:b0,b1,b2 in a triangle or @X,Y,Z
    #[arg(long, value_name = "FILE", group = "rows")]
    pub sources: Option<PathBuf>,
    /// A row for each of so many vertices, each the one that is farthest from those before it, as sample gives them
    #[arg(long, value_name = "N", group = "rows", value_parser = at_least_one)]
    pub landmarks: Option<usize>,
    /// A row and a column for each parcel of a .label.gii or .annot file
    #[arg(long, value_name = "FILE", group = "rows", conflicts_with = "targets")]
    pub parcels: Option<PathBuf>,
    /// Which distance parcels have: the mean over all pairs of their vertices (default), or the least
    #[arg(long, value_name = "mean|minimum", requires = "parcels", value_enum)]
    pub between: Option<Between>,
    /// A column for each vertex of a text file, one a line; without it for each vertex of the mesh
    #[arg(long, value_name = "FILE")]
    pub targets: Option<PathBuf>,
    #[command(flatten)]
    pub solving: Solving,
    /// Leave what is farther than D at infinity, or out of a sparse matrix; not for heat
    #[arg(long, value_name = "D", value_parser = positive, allow_negative_numbers = true)]
    pub max_distance: Option<f64>,
    /// How numbers are written: f64, or f32 in half of the room
    #[arg(long, value_name = "f32|f64", default_value_t, value_enum)]
    pub dtype: Number,
    /// Write an .npy file; with --max-distance also a sparse .npz file (CSR, as SciPy loads it); or a .csv file, of triples with --max-distance
    #[arg(long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub axis: UpAxis,
}

impl Matrix {
    /// What is asked of the solver for each row.
    ///
    /// # Errors
    /// Options that would have no effect.
    pub fn distance_options(&self) -> Result<DistanceOptions> {
        let search = self.max_distance.map(|_| "--max-distance");
        let given = MethodOptions { heat: self.solving.heat_option(), exact: false, search };
        let options = self.solving.distance_options(&given, MultiSource::default())?;
        Ok(DistanceOptions { max_distance: self.max_distance.unwrap_or(f64::INFINITY), ..options })
    }
}
