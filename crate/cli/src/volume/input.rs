//! Files of tetrahedra and what refers to them on the command line.

use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};
use heatwalk::{MultiSource, UnitRule, WeldRule};
use heatwalk_files::{TetPlace, read_tetrahedra};
use heatwalk_volume::io::{CellCounts, TetFile};
use heatwalk_volume::{TetMesh, TetPoint, TetSoup, TetSource, VolumeOptions, edge_polyline, shapes};

use crate::args::{Bridging, Mesh, Solving};
use crate::input::SHAPE;
use crate::place::{Line, Place, SourcePlace};
use crate::report::milliseconds;

/// Tetrahedra of a file, or of a shape made in code.
pub struct Input {
    pub soup: TetSoup,
    /// What the cells were in the file.
    pub cells: CellCounts,
    pub read_ms: f64,
}

impl Input {
    /// Refuses tetrahedra: `what` a command does, not inside of them.
    pub fn refuse(arguments: &Mesh, what: &str) -> Result<()> {
        ensure!(Self::of(arguments)?.is_none(), "{what} of tetrahedra; give the surface");
        Ok(())
    }

    /// What the arguments of a command name; none where that is a surface.
    pub fn of(arguments: &Mesh) -> Result<Option<Self>> {
        let start = Instant::now();
        let path = &arguments.mesh;
        let file = match path.to_str().and_then(|path| path.strip_prefix(SHAPE)) {
            Some(name) => shapes::by_name(name).map(|soup| TetFile { soup, cells: CellCounts::default() }),
            None => read_tetrahedra(path)?,
        };
        let Some(TetFile { soup, cells }) = file else { return Ok(None) };
        let given = [
            ("--part", !arguments.parts.is_empty()),
            ("--animation", arguments.animation.is_some()),
            ("--weld", arguments.weld != WeldRule::default()),
            ("--unit", arguments.unit != UnitRule::default()),
        ];
        refuse(&given)?;
        Ok(Some(Self { soup, cells, read_ms: milliseconds(start) }))
    }
}

/// Refuses options that are for surfaces.
pub fn refuse(given: &[(&str, bool)]) -> Result<()> {
    match given.iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => bail!("{option} is for surfaces and has no effect inside of tetrahedra"),
        None => Ok(()),
    }
}

/// Refuses to join the components of tetrahedra.
pub fn refuse_bridging(bridging: &Bridging) -> Result<()> {
    refuse(&[("--bridge", bridging.rule != heatwalk::BridgeRule::default()), ("--link", bridging.links > 0)])
}

/// What is asked of the solver; `heat_option`: the first option of the heat method that is given.
pub fn volume_options(
    solving: &Solving,
    heat_option: Option<&'static str>,
    sources: MultiSource,
) -> Result<VolumeOptions> {
    refuse_bridging(&solving.bridging)?;
    refuse(&[("--windows", solving.methods.windows.is_some()), ("--operator", solving.options.operator.is_some())])?;
    let method = solving.methods.chosen_inside(heat_option)?;
    Ok(VolumeOptions { method, heat: solving.heat(sources), ..VolumeOptions::default() })
}

/// The point of a mesh. Vertices and tetrahedra are counted as in the file.
pub fn point(place: Place, soup: &TetSoup, mesh: &TetMesh) -> Result<TetPoint> {
    let place = match place {
        Place::Vertex(vertex) => TetPlace::Vertex(vertex),
        Place::Coordinates(position) => TetPlace::At(position),
        Place::Triangle { .. } => bail!("three weights are for triangles; a place in a tetrahedron has four"),
        Place::Tetrahedron { tetrahedron, weights } => TetPlace::Inside { tetrahedron, weights },
    };
    Ok(place.on(soup, mesh)?)
}

/// The source in a mesh.
pub fn source(source: &SourcePlace, soup: &TetSoup, mesh: &TetMesh) -> Result<TetSource> {
    Ok(TetSource { point: point(source.place, soup, mesh)?, initial_distance: source.initial_distance })
}

/// A source at each vertex along a line of edges.
pub fn along(line: &Line, soup: &TetSoup, mesh: &TetMesh, closed: bool) -> Result<Vec<TetSource>> {
    let through =
        line.vertices().iter().map(|&vertex| TetPlace::vertex_of(vertex, soup, mesh)).collect::<Result<Vec<_>, _>>()?;
    let vertices = edge_polyline(mesh, &through, closed).with_context(|| format!("line {:?}", line.vertices()))?;
    Ok(vertices.into_iter().map(TetSource::from).collect())
}
