//! Places on the surface, as they are written on the command line.

use std::fmt;
use std::str::FromStr;

use anyhow::{Context, Result, bail};
use glam::DVec3;
use heatwalk::{Element, InputPlace, InputVertex, Soup, Source, Surface, VertexId, edge_polyline};

/// A vertex `V`, or a place `F:b0,b1,b2` in a triangle or `T:b0,b1,b2,b3` in a tetrahedron, counted as in the file; or the one nearest to
/// coordinates `@X,Y,Z`.
#[derive(Debug, Clone, Copy)]
pub enum Place {
    Vertex(usize),
    /// Barycentric weights of the corners, in the file's order.
    Triangle {
        triangle: usize,
        weights: [f64; 3],
    },
    /// Barycentric weights of the corners, in the file's order.
    Tetrahedron {
        tetrahedron: usize,
        weights: [f64; 4],
    },
    /// In the unit and the axes of the file, finite.
    Coordinates(DVec3),
}

/// A place and the distance that it starts from, `S` or `S@D`.
#[derive(Debug, Clone, Copy)]
pub struct SourcePlace {
    pub place: Place,
    pub initial_distance: f64,
}

/// A place and what it counts for, `P` or `P@W`.
#[derive(Debug, Clone, Copy)]
pub struct WeightedPlace {
    pub place: Place,
    pub weight: f64,
}

/// Two places, apart by blanks, or two vertices, apart by a comma.
#[derive(Debug, Clone, Copy)]
pub struct Pair(pub [Place; 2]);

/// A vector at a place, `P:X,Y,Z`.
#[derive(Debug, Clone, Copy)]
pub struct PlacedVector {
    pub place: Place,
    pub vector: DVec3,
}

/// Vertices `V,V[,V...]` that a line of sources goes through.
#[derive(Debug, Clone)]
pub struct Line(Vec<usize>);

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(coordinates) = text.strip_prefix('@') {
            let position = vector(coordinates).filter(|position| position.is_finite());
            let position =
                position.ok_or_else(|| "after @ give three finite coordinates, such as @0.5,1,0".to_owned())?;
            return Ok(Self::Coordinates(position));
        }
        let place = match text.split_once(':') {
            None => text.parse().ok().map(Self::Vertex),
            Some((element, weights)) => {
                let weights: Option<Vec<f64>> = weights.split(',').map(|weight| weight.parse().ok()).collect();
                element.parse().ok().zip(weights).and_then(|(element, weights)| match weights[..] {
                    [a, b, c] => Some(Self::Triangle { triangle: element, weights: [a, b, c] }),
                    [a, b, c, d] => Some(Self::Tetrahedron { tetrahedron: element, weights: [a, b, c, d] }),
                    _ => None,
                })
            }
        };
        place.ok_or_else(|| {
            "give a vertex, such as 12, a triangle and three weights, such as 5:0.2,0.3,0.5 (of a tetrahedron, four), or coordinates, such as @0.5,1,0"
                .to_owned()
        })
    }
}

impl fmt::Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let written = |weights: &[f64]| weights.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        match self {
            Self::Vertex(vertex) => write!(formatter, "{vertex}"),
            Self::Triangle { triangle, weights } => write!(formatter, "{triangle}:{}", written(weights)),
            Self::Tetrahedron { tetrahedron, weights } => write!(formatter, "{tetrahedron}:{}", written(weights)),
            Self::Coordinates(position) => write!(formatter, "@{}", written(&position.to_array())),
        }
    }
}

impl FromStr for SourcePlace {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Some((place, initial_distance)) = split_number(text) else {
            return Ok(Self { place: text.parse()?, initial_distance: 0.0 });
        };
        match initial_distance.parse::<f64>() {
            Ok(initial_distance) if initial_distance.is_finite() && initial_distance >= 0.0 => {
                Ok(Self { place: place.parse()?, initial_distance })
            }
            _ => Err("after @ give the distance that the source starts from, 0 or more, such as 12@0.5".to_owned()),
        }
    }
}

impl FromStr for WeightedPlace {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Some((place, weight)) = split_number(text) else {
            return Ok(Self { place: text.parse()?, weight: 1.0 });
        };
        let weight = weight.parse().ok().filter(|&weight: &f64| weight > 0.0 && weight.is_finite());
        let weight = weight.ok_or_else(|| "after @ give a positive weight, such as 12@0.5".to_owned())?;
        Ok(Self { place: place.parse()?, weight })
    }
}

