//! Commands that find many distances at once.

use std::path::PathBuf;

use clap::Args;

use super::{Bridging, Mesh};

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
    /// Write the distances to a .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}
