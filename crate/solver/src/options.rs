//! What may be chosen: the names, the ranges and the defaults that the command line, a scene's link and the panel share.

use std::ops::RangeInclusive;
use std::str::FromStr;

use glam::DVec3;

use crate::choice::choice;
use crate::error::{Error, Result};

/// The word for an automatic choice of a number.
pub const AUTOMATIC: &str = "auto";

/// What those have in common that are [`AUTOMATIC`] or a number: `automatic!(Type::Number, "name", "range", |number| is_out_of_range)`.
macro_rules! automatic {
    ($type:ident::$variant:ident, $name:literal, $range:literal, |$number:ident| $is_out_of_range:expr) => {
        impl $type {
            /// # Errors
            /// [`Error::BadParameter`] for a number that is out of range.
            pub fn check(self) -> Result<()> {
                match self {
                    Self::$variant($number) if $is_out_of_range => Err(bad($name, &$number.to_string(), $range)),
                    _ => Ok(()),
                }
            }
        }

        /// A number, or [`AUTOMATIC`].
        impl FromStr for $type {
            type Err = Error;

            fn from_str(text: &str) -> Result<Self> {
                if text == AUTOMATIC {
                    return Ok(Self::Automatic);
                }
                let number = text.parse().map(Self::$variant).ok().filter(|number| number.check().is_ok());
                number.ok_or_else(|| bad($name, text, concat!($range, ", or auto")))
            }
        }
    };
}

/// How distances are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Exactly where that costs no more than a second or so, beyond by a few windows.
    #[default]
    Auto,
    /// By a few windows of each half-edge: nothing is factored, and no value is below the exact one.
    Propagation,
    /// By the flow of heat: smooth, with options.
    Heat,
    /// By all windows.
    Exact,
}

choice!(Method, "method": Auto = "auto", Propagation = "propagation", Heat = "heat", Exact = "exact");

/// What tells on which side of curves a vertex is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sign {
    /// The nearest point where curves are closed and do not meet, else heat.
    #[default]
    Auto,
    /// The side from which the nearest point of the curves is seen. Exact for closed curves; beyond the ends of open ones it changes on
    /// their straight continuation.
    Nearest,
    /// Diffused normals of the curves, which close gaps (Feng & Crane 2024).
    Heat,
}

choice!(Sign, "sign": Auto = "auto", Nearest = "nearest", Heat = "heat");

/// Numbers of windows of each half-edge that are worth offering. Propagation takes any.
pub const WINDOWS: [u16; 4] = [1, 2, 4, 8];

/// Bytes that a triangle of a closed mesh takes, with what there is at its vertices and with one window of each half-edge.
pub const TRIANGLE_BYTES: u16 = 310;

/// Windows of each half-edge that propagation keeps unless told otherwise.
pub const DEFAULT_WINDOWS: u16 = 1;

/// Which triangles carry the cotan weights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Operator {
    /// The intrinsic Delaunay triangulation of the same vertices, on the tufted cover where the surface is no oriented
    /// manifold: no weight is negative, whatever the shape of the triangles.
    #[default]
    Delaunay,
    /// The triangles of the file.
    Plain,
    /// The triangles of the file after the repair of the INF555 report by He and Hung, which moves vertices of bad ones.
    Relocate,
}

choice!(Operator, "operator": Delaunay = "delaunay", Plain = "plain", Relocate = "relocate");

/// What heat does at the boundary of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// None flows out: lines of equal distance meet the boundary at right angles.
    #[default]
    Neumann,
    /// It is 0, except at sources. Components that are all boundary fall back to Neumann.
    Dirichlet,
    /// The mean of both, nearest to the true distance where the time factor is large.
    Average,
}

choice!(Boundary, "boundary condition": Neumann = "neumann", Dirichlet = "dirichlet", Average = "average");

/// How linear systems are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LinearSolver {
    /// Sparse factorisation: once, then every source is quick and heat is right however far it has fallen.
    #[default]
    Cholesky,
    /// Conjugate gradients with multigrid: little to prepare, memory in proportion to the mesh, each source slow, and heat
    /// below 10⁻¹² of its maximum is noise.
    ConjugateGradients,
}

