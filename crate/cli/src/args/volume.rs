//! Commands that make tetrahedra.

use std::path::PathBuf;

use clap::Args;

use super::common::Mesh;

#[derive(Args)]
pub struct Fill {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Cells along the longest side
    #[arg(long, value_name = "N", allow_negative_numbers = true, required_unless_present = "tetrahedra")]
    pub resolution: Option<f64>,
    /// About so many tetrahedra
    #[arg(long, value_name = "COUNT", conflicts_with = "resolution")]
    pub tetrahedra: Option<usize>,
    /// Write them to a .msh (Gmsh) or .vtu (VTK) file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}
