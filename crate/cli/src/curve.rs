//! Curves that distances are from, as they are written on the command line and in files.

use std::path::PathBuf;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use clap::Args;
use heatwalk::exact::ExactGeometry;
use heatwalk::{
    Choice, Curve, DistanceOptions, DistanceSolver, Method, Place, Sign, SignedDistance, VertexData, curve_distance,
    curve_search, go_on, signed_curve_distance,
};
use serde_json::Value;

use crate::lists::listed;
use crate::locate::Locator;
use crate::options::{choice, chosen};
use crate::place::Place as Written;
use crate::report::milliseconds;

/// What stands for all boundaries of a surface.
const BOUNDARY: &str = "boundary";

/// Curves as sources.
#[derive(Args)]
pub struct Curves {
    /// Source: a curve along shortest paths from place to place, each as for --source, apart by blanks; or boundary, which is all boundaries, of tetrahedra
    /// all around.
    /// Distances are from all of its points. May be repeated
    #[arg(long = "curve", value_name = "P P...|boundary", conflicts_with_all = ["sources", "source_files", "lines"], group = "open")]
    pub curves: Vec<Course>,
    /// Sources: the curves of a text file, one a line; one that ends where it begins is closed. May be repeated
    #[arg(long = "curve-file", value_name = "FILE", conflicts_with_all = ["sources", "source_files", "lines"], group = "open")]
    pub curve_files: Vec<PathBuf>,
    /// Give distances on the left of curves a minus, so that what is inside of a curve that runs counterclockwise, seen from outside, has
    /// negative ones
    #[arg(long)]
    pub signed: bool,
    #[arg(long, requires = "signed", default_value_t, value_parser = choice::<Sign>(), help = chosen::<Sign>("What tells the sign"))]
    pub sign: Sign,
}

/// Where a curve leads.
#[derive(Debug, Clone)]
pub enum Course {
    Boundary,
    Through { places: Vec<Written>, is_closed: bool },
}

impl FromStr for Course {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == BOUNDARY {
            return Ok(Self::Boundary);
        }
        let mut places: Vec<&str> = text.split_whitespace().collect();
        let is_closed = places.len() > 2 && places.first() == places.last();
        if is_closed {
            places.pop();
        }
        let places: Result<Vec<Written>, String> = places.into_iter().map(str::parse).collect();
        let places = places.ok().filter(|places| !places.is_empty());
        let places = places.ok_or_else(|| {
            "give places apart by blanks, such as \"12 5:0.2,0.3,0.5 40\", or boundary for all boundaries".to_owned()
        })?;
        Ok(Self::Through { places, is_closed })
    }
}

impl Course {
    /// On a surface; where it is to be `closed`, back to its begin.
    fn on(&self, locator: &Locator<'_>, solver: &mut DistanceSolver, closed: bool) -> Result<Curve> {
        match self {
            Self::Boundary => {
                let boundary = Curve::boundary(solver.surface());
                boundary.context("the surface has no boundary; give places for the curve")
            }
            Self::Through { places, is_closed } => {
                let points = places.iter().map(|place| locator.point(place)).collect::<Result<Vec<_>>>()?;
                Ok(Curve::through(solver.exact_geometry(), &points, closed || *is_closed, &mut go_on)?)
            }
        }
    }
}

/// Distances from curves.
pub struct Found {
    /// `#V` of the surface.
    pub values: VertexData<f64>,
    /// With their sign, if they have one.
    signed: Option<SignedDistance>,
    /// Milliseconds that they took without the curves.
    pub solve_ms: f64,
    length: f64,
    curves: Vec<Curve>,
    geometry: Arc<ExactGeometry>,
}

impl Curves {
    /// Whether there is any.
    pub fn are_given(&self) -> bool {
        !self.curves.is_empty() || !self.curve_files.is_empty()
    }

    /// Whether they are all boundaries, and nothing else.
    pub fn are_boundaries(&self) -> bool {
        self.curve_files.is_empty() && self.curves.iter().all(|curve| matches!(curve, Course::Boundary))
    }

    /// Fails where an option has no effect.
    pub fn check(&self, options: &DistanceOptions) -> Result<()> {
        ensure!(self.are_given() || !self.signed, "--signed is for distances from curves; give a --curve");
        if self.are_given() {
            let is_exact = matches!(options.method, Method::Auto | Method::Exact);
            ensure!(
                is_exact,
                "distances from curves are exact; leave the method {} to --source or --line",
                options.method.name()
            );
            ensure!(options.max_distance == f64::INFINITY, "--max-distance has no effect with --curve");
        }
        Ok(())
    }

    /// Distances from all of them.
    pub fn distances(&self, locator: &Locator<'_>, solver: &mut DistanceSolver, closed: bool) -> Result<Found> {
        let mut curves = Vec::new();
        for (number, course) in self.curves.iter().enumerate() {
            curves.push(course.on(locator, solver, closed).with_context(|| format!("curve {number}"))?);
        }
        for file in &self.curve_files {
            for (number, course) in listed::<Course>(file, "curve")?.iter().enumerate() {
                let curve = course.on(locator, solver, closed);
                curves.push(curve.with_context(|| format!("{}, curve {number}", file.display()))?);
            }
        }
        let geometry = Arc::clone(solver.exact_geometry());
        let start = Instant::now();
        let (values, signed) = if self.signed {
            let signed = signed_curve_distance(&geometry, &curves, self.sign, &mut go_on)?;
            (signed.values.clone(), Some(signed))
        } else {
            (curve_distance(&geometry, &curves, &mut go_on)?, None)
        };
        let solve_ms = milliseconds(start);
        let lengths = curves.iter().map(|curve| curve.length(geometry.surface()));
        let length = lengths.sum::<heatwalk::Result<f64>>()?;
        Ok(Found { values, signed, solve_ms, length, curves, geometry })
    }
}

impl Found {
    /// Distances at places of the surface, with the sign, if they have one.
    pub fn at(&self, places: &[Place]) -> heatwalk::Result<Vec<f64>> {
        if let Some(signed) = &self.signed {
            return signed.at(&self.geometry, &self.curves, places, &mut go_on);
        }
        let mut front = curve_search(&self.geometry, &self.curves, places)?;
        while !front.advance(f64::INFINITY, usize::MAX)? {}
        Ok(front.target_values().to_vec())
    }

    /// What is to be told, of the values `of_inputs`.
    pub fn facts(&self, of_inputs: &[f64]) -> Vec<(&'static str, Value)> {
        let finite = || of_inputs.iter().copied().filter(|value| value.is_finite());
        let mut facts = vec![
            ("method", Method::Exact.name().into()),
            ("curves_given", self.curves.len().into()),
            ("curve_length", self.length.into()),
            ("max_distance", finite().fold(f64::NEG_INFINITY, f64::max).into()),
        ];
        if let Some(SignedDistance { sign, .. }) = self.signed {
            facts.push(("min_distance", finite().fold(f64::INFINITY, f64::min).into()));
            facts.push(("sign", sign.name().into()));
        }
        facts.push(("unreachable", of_inputs.iter().filter(|value| value.is_infinite()).count().into()));
        facts
    }
}
