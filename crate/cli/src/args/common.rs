//! What commands have in common: the mesh, how its components are joined, and which axis points up.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::thread::available_parallelism;

use clap::Args;
use heatwalk::{BridgeRule, UnitRule, Up, WeldRule};

use super::values::links;
use crate::options::choice;

/// What the commands on one mesh read and how they answer.
#[derive(Args)]
pub struct Mesh {
    /// glTF, GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI or FreeSurfer file, or shape:NAME; of points alone: also XYZ, TXT, CSV, ASC or PTS file; of tetrahedra: Gmsh,
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

impl Mesh {
    /// Threads to work on.
    pub fn threads(&self) -> NonZeroUsize {
        self.threads.unwrap_or_else(available)
    }
}

/// Threads of the machine.
pub fn available() -> NonZeroUsize {
    // Where it does not tell, one is sure to be there.
    available_parallelism().unwrap_or(NonZeroUsize::MIN)
}

/// The group `turned` is what it has something to do with.
#[derive(Args)]
pub struct UpAxis {
    /// The axis of the mesh that points up: slopes are measured against it, and in the output it becomes Y
    #[arg(long, requires = "turned", value_name = "AXIS", default_value_t, value_parser = choice::<Up>(), allow_hyphen_values = true)]
    pub up: Up,
}
