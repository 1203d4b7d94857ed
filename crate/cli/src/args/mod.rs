//! The command line: what all commands have, and the commands by groups.

mod directions;
mod fields;
mod many;
mod paths;
mod samples;
mod values;
mod volume;

use std::num::NonZeroUsize;
use std::path::{self, PathBuf};
use std::thread::available_parallelism;

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand};
use heatwalk::{BridgeRule, UnitRule, Up, WeldRule};

use crate::options::choice;
pub use directions::{LogMap, Transport};
pub use fields::{Distance, Isolines, Question, Solving, Table};
pub use many::{Matrix, Pairs};
pub use paths::{Loop, Path, Walk};
pub use samples::{Cells, Mean, Sample};
use values::links;
pub use volume::Fill;

/// Geodesic distance and paths on meshes.
#[derive(Parser)]
#[command(name = "heatwalk", version)]
pub struct Arguments {
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
    /// Distances from each of many sources, a row each
    Matrix(Matrix),
    /// Fill a closed surface with tetrahedra
    Fill(Fill),
    /// Time both linear solvers of the heat method on each mesh
    Table(Table),
}

/// What the commands on one mesh read and how they answer.
#[derive(Args)]
pub struct Mesh {
    /// glTF, GLB, OBJ, OFF, PLY, STL, 3MF or VTK file, or shape:NAME; of points alone: also XYZ, TXT, CSV, ASC or PTS file; of tetrahedra: Gmsh,
    /// Medit, VTK or TetGen file
    pub mesh: PathBuf,
    /// Take only this part of the file, counted from 0; may be repeated
    #[arg(long = "part", value_name = "N")]
    pub parts: Vec<usize>,
    /// Take the pose of this animation of the file, by its name or its number from 0, at --time
    #[arg(long, value_name = "NAME")]
    pub animation: Option<String>,
    /// Seconds after the beginning of the animation
    #[arg(long, value_name = "S", requires = "animation", default_value_t, allow_negative_numbers = true)]
    pub time: f64,
    /// Vertices that become one: those of equal position (exact), also those on both sides of a crack too narrow to be seen
    /// (auto), or no wider than D
    #[arg(long, value_name = "exact|auto|D", default_value_t, allow_negative_numbers = true)]
    pub weld: WeldRule,
    /// Unit that lengths are in: as the file says, or else by the size of the model (auto), none, or this one. It is told with
    /// the lengths and changes none of them
    #[arg(long, value_name = "auto|none|um|mm|cm|in|ft|m|km", default_value_t)]
    pub unit: UnitRule,
    /// Threads that build the surface, find contacts and answer --each; all that the machine has if not given
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// How the components of a mesh are joined.
#[derive(Args)]
pub struct Bridging {
    /// Components that paths cross between: those that pierce or nearly touch each other (auto), none (off), or those that
    /// are no farther apart than D
    #[arg(long = "bridge", value_name = "auto|off|D", default_value_t, allow_negative_numbers = true)]
    pub rule: BridgeRule,
    /// Link so many more of the groups that stay apart, each time the two that are nearest, or all of them
    #[arg(long = "link", value_name = "N|all", default_value = "0", value_parser = links, allow_negative_numbers = true)]
    pub links: usize,
}

impl Command {
    /// The files that it is told to write.
    pub fn outputs(&self) -> [Option<&path::Path>; 2] {
        let (first, second) = match self {
            Self::Info(_) | Self::Mean(_) | Self::Table(_) => (None, None),
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
            Self::Matrix(command) => (Some(command.output.as_path()), None),
            Self::Fill(command) => (command.output.as_deref(), None),
        };
        [first, second]
    }

    /// Whether what it tells is an object.
    pub fn is_json(&self) -> bool {
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
            | Self::Matrix(Matrix { mesh, .. })
            | Self::Fill(Fill { mesh, .. }) => mesh.json,
            Self::Table(table) => table.json,
        }
    }
}

impl Mesh {
    /// Threads to work on.
    pub fn threads(&self) -> NonZeroUsize {
        // Where the machine does not tell, one is sure to be there.
        self.threads.or_else(|| available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN)
    }
}

/// The group `turned` is what it has something to do with.
#[derive(Args)]
pub struct UpAxis {
    /// The axis of the mesh that points up: slopes are measured against it, and in the output it becomes Y
    #[arg(long, requires = "turned", value_name = "AXIS", default_value_t, value_parser = choice::<Up>(), allow_hyphen_values = true)]
    pub up: Up,
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
        return "give a command: info, distance, path, loop, isolines, sample, mean, walk, log-map, transport, cells, pairs, matrix, fill or table; heatwalk --help tells more".to_owned();
    }
    let text = error.render().to_string();
    let paragraph = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = paragraph.trim_start_matches("error:").split_whitespace().collect();
    words.join(" ")
}
