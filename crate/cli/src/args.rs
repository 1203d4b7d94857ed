//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::thread::available_parallelism;

use anyhow::Result;
use clap::error::ErrorKind;
use clap::{ArgGroup, Args, Parser, Subcommand};
use glam::DVec3;
use heatwalk::{BridgeRule, Choice, DistanceOptions, Method, MultiSource, Parameters, UnitRule, Up, WeldRule};

use crate::curve::Curves;
use crate::ground::Ground;
use crate::method::{MethodOptions, Methods};
use crate::options::{Linear, Options, choice, chosen};
use crate::place::{Line, Place, PlacedVector, SourcePlace, WeightedPlace, vector};

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

impl Mesh {
    /// Threads to work on.
    pub fn threads(&self) -> NonZeroUsize {
        // Where the machine does not tell, one is sure to be there.
        self.threads.or_else(|| available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN)
    }
}

#[derive(Args)]
pub struct Info {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
}

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
    /// Source: a vertex V or a place F:b0,b1,b2 in a triangle or T:b0,b1,b2,b3 in a tetrahedron, with @D if it starts from a distance D; may be repeated
    #[arg(long = "source", value_name = "S", required_unless_present = "open")]
    pub sources: Vec<SourcePlace>,
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
    /// Write the distances to a .csv, .ply or .glb file; of tetrahedra to a .csv, .vtu or .msh file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

/// The group `turned` is what it has something to do with.
#[derive(Args)]
pub struct UpAxis {
    /// The axis of the mesh that points up: slopes are measured against it, and in the output it becomes Y
    #[arg(long, requires = "turned", value_name = "AXIS", default_value_t, value_parser = choice::<Up>(), allow_hyphen_values = true)]
    pub up: Up,
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
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Path {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Where the path begins: a vertex V, or a place F:b0,b1,b2 in a triangle or T:b0,b1,b2,b3 in a tetrahedron
    #[arg(long, value_name = "S")]
    pub from: Place,
    /// Where it goes on its way; may be repeated, in order
    #[arg(long, value_name = "S")]
    pub via: Vec<Place>,
    /// Where it ends
    #[arg(long, value_name = "S")]
    pub to: Place,
    #[command(flatten)]
    pub solving: Solving,
    /// Straighten the path until it is locally shortest
    #[arg(long)]
    pub straighten: bool,
    /// An exact shortest path instead of one that descends distances
    #[arg(long, conflicts_with_all = ["straighten", "method"])]
    pub exact: bool,
    /// The Bézier curve that --from, --via and --to control, by exact shortest paths, which is only at its ends on them
    #[arg(long, requires = "via", conflicts_with_all = ["straighten", "method", "exact"])]
    pub bezier: bool,
    /// Write the points to an .obj or .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
#[command(group = ArgGroup::new("around").required(true))]
pub struct Loop {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// Where the loop goes: a vertex V, or a place F:b0,b1,b2 in a triangle; may be repeated, in order. Through one or two it goes around
    /// a handle or a hole
    #[arg(long, value_name = "P", group = "around")]
    pub through: Vec<Place>,
    /// Let go of the places: tighten the loop to a closed geodesic that it can be deformed into
    #[arg(long, requires = "through", conflicts_with = "handles")]
    pub free: bool,
    /// Closed geodesics around the handles and through them, two of each
    #[arg(long, group = "around")]
    pub handles: bool,
    /// Write the points to an .obj or .csv file; those of several loops with its number in each row
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

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
    /// A vertex V or a place F:b0,b1,b2 in a triangle, with @W if it counts for W instead of 1; may be repeated
    #[arg(long = "source", value_name = "P[@W]", required = true)]
    pub sources: Vec<WeightedPlace>,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Walk {
    #[command(flatten)]
    pub mesh: Mesh,
    /// Where it begins: a vertex V, or a place F:b0,b1,b2 in a triangle
    #[arg(long, value_name = "P")]
    pub from: Place,
    /// The direction there, of any length; its part along the surface counts
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub direction: DVec3,
    /// How far, in the unit of the mesh
    #[arg(long, value_name = "L", value_parser = positive, allow_negative_numbers = true)]
    pub length: f64,
    /// The triangle at the place that the direction is projected to; without it, that which agrees with it best
    #[arg(long, value_name = "F")]
    pub triangle: Option<usize>,
    /// Write the points to an .obj or .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Cells {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// The source of a cell: a vertex V or a place F:b0,b1,b2 in a triangle, with @D if it starts from a distance D; may be repeated
    #[arg(long = "source", value_name = "S", required = true)]
    pub sources: Vec<SourcePlace>,
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

#[derive(Args)]
pub struct LogMap {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// The source: a vertex V, or a place F:b0,b1,b2 in a triangle
    #[arg(long, value_name = "P")]
    pub source: Place,
    /// The direction there that u is along, of any length; its part along the surface counts. Without it the x axis, or the y axis where
    /// the surface faces along x
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub direction: Option<DVec3>,
    /// How directions are found: along exact shortest paths, by propagated distances, or by heat, which is smooth where several paths are as
    /// short
    #[arg(long, value_name = "METHOD", value_parser = [Method::Exact.name(), Method::Propagation.name(), Method::Heat.name()],
        default_value = Method::Exact.name())]
    pub method: String,
    /// Write u and v of each vertex to a .csv file
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Args)]
#[command(group = ArgGroup::new("turned").multiple(true))]
pub struct Transport {
    #[command(flatten)]
    pub mesh: Mesh,
    #[command(flatten)]
    pub bridging: Bridging,
    /// A vector at a vertex V or a place F:b0,b1,b2 in a triangle, of which the part along the surface counts; may be repeated, and each
    /// vertex then takes that of the nearest
    #[arg(long = "vector", value_name = "P:X,Y,Z", required = true, allow_hyphen_values = true)]
    pub vectors: Vec<PlacedVector>,
    /// How vectors are carried: along exact shortest paths, or by heat, which is smooth where several are as short
    #[arg(long, value_name = "METHOD", value_parser = [Method::Exact.name(), Method::Heat.name()], default_value = Method::Exact.name())]
    pub method: String,
    /// Write the vector of each vertex to a .csv file
    #[arg(long, value_name = "FILE", group = "turned")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub axis: UpAxis,
}

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

#[derive(Args)]
pub struct Table {
    /// glTF, GLB, OBJ, OFF, PLY, STL, 3MF or VTK files, or shape:NAME; of FILE#N the part N alone, counted from 0
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