choice!(LinearSolver, "linear solver": Cholesky = "cholesky", ConjugateGradients = "cg");

/// The diffusion time t = m h², h the mean edge length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum TimeStep {
    /// m chosen by how even, how graded and how fine the triangles are, and the gradient of −√t log u for the field, which is more
    /// accurate; with conjugate gradients the unit field, and m so large that all heat is above their noise.
    #[default]
    Automatic,
    /// This m, and the unit field −∇u / |∇u|; positive, no unit. Larger is smoother.
    Factor(f64),
}

impl TimeStep {
    /// The factors worth offering. Any positive one is taken.
    pub const FACTORS: RangeInclusive<f64> = 0.1..=1000.0;
}

automatic!(TimeStep::Factor, "the time factor", "a positive number", |factor| !(factor.is_finite() && factor > 0.0));

/// How several sources are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MultiSource {
    /// Heat is 1 and distance is 0 (or the initial distance) at every source, as if the matrices had been factored with
    /// these vertices constrained.
    #[default]
    Exact,
    /// Heat of the sources is added up and one constant subtracted, so that no source ends at exactly 0: what other
    /// programs do, for comparison.
    Summed,
}

choice!(MultiSource, "multi-source mode": Exact = "exact", Summed = "summed" | "superposed");

/// Radius around the sources within which distances are exact polyhedral ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ExactRadius {
    /// As far as costs a fraction of a solve on large meshes, and about twice the rest of it on meshes of some thousand
    /// vertices.
    #[default]
    Automatic,
    /// So many mean edges, whatever it costs: 0 is the heat method alone, infinity is exact everywhere.
    Edges(f64),
}

impl ExactRadius {
    /// The radii worth offering, in mean edges. Any that is 0 or more is taken.
    pub const EDGES: RangeInclusive<f64> = 0.0..=64.0;

    /// The same, or so many mean edges where it may be more.
    #[must_use]
    pub fn at_most(self, edges: f64) -> Self {
        match self {
            Self::Automatic => Self::Edges(edges),
            Self::Edges(own) => Self::Edges(own.min(edges)),
        }
    }
}

automatic!(ExactRadius::Edges, "the exact radius", "a number of mean edge lengths, 0 or more", |edges| edges.is_nan()
    || edges < 0.0);

/// Most memory that factors may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MemoryLimit {
    /// What there is.
    #[default]
    Automatic,
    /// So many bytes for the factors, made and kept, and for the work on them. The surface, its matrices and what
    /// solves keep are not counted.
    Bytes(u64),
}

impl MemoryLimit {
    /// The limits worth offering, in MiB; wasm32 has 4 GiB.
    pub const MEBIBYTES: RangeInclusive<f64> = 0.0..=4096.0;

    /// So many MiB.
    pub fn mebibytes(count: f64) -> Self {
        Self::Bytes((count * f64::from(1 << 20)) as u64)
    }
}

/// Which shortest path leads to the nearest source.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PathKind {
    /// Down the distance field as it is.
    Descent,
    /// The same, made as short as it gets: the shortest there is where all distances are exact.
    #[default]
    Straightened,
    /// The shortest there is, whatever the field.
    Exact,
}

choice!(PathKind, "path": Descent = "descent", Straightened = "straight", Exact = "exact");

/// A value per vertex that can be shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum VertexField {
    /// Distance from the nearest source, in the file's unit.
    #[default]
    Distance,
    /// Heat that the distance comes from: log10 of its share of the maximum.
    Heat,
    /// Error of the distance before it was made exact, relative to the exact one.
    Error,
}

choice!(VertexField, "field": Distance = "distance", Heat = "heat", Error = "error");

/// A vector per face that can be shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FaceField {
    /// Gradient of the distance, away from the sources.
    #[default]
    Distance,
    /// Unit vectors along the gradient of heat, towards the sources.
    Heat,
}

choice!(FaceField, "gradient": Distance = "distance", Heat = "heat");

/// Edges that can be shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum EdgeKind {
    /// Those between faces of the surface.
    #[default]
    Mesh,
    /// Those with one face.
    Boundary,
    /// Those of the triangles that carry the operators.
    Operator,
    /// Where components meet.
    Contact,
}

