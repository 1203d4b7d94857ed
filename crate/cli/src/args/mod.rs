//! The command line: its commands by groups.

mod batch;
mod common;
mod directions;
mod fields;
mod many;
mod paths;
mod samples;
mod values;
mod volume;

use std::path;

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand};

pub use batch::Batch;
pub use common::{Bridging, Mesh, available};
pub use directions::{LogMap, Transport};
pub use fields::{Distance, Isolines, Question, Solving, Table};
pub use many::{Index, Matrix, Pairs};
pub use paths::{Loop, Path, Walk};
pub use samples::{Cells, Mean, Sample};
pub use volume::Fill;

/// Geodesic distance and paths on meshes.
#[derive(Parser)]
#[command(name = "heatwalk", version)]
pub struct Arguments {
    /// Of batch: end when standard input does, and tell an error as an object on standard output
    #[arg(long, hide = true)]
    pub job: bool,
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Tell what a file holds and what welding makes of it
    Info(Info),
    /// Distance of every vertex from the sources
    Distance(Distance),
    /// The path from one place to another
    Path(Path),
    /// Closed curves through places or around handles
    Loop(Loop),
    /// Curves of equal distance, and the surface cut along them
    Isolines(Isolines),
    /// Spread samples over a surface, each as far from those before it as may be
    Sample(Sample),
    /// Where squared distances from weighted places sum to least
    Mean(Mean),
    /// Walk straight on over the surface, from a place in a direction
    Walk(Walk),
    /// Directions and lengths of the shortest paths from a source to all vertices
    LogMap(LogMap),
    /// Carry tangent vectors to all vertices, parallel along shortest paths
    Transport(Transport),
    /// What is nearest to each of several sources, and the borders between
    Cells(Cells),
    /// Exact distances of pairs of places
    Pairs(Pairs),
    /// Make an index that answers distances of pairs of vertices at once
    Index(Index),
    /// Distances from each of many sources, a row each
    Matrix(Matrix),
    /// One command on each of many meshes
    Batch(Batch),
    /// Fill a closed surface with tetrahedra
    Fill(Fill),
    /// Time both linear solvers of the heat method on each mesh
    Table(Table),
}

impl Command {
    /// The files that it is told to write.
    pub fn outputs(&self) -> [Option<&path::Path>; 2] {
        let (first, second) = match self {
            Self::Info(_) | Self::Mean(_) | Self::Batch(_) | Self::Table(_) => (None, None),
            Self::Distance(command) => (command.output.as_deref(), None),
            Self::Path(command) => (command.output.as_deref(), None),
            Self::Loop(command) => (command.output.as_deref(), None),
            Self::Isolines(command) => (command.output.as_deref(), None),
            Self::Sample(command) => (command.output.as_deref(), None),
            Self::Walk(command) => (command.output.as_deref(), None),
            Self::LogMap(command) => (command.output.as_deref(), None),
            Self::Transport(command) => (command.output.as_deref(), None),
            Self::Cells(command) => (command.output.as_deref(), command.borders.as_deref()),
            Self::Pairs(command) => (command.output.as_deref(), None),
            Self::Index(command) => (Some(command.output.as_path()), None),
            Self::Matrix(command) => (Some(command.output.as_path()), None),
            Self::Fill(command) => (command.output.as_deref(), None),
        };
        [first, second]
    }

    /// Whether what it tells is an object.
    pub fn is_json(&self) -> bool {
        match self {
            Self::Batch(batch) => batch.json,
            Self::Table(table) => table.json,
            _ => self.mesh().is_some_and(|mesh| mesh.json),
        }
    }

    /// The mesh of a command that has one.
    pub fn mesh(&self) -> Option<&Mesh> {
        match self {
            Self::Info(Info { mesh, .. })
            | Self::Distance(Distance { question: Question { mesh, .. }, .. })
            | Self::Path(Path { mesh, .. })
            | Self::Loop(Loop { mesh, .. })
            | Self::Isolines(Isolines { question: Question { mesh, .. }, .. })
            | Self::Sample(Sample { mesh, .. })
            | Self::Mean(Mean { mesh, .. })
            | Self::Walk(Walk { mesh, .. })
            | Self::LogMap(LogMap { mesh, .. })
            | Self::Transport(Transport { mesh, .. })
            | Self::Cells(Cells { mesh, .. })
            | Self::Pairs(Pairs { mesh, .. })
            | Self::Index(Index { mesh, .. })
            | Self::Matrix(Matrix { mesh, .. })
            | Self::Fill(Fill { mesh, .. }) => Some(mesh),
            Self::Batch(_) | Self::Table(_) => None,
        }
    }
}

#[derive(Args)]
pub struct Info {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
}

/// The first paragraph of clap's message, on one line; the rest is its help.
pub fn in_one_sentence(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "give a command: info, distance, path, loop, isolines, sample, mean, walk, log-map, transport, cells, pairs, index, matrix, batch, fill or table; heatwalk --help tells more".to_owned();
    }
    let text = error.render().to_string();
    let paragraph = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = paragraph.trim_start_matches("error:").split_whitespace().collect();
    words.join(" ")
}
