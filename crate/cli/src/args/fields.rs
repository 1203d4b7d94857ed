//! Commands that find distances of all vertices.

use std::path::PathBuf;

use anyhow::Result;
use clap::{ArgGroup, Args};
use glam::DVec3;
use heatwalk::{DistanceOptions, MultiSource, Parameters};

use super::common::{Bridging, Mesh, UpAxis};
use super::values::{direction, positive};
use crate::curve::Curves;
use crate::ground::Ground;
use crate::lists::with_listed;
use crate::method::{MethodOptions, Methods};
use crate::options::{Linear, Options, choice, chosen};
use crate::place::{Line, SourcePlace};

/// On what ground distances are found, and how.
#[derive(Args)]
pub struct Solving {
    #[command(flatten)]
    pub bridging: Bridging,
    #[command(flatten)]
    pub ground: Ground,
    #[command(flatten)]
    pub methods: Methods,
    #[command(flatten)]
    pub options: Options,
    #[command(flatten)]
    pub linear: Linear,
}

/// From where distances are asked for, on what ground, and how they are found. The group `open` is what can be closed.
#[derive(Args)]
#[command(group = ArgGroup::new("open").multiple(true))]
pub struct Question {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Source: a vertex V or a place F:b0,b1,b2 in a triangle, T:b0,b1,b2,b3 in a tetrahedron or nearest to coordinates @X,Y,Z, with @D if it starts from a distance D; may be repeated
    #[arg(long = "source", value_name = "S", required_unless_present_any = ["open", "source_files"])]
    pub sources: Vec<SourcePlace>,
    /// Sources of a text file, one a line as for --source; blank lines do not count, nor does what follows a #. May be repeated
    #[arg(long = "sources", value_name = "FILE")]
    pub source_files: Vec<PathBuf>,
    /// Sources: all vertices along the shortest path on edges through these ones, V,V[,V...]; may be repeated
    #[arg(long = "line", value_name = "V,V...", group = "open")]
    pub lines: Vec<Line>,
    #[command(flatten)]
    pub curves: Curves,
    /// Close each line or curve
    #[arg(long, requires = "open")]
    pub closed: bool,
    #[command(flatten)]
    pub solving: Solving,
    /// The same as --method exact
    #[arg(long, conflicts_with = "method")]
    pub exact: bool,
    /// Leave what is farther than D at infinity; not for heat
    #[arg(long, value_name = "D", value_parser = positive, allow_negative_numbers = true)]
    pub max_distance: Option<f64>,
    #[arg(long, value_parser = choice::<MultiSource>(), help = chosen::<MultiSource>("How several sources are joined"))]
    pub multi: Option<MultiSource>,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Distance {
    #[command(flatten)]
    pub question: Question,
    /// Distances from each source by itself, a column of the output each
    #[arg(long, conflicts_with_all = ["open", "repeat", "compare"])]
    pub each: bool,
    /// Tell the error against exact distances
    #[arg(long, conflicts_with_all = ["exact", "curves", "curve_files"])]
    pub compare: bool,
    /// Time the median solve over so many single sources
    #[arg(long, value_name = "K", default_value_t = 1, conflicts_with_all = ["curves", "curve_files"], value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub repeat: u32,
    /// Write the distances to a .csv, .ply or .glb file, or to an overlay of a brain: .shape.gii, .func.gii, .mgh or .curv; of tetrahedra to a .csv, .vtu or .msh file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
#[command(group = ArgGroup::new("levels").required(true))]
pub struct Isolines {
    #[command(flatten)]
    pub question: Question,
    /// Isolines at these distances
    #[arg(long, value_name = "D,D...", group = "levels", value_delimiter = ',', allow_negative_numbers = true)]
    pub values: Vec<f64>,
    /// Isolines at the multiples of D
    #[arg(long, value_name = "D", group = "levels", allow_negative_numbers = true)]
    pub spacing: Option<f64>,
    /// So many isolines, which part the largest distance into equal shares
    #[arg(long, value_name = "N", group = "levels")]
    pub count: Option<usize>,
    /// Write the surface cut along the isolines, a group a strip, instead of the curves
    #[arg(long, requires = "output")]
    pub strips: bool,
    /// Write the strips unrolled into the plane, where they are not curved
    #[arg(long, requires = "output", conflicts_with = "strips")]
    pub unroll: bool,
    /// The direction from which an .svg or .pdf shows the curves, after --up has turned the mesh
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, default_value = "1,1,1", allow_hyphen_values = true)]
    pub view: DVec3,
    /// Write the curves to an .obj, .dxf, .svg, .pdf, .csv or .glb file, strips to an .obj file, unrolled ones to an .svg, .dxf or
    /// .pdf file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
pub struct Table {
    /// glTF, GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI or FreeSurfer files, or shape:NAME; of FILE#N the part N alone, counted from 0
    #[arg(value_name = "MESH", required = true)]
    pub meshes: Vec<String>,
    #[command(flatten)]
    pub options: Options,
    /// Tell the errors against exact distances too
    #[arg(long)]
    pub exact: bool,
    /// Take the median solve over so many sources; over 3 at most with conjugate gradients
    #[arg(long, value_name = "K", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub repeat: u32,
    /// Print one JSON array
    #[arg(long)]
    pub json: bool,
}

impl Solving {
    /// The first option of the heat method that is given.
    pub fn heat_option(&self) -> Option<&'static str> {
        self.options.given().or(self.linear.given())
    }

    /// `sources`: how several are joined.
    pub fn heat(&self, sources: MultiSource) -> Parameters {
        self.options.parameters(self.linear.solver.unwrap_or_default(), sources)
    }

    pub(super) fn distance_options(&self, given: &MethodOptions, sources: MultiSource) -> Result<DistanceOptions> {
        Ok(DistanceOptions {
            method: self.methods.chosen(given)?,
            windows: self.methods.windows.unwrap_or_default(),
            heat: self.heat(sources),
            ..DistanceOptions::default()
        })
    }
}

impl Question {
    /// What is asked of the solver.
    ///
    /// # Errors
    /// Options that would have no effect.
    pub fn distance_options(&self) -> Result<DistanceOptions> {
        let search = self.max_distance.map(|_| "--max-distance");
        let given = MethodOptions { heat: self.heat_option(), exact: self.exact, search };
        let options = self.solving.distance_options(&given, self.multi.unwrap_or_default())?;
        let options = DistanceOptions { max_distance: self.max_distance.unwrap_or(f64::INFINITY), ..options };
        self.curves.check(&options)?;
        Ok(options)
    }

    /// All places that are sources by themselves.
    pub fn places(&self) -> Result<Vec<SourcePlace>> {
        with_listed(&self.sources, &self.source_files, "source")
    }

    /// The first option of the heat method that is given.
    pub fn heat_option(&self) -> Option<&'static str> {
        self.solving.heat_option().or(self.multi.map(|_| "--multi"))
    }
}