choice!(EdgeKind, "kind of edges": Mesh = "mesh", Boundary = "boundary", Operator = "operator", Contact = "contact");

/// The axis of the file that points up where it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Up {
    /// As in glTF.
    #[default]
    Y,
    /// As in most CAD and scanning programs.
    Z,
    /// The first axis.
    X,
    /// Against the second axis.
    MinusY,
    /// Against the third axis.
    MinusZ,
    /// Against the first axis.
    MinusX,
}

impl Up {
    /// A vector turned so that what points up is along Y. A turn exchanges coordinates and signs, so it costs no digit; no
    /// coordinate is −0.
    pub fn turned(self, vector: DVec3) -> DVec3 {
        let DVec3 { x, y, z } = vector;
        // Adding 0 makes −0 to 0.
        DVec3::ZERO
            + match self {
                Self::Y => vector,
                Self::Z => DVec3::new(x, z, -y),
                Self::X => DVec3::new(-y, x, z),
                Self::MinusY => DVec3::new(x, -y, -z),
                Self::MinusZ => DVec3::new(x, -z, y),
                Self::MinusX => DVec3::new(y, -x, z),
            }
    }
}

choice!(Up, "up axis": Y = "y", Z = "z", X = "x", MinusY = "-y", MinusZ = "-z", MinusX = "-x");

/// All options of the heat method: those that are factored, and those of each query.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Parameters {
    /// The triangles that carry the operators.
    pub operator: Operator,
    /// How linear systems are solved.
    pub solver: LinearSolver,
    /// How long heat flows.
    pub time_step: TimeStep,
    /// What heat does at the boundary.
    pub boundary: Boundary,
    /// How several sources are joined.
    pub sources: MultiSource,
    /// How far around the sources distances are exact.
    pub exact_radius: ExactRadius,
    /// Most memory that factors may take.
    pub memory: MemoryLimit,
}

/// What is factored.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FactorOptions {
    /// The triangles that carry the operators.
    pub operator: Operator,
    /// How linear systems are solved.
    pub solver: LinearSolver,
    /// How long heat flows.
    pub time_step: TimeStep,
    /// What heat does at the boundary.
    pub boundary: Boundary,
    /// Most memory that factors may take.
    pub memory: MemoryLimit,
}

impl FactorOptions {
    /// # Errors
    /// [`Error::BadParameter`].
    pub(crate) fn check(&self) -> Result<()> {
        self.time_step.check()
    }
}

impl Parameters {
    /// Those that need factoring.
    pub fn factor_options(&self) -> FactorOptions {
        let Self { operator, solver, time_step, boundary, memory, .. } = *self;
        FactorOptions { operator, solver, time_step, boundary, memory }
    }

    /// # Errors
    /// [`Error::BadParameter`].
    pub(crate) fn check(&self) -> Result<()> {
        self.time_step.check()?;
        self.exact_radius.check()
    }
}

fn bad(name: &'static str, value: &str, range: &'static str) -> Error {
    Error::BadParameter { name, value: value.to_owned(), range }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::choice::Choice;
    use crate::propagation::Windows;

    fn read_back<C: Choice>() {
        for &choice in C::ALL {
            for name in [choice.name()].iter().chain(choice.former_names()) {
                assert_eq!(name.parse::<C>(), Ok(choice));
            }
        }
    }

    #[test]
    fn every_name_is_read_back() {
        read_back::<Boundary>();
        read_back::<EdgeKind>();
        read_back::<FaceField>();
        read_back::<LinearSolver>();
        read_back::<Method>();
        read_back::<MultiSource>();
        read_back::<Operator>();
        read_back::<PathKind>();
        read_back::<Up>();
        read_back::<VertexField>();
        assert_eq!("superposed".parse(), Ok(MultiSource::Summed), "links of before");
    }

    #[test]
    fn the_default_number_of_windows_is_that_of_propagation_and_is_offered() {
        assert_eq!(Windows::default().to_string(), DEFAULT_WINDOWS.to_string());
        assert!(WINDOWS.contains(&DEFAULT_WINDOWS));
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_names_there_are() {
        let error = "best".parse::<Operator>().unwrap_err();
        assert_eq!(error.to_string(), "there is no operator 'best'; choose one of delaunay, plain, relocate");
    }
}
