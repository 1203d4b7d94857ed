//! What tells whether a matrix that was begun is the one that is asked for.

use std::fmt::{self, Write};
use std::hash::{DefaultHasher, Hasher};

use anyhow::Result;
use heatwalk::{DistanceOptions, DistanceSolver, SurfacePoint, VertexId};

use super::row::Layout;
use crate::place::Place;

/// Rows and columns.
pub struct Question<'a> {
    pub places: &'a [Place],
    pub sources: &'a [Option<SurfacePoint>],
    pub columns: &'a [Option<VertexId>],
    pub options: &'a DistanceOptions,
}

/// Hashes what is written to it. Another version of the compiler may hash otherwise; then a matrix is begun anew.
struct Hashed(DefaultHasher);

impl Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

/// Of all that its bytes depend on: the surface with its walls, costs and bridges, the places, the options, and the version of the program.
pub fn fingerprint(solver: &DistanceSolver, question: &Question<'_>, layout: &Layout) -> Result<String> {
    let Question { places, sources, columns, options } = question;
    let mut hashed = Hashed(DefaultHasher::new());
    let surface = solver.surface();
    write!(hashed, "{} {options:?} {layout:?} {places:?} {columns:?}", env!("CARGO_PKG_VERSION"))?;
    for source in *sources {
        write!(hashed, "{:?}", source.map(|source| source.place()))?;
    }
    write!(hashed, "{:?} {:?}", surface.positions(), surface.faces())?;
    write!(hashed, "{:?} {:?}", solver.costs(), solver.joined().bridges().portals())?;
    Ok(format!("{:016x}", hashed.0.finish()))
}
