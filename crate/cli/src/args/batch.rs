//! The command that runs others.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

/// One command on each of many meshes
///
/// COMMAND is written as for one mesh, without the mesh: heatwalk batch scans --output fields distance --source 0 --output {}.csv. In each of its
/// words {} stands for the name of the mesh, which is its path without the extension, below the folder MESHES or as the list has it. Files
/// that it writes are below the DIR of batch and have {} in their names.
///
/// Each mesh is a process, so that one that fails ends no other. DIR/manifest.jsonl has an object for each: what was read and asked, the result
/// as --json tells it, or the error. What is done is not done again unless the mesh, another file that COMMAND names or COMMAND itself has changed.
/// A run that ends in the middle, however that is, is finished by the same command; files are whole, and those of an undisturbed run to the last bit.
#[derive(Args)]
pub struct Batch {
    /// A folder, whose mesh files and those in its folders are taken; or a text file with a mesh a line, without what is blank or begins with #
    pub meshes: PathBuf,
    /// The folder of what is written, made if it is not there
    #[arg(long, value_name = "DIR")]
    pub output: PathBuf,
    /// Meshes at once; as many as the machine has threads if not given. Each has its share of these unless COMMAND has --threads
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// A command on one mesh with its options, without the mesh
    #[arg(value_name = "COMMAND", required = true, trailing_var_arg = true)]
    pub command: Vec<String>,
}
