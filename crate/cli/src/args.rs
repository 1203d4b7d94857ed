//! The command line.

use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};

/// Geodesic distance and paths on meshes by the heat method.
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
    /// The way from one vertex to another
    Path(Path),
}

/// What every command reads and how it answers.
#[derive(Args)]
pub struct Mesh {
    /// glTF, GLB, OBJ, OFF, PLY or STL file
    pub mesh: PathBuf,
    /// Take only this part of the file, counted from 0; may be repeated
    #[arg(long = "part", value_name = "N")]
    pub parts: Vec<usize>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// The dials of the heat method.
#[derive(Args)]
pub struct Dials {
    /// Time step in squares of the mean edge length
    #[arg(long = "t", value_name = "M", default_value_t = 1.0, value_parser = positive, allow_negative_numbers = true)]
    pub time_factor: f64,
    /// What heat does at the boundary
    #[arg(long, value_enum, default_value_t = Boundary::Neumann)]
    pub boundary: Boundary,
}

#[derive(Args)]
pub struct Info {
    #[command(flatten)]
    pub mesh: Mesh,
}

#[derive(Args)]
pub struct Distance {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Source: a vertex of the file over the chosen parts, counted from 0; may be repeated
    #[arg(long = "source", value_name = "V", required = true)]
    pub sources: Vec<usize>,
    #[command(flatten)]
    pub dials: Dials,
    /// Time the median solve over so many single sources
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub repeat: u32,
    /// Write the distances to a .csv, .ply or .glb file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Args)]
pub struct Path {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Vertex where the path begins, counted from 0
    #[arg(long, value_name = "V")]
    pub from: usize,
    /// Vertex where it ends
    #[arg(long, value_name = "V")]
    pub to: usize,
    #[command(flatten)]
    pub dials: Dials,
    /// Write the points to an .obj or .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Boundary {
    Neumann,
    Dirichlet,
    Average,
}

impl Dials {
    pub fn parameters(&self) -> heatwalk::Parameters {
        let boundary = match self.boundary {
            Boundary::Neumann => heatwalk::Boundary::Neumann,
            Boundary::Dirichlet => heatwalk::Boundary::Dirichlet,
            Boundary::Average => heatwalk::Boundary::Average,
        };
        heatwalk::Parameters { time_factor: self.time_factor, boundary }
    }
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("it must be a positive number".to_owned()),
    }
}

/// The first paragraph of clap's message, on one line; the rest is its help.
pub fn in_one_sentence(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "give a command: info, distance or path; heatwalk --help tells more".to_owned();
    }
    let text = error.render().to_string();
    let paragraph = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = paragraph.trim_start_matches("error:").split_whitespace().collect();
    words.join(" ")
}
