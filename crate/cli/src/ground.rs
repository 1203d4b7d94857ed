//! What the ground costs, and where nobody may walk, from the command line.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

use anyhow::{Context, Result, anyhow, bail, ensure};
use clap::{Args, ValueEnum};
use glam::DVec3;
use heatwalk::{Costs, DistanceSolver, FaceData, InputTriangle, InputVertex, Relief, Soup, Surface, Up, Walls};
use heatwalk_model::Model;
use heatwalk_volume::{TetMesh, TetSoup};

use crate::labels::named_vertices;
use crate::lists::statements;

/// Ground of different difficulty.
#[derive(Args)]
pub struct Ground {
    /// What a unit of length costs, 0.001 to 1000: a CSV file with rows of triangle,cost (1 where there is none), or
    /// attribute:NAME, numbers that the file gives its vertices; of attribute:COLOR white costs 1, black 10
    #[arg(long, value_name = "FILE|attribute:NAME")]
    pub weights: Option<Weights>,
    /// Cost by how steep the ground is against --up: Tobler's hiking function, the mean of both directions
    #[arg(long, value_name = "NAME", group = "turned")]
    pub slope_cost: Option<SlopeCost>,
    /// Cost by height along --up: 1 at the lowest place, H at the highest, its logarithm in proportion between
    #[arg(long, value_name = "H", group = "turned", value_parser = cost, allow_negative_numbers = true)]
    pub height_cost: Option<f64>,
    /// Where nobody may walk: a CSV file with a triangle a row, or the two vertices of an edge; or FILE#NAME, the vertices of a label of a .label.gii or
    /// .annot file, such as a medial wall
    #[arg(long, value_name = "FILE")]
    pub walls: Option<PathBuf>,
}

/// Where costs come from.
#[derive(Debug, Clone)]
pub enum Weights {
    File(PathBuf),
    Attribute(String),
}

impl FromStr for Weights {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(match text.strip_prefix("attribute:") {
            Some(name) => Self::Attribute(name.to_owned()),
            None => Self::File(text.into()),
        })
    }
}

/// A cost by slope.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum SlopeCost {
    Tobler,
}

fn cost(text: &str) -> Result<f64, String> {
    let (least, most) = (Costs::RANGE.start(), Costs::RANGE.end());
    let cost = text.parse().ok().filter(|cost| Costs::RANGE.contains(cost));
    cost.ok_or_else(|| format!("a cost from {least} to {most} is needed"))
}

/// In place of an attribute's name: the colors of the vertices.
const COLOR: &str = "COLOR";

/// What black costs.
const COST_OF_BLACK: f64 = 10.0;

impl Ground {
    /// Puts these on a solver's surface.
    pub fn lay(&self, solver: &mut DistanceSolver, model: &Model, up: Up) -> Result<()> {
        let surface = Arc::clone(solver.whole());
        if let Some(path) = &self.walls {
            solver.set_walls(&walls(path, &model.soup, &surface)?)?;
        }
        let weights = match &self.weights {
            Some(Weights::File(path)) => Some(of_file(path, &model.soup, &surface)?),
            Some(Weights::Attribute(name)) => Some(of_attribute(name, model, &surface)?),
            None => None,
        };
        let relief = Relief { slope: self.slope_cost.is_some(), highest: self.height_cost.unwrap_or(1.0) };
        let costs = Costs::both(weights, relief.costs(&surface, axis(up))?);
        solver.set_costs(costs);
        Ok(())
    }
}

impl Ground {
    /// What these mean inside of tetrahedra: the cost of each (`#T`), infinite for walls, where any are given.
    pub fn inside(&self, soup: &TetSoup, mesh: &TetMesh) -> Result<Option<Vec<f64>>> {
        for (name, is_given) in [("slope", self.slope_cost.is_some()), ("height", self.height_cost.is_some())] {
            ensure!(!is_given, "--{name}-cost is for surfaces and has no effect inside of tetrahedra");
        }
        let weights = match &self.weights {
            Some(Weights::File(path)) => Some(path),
            Some(Weights::Attribute(_)) => bail!("attributes are for surfaces; give --weights of tetrahedra in a file"),
            None => None,
        };
        if weights.is_none() && self.walls.is_none() {
            return Ok(None);
        }
        let mut costs = vec![1.0; mesh.tetrahedron_count()];
        let count = soup.tetrahedra.len();
        let weights = weights.map(|path| weighted(path, count, "tetrahedron")).transpose()?;
        for (tetrahedron, cost) in weights.unwrap_or_default() {
            if let Some(tetrahedron) = mesh.tetrahedron_of_input(tetrahedron as usize) {
                costs[tetrahedron.index()] = cost;
            }
        }
        for (line, row) in self.walls.as_deref().map(rows).transpose()?.unwrap_or_default() {
            let path = self.walls.as_deref().unwrap_or(Path::new(""));
            let &[tetrahedron] = row.as_slice() else { bail!("{}, line {line}: give a tetrahedron", path.display()) };
            let tetrahedron = number(tetrahedron, count, "tetrahedron", (path, line))?;
            if let Some(tetrahedron) = mesh.tetrahedron_of_input(tetrahedron as usize) {
                costs[tetrahedron.index()] = f64::INFINITY;
            }
        }
        Ok(Some(costs))
    }
}

/// What points up in the file.
fn axis(up: Up) -> DVec3 {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
    axes.into_iter().find(|&axis| up.turned(axis) == DVec3::Y).unwrap_or(DVec3::Y)
}