    fn distance_options(&self, given: &MethodOptions, sources: MultiSource) -> Result<DistanceOptions> {
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

    /// The first option of the heat method that is given.
    pub fn heat_option(&self) -> Option<&'static str> {
        self.solving.heat_option().or(self.multi.map(|_| "--multi"))
    }
}

impl Path {
    /// Where it goes, in order.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        [&self.from].into_iter().chain(&self.via).chain([&self.to])
    }

    /// What is asked of the solver.
    ///
    /// # Errors
    /// Options that would have no effect.
    pub fn distance_options(&self) -> Result<DistanceOptions> {
        let exact = self.exact || self.bezier;
        let given = MethodOptions { heat: self.solving.heat_option(), exact, search: None };
        self.solving.distance_options(&given, MultiSource::default())
    }
}

/// A number of links.
fn links(text: &str) -> Result<usize, String> {
    match text {
        "all" => Ok(usize::MAX),
        _ => text.parse().map_err(|_| "a number of links or all is needed".to_owned()),
    }
}

/// A direction in space.
fn direction(text: &str) -> Result<DVec3, String> {
    let direction = vector(text).filter(|direction| direction.try_normalize().is_some());
    direction.ok_or_else(|| "give a direction as three numbers, such as 0,0,1".to_owned())
}

/// A number of things, one at least.
fn at_least_one(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|&number| number > 0);
    number.ok_or_else(|| "a number of at least 1 is needed".to_owned())
}

/// A positive number.
fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number: &f64| number > 0.0);
    number.ok_or_else(|| "a positive number is needed".to_owned())
}

/// The first paragraph of clap's message, on one line; the rest is its help.
pub fn in_one_sentence(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "give a command: info, distance, path, loop, isolines, sample, mean, walk, log-map, transport, cells, fill or table; heatwalk --help tells more".to_owned();
    }
    let text = error.render().to_string();
    let paragraph = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = paragraph.trim_start_matches("error:").split_whitespace().collect();
    words.join(" ")
}