/// A place and the number after it, if there is one. An `@` that a place begins with is its own.
fn split_number(text: &str) -> Option<(&str, &str)> {
    let own = usize::from(text.starts_with('@'));
    let at = own + text[own..].find('@')?;
    Some((&text[..at], &text[at + 1..]))
}

impl FromStr for PlacedVector {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.rsplit_once(':').and_then(|(place, numbers)| Some((place, vector(numbers)?)));
        let (place, vector) = parts.ok_or_else(|| {
            "give a place and a vector of three numbers there, such as 12:1,0,0 or 5:0.2,0.3,0.5:1,0,0".to_owned()
        })?;
        Ok(Self { place: place.parse()?, vector })
    }
}

impl FromStr for Pair {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words: Vec<&str> = match text.split_once(',') {
            Some((from, to)) if !text.contains([':', '@']) => vec![from.trim(), to.trim()],
            _ => text.split_whitespace().collect(),
        };
        match words[..] {
            [from, to] => Ok(Self([from.parse()?, to.parse()?])),
            _ => {
                Err("give two places apart by blanks, such as 12 5:0.2,0.3,0.5, or two vertices, such as 12,40"
                    .to_owned())
            }
        }
    }
}

/// A vector in space, of three numbers.
pub fn vector(text: &str) -> Option<DVec3> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.parse().ok()).collect();
    numbers.and_then(|numbers| numbers.try_into().ok()).map(DVec3::from_array)
}

impl FromStr for Line {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let vertices: Option<Vec<usize>> = text.split(',').map(|vertex| vertex.parse().ok()).collect();
        let vertices = vertices.filter(|vertices| vertices.len() > 1);
        vertices.map(Self).ok_or_else(|| "give two vertices or more, such as 3,17,40".to_owned())
    }
}

impl From<InputPlace> for Place {
    fn from(place: InputPlace) -> Self {
        match place {
            InputPlace::Vertex(vertex) => Self::Vertex(vertex),
            InputPlace::Triangle { triangle, weights } => Self::Triangle { triangle, weights },
        }
    }
}

impl Place {
    /// Fails early, before the surface is built, for a vertex or triangle that does not exist.
    pub fn check(&self, soup: &Soup) -> Result<()> {
        match self {
            Self::Coordinates(_) => Ok(()),
            place => Ok(place.of_surface()?.check(soup)?),
        }
    }

    /// Its number, where it is a vertex.
    pub fn vertex(&self) -> Option<usize> {
        match *self {
            Self::Vertex(vertex) => Some(vertex),
            _ => None,
        }
    }

    /// As a cell of a table, where weights and coordinates are apart by commas.
    pub fn in_table(&self) -> String {
        match self {
            Self::Vertex(vertex) => vertex.to_string(),
            place => format!("\"{place}\""),
        }
    }

    /// On the triangles of a file.
    pub fn of_surface(&self) -> Result<InputPlace> {
        match *self {
            Self::Vertex(vertex) => Ok(InputPlace::Vertex(vertex)),
            Self::Triangle { triangle, weights } => Ok(InputPlace::Triangle { triangle, weights }),
            Self::Tetrahedron { .. } => bail!("four weights are for tetrahedra; a place in a triangle has three"),
            Self::Coordinates(_) => bail!("{self} is looked for on the surface, not in the file"),
        }
    }
}

impl Line {
    /// As [`Place::check`].
    pub fn check(&self, soup: &Soup) -> Result<()> {
        self.0.iter().try_for_each(|&vertex| Place::Vertex(vertex).check(soup))
    }

    /// A source at each vertex along the line.
    pub fn on(&self, surface: &Surface, closed: bool) -> Result<Vec<Source>> {
        let through = self.0.iter().map(|&vertex| surface.require_vertex(InputVertex::from_index(vertex)));
        let through: Vec<VertexId> = through.collect::<Result<_, _>>()?;
        let vertices = edge_polyline(surface, &through, closed).with_context(|| format!("line {:?}", self.0))?;
        vertices.into_iter().map(|vertex| Ok(surface.source(vertex, 0.0)?)).collect()
    }

    /// The vertices that it is given by, counted as in the file.
    pub fn vertices(&self) -> &[usize] {
        &self.0
    }
}