/// The rows of a CSV file, as numbers, with the lines that they are on. A first row of words is a heading.
fn rows(path: &Path) -> Result<Vec<(usize, Vec<f64>)>> {
    let rows = statements(path)?.into_iter().enumerate().filter_map(|(index, (line, row))| {
        let numbers: Result<Vec<f64>, _> = row.split(',').map(|cell| cell.trim().parse()).collect();
        match numbers {
            Ok(numbers) => Some(Ok((line, numbers))),
            Err(_) if index == 0 => None,
            Err(_) => Some(Err(anyhow!("{}, line {line}: {row:?} is no row of numbers", path.display()))),
        }
    });
    all(rows)
}

/// All results, or the first failure and how many there are besides.
fn all<T>(results: impl Iterator<Item = Result<T>>) -> Result<Vec<T>> {
    let (mut found, mut failures) = (Vec::new(), Vec::new());
    for result in results {
        match result {
            Ok(value) => found.push(value),
            Err(failure) => failures.push(failure),
        }
    }
    let more = failures.len().saturating_sub(1);
    match failures.into_iter().next() {
        None => Ok(found),
        Some(first) if more == 0 => Err(first),
        Some(first) => bail!("{first:#}; {more} more rows are wrong, too"),
    }
}

/// A whole number of a row that counts something of the file.
fn number(value: f64, count: usize, what: &str, (path, line): (&Path, usize)) -> Result<u32> {
    ensure!(
        value.fract() == 0.0 && (0.0..count as f64).contains(&value),
        "{}, line {line}: there is no {what} {value}; the file has {count}, counted from 0",
        path.display()
    );
    Ok(value as u32)
}

/// Elements of the file with their costs, of a CSV file with a row each.
fn weighted(path: &Path, count: usize, what: &str) -> Result<Vec<(u32, f64)>> {
    let mut costs: HashMap<u32, (usize, f64)> = HashMap::new();
    let weighted = rows(path)?.into_iter().map(|(line, row)| {
        let &[element, cost] = row.as_slice() else {
            bail!("{}, line {line}: give a {what} and its cost, such as 12,2.5", path.display());
        };
        let element = number(element, count, what, (path, line))?;
        ensure!(
            Costs::RANGE.contains(&cost),
            "{}, line {line}: the cost is {cost}; it must be from {} to {}; what nobody may enter belongs in --walls",
            path.display(),
            Costs::RANGE.start(),
            Costs::RANGE.end()
        );
        let (first, before) = *costs.entry(element).or_insert((line, cost));
        ensure!(
            before == cost,
            "{}, line {line}: {what} {element} costs {cost} here and {before} in line {first}; give it one cost",
            path.display()
        );
        Ok((element, cost))
    });
    all(weighted)
}

fn of_file(path: &Path, soup: &Soup, surface: &Surface) -> Result<Costs> {
    let mut costs: FaceData<f64> = vec![1.0; surface.face_count()].into();
    for (triangle, cost) in weighted(path, soup.triangles.len(), "triangle")? {
        // One that was dropped for being degenerate has no face.
        if let Some(face) = surface.face_of_triangle(InputTriangle(triangle)) {
            costs[face] = cost;
        }
    }
    Ok(Costs::new(surface, costs)?)
}

fn of_attribute(name: &str, model: &Model, surface: &Surface) -> Result<Costs> {
    let of_vertex: Vec<f64> = if name == COLOR {
        let colors = &model.appearance.colors;
        ensure!(colors.len() == model.soup.positions.len(), "the file gives its vertices no colors");
        // Luminance of linear light (ITU-R BT.709).
        let luminance = |&[red, green, blue, _]: &[u16; 4]| {
            [(red, 0.2126), (green, 0.7152), (blue, 0.0722)]
                .map(|(channel, share)| f64::from(channel) / f64::from(u16::MAX) * share)
                .iter()
                .sum::<f64>()
        };
        colors.iter().map(|color| COST_OF_BLACK.powf(1.0 - luminance(color))).collect()
    } else {
        model.soup.attribute(name)?.to_vec()
    };
    Costs::of_input_vertices(surface, &of_vertex).with_context(|| format!("--weights attribute:{name}"))
}

fn walls(path: &Path, soup: &Soup, surface: &Surface) -> Result<Walls> {
    let mut walls = Walls::default();
    if let Some(vertices) = named_vertices(path)? {
        let mut is_wall = vec![false; soup.positions.len()];
        for vertex in vertices {
            let vertices = is_wall.len();
            *is_wall.get_mut(vertex).ok_or(heatwalk::surface::Error::NoSuchVertex { vertex, vertices })? = true;
        }
        let is_touched = |&(_, corners): &(u32, &[u32; 3])| corners.iter().any(|&corner| is_wall[corner as usize]);
        let touched = (0..).zip(&soup.triangles).filter(is_touched);
        walls.faces.extend(touched.filter_map(|(triangle, _)| surface.face_of_triangle(InputTriangle(triangle))));
        return Ok(walls);
    }
    for (line, row) in rows(path)? {
        let at = (path, line);
        match *row.as_slice() {
            [triangle] => {
                let triangle = number(triangle, soup.triangles.len(), "triangle", at)?;
                walls.faces.extend(surface.face_of_triangle(InputTriangle(triangle)));
            }
            [a, b] => {
                let vertex = |end| {
                    let input = number(end, soup.positions.len(), "vertex", at)?;
                    Ok::<_, anyhow::Error>(surface.vertex_of_input(InputVertex(input)))
                };
                let ends = vertex(a)?.zip(vertex(b)?);
                match ends.and_then(|(a, b)| surface.halfedge_between(a, b)) {
                    Some(halfedge) => walls.edges.push(halfedge),
                    None => bail!("{}, line {line}: no edge joins the vertices {a} and {b}", path.display()),
                }
            }
            _ => bail!("{}, line {line}: give a triangle, or the two vertices of an edge", path.display()),
        }
    }
    Ok(walls)
}
