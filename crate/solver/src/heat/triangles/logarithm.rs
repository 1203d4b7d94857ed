//! The field of the logarithm of heat, and distance along it: in each triangle the unit vector against the gradient of log u, on a
//! bumpy surface somewhat shorter.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! triangle: it points along distance where the gradient of heat leans towards the warmest corner.
//!
//! Shortest paths on a bumpy surface bend around its bumps, while heat, which takes all paths, goes on straight. A field so
//! straight would gain on distance with a length of 1.

use std::sync::Arc;

use heatwalk_base::logarithm::ln;

use crate::extremum::{larger, smaller};
use crate::heat::bounds::Bounds;
use crate::heat::time::long_edge_factor;
use crate::heat::triangles::upwind::{EdgeField, Length, Upwind, WHOLE};
use crate::operator::elements::{BLOCK, Element, Elements};
use crate::operator::{Laplacian, Operators};

/// What the length is less than 1 by, times the square of the surface's bumpiness in radians: how much longer a path over a bump is
/// grows with the square of the slope.
const LOSS: f64 = 0.3;

/// In no triangle is a unit of the logarithm more than so many √t of distance. Where heat meets from all sides it would be.
const MOST_RATE: f64 = 10.0;

/// Of what both triangles make of an edge the mean is taken by the cotangents opposite, as the stiffness matrix does, but none counts
/// less than this.
const LEAST_COTAN: f64 = 1e-3;

/// √t is at least this share of long sides.
const LONG_SIDE_SHARE: f64 = 0.5;

/// But m is no more than this for their sake: beyond, heat would round off too much everywhere else.
const MOST_FOR_LONG_SIDES: f64 = 5.0;

/// What distance along the field needs of a surface.
#[derive(Debug)]
pub(super) struct Logarithm {
    upwind: Upwind,
    /// `#F`, the sides opposite each corner.
    sides: Vec<[Side; 3]>,
    /// The unit of lengths.
    unit: f64,
    /// `#V`, what heat is to be computed with: plane waves are nearly solutions then on uneven meshes, too.
    mass: Arc<[f64]>,
    least_time_factor: f64,
    /// `#E`, in the unit of lengths, no more than they are.
    lengths: Vec<Length>,
    bounds: Bounds,
}

/// A side of a triangle.
#[derive(Debug, Clone, Copy, Default)]
struct Side {
    /// Which of the [edges](Laplacian::edges) it is.
    edge: u32,
    /// What the triangle counts for there, over the length of the edge, to a scale: see [`sides`].
    share: f32,
}

impl Logarithm {
    /// On a surface of this [bumpiness](crate::exact::ExactGeometry::bumpiness).
    pub(super) fn new(operators: &Operators, bumpiness: f64, bounds: Bounds) -> Self {
        let (elements, laplacian) = (&operators.elements, operators.laplacian());
        let unit = operators.mean_edge();
        let length = 1.0 - LOSS * bumpiness * bumpiness;
        let lengths = lengths(elements, laplacian, unit);
        Self {
            upwind: Upwind::new(laplacian, unit),
            sides: sides(elements, laplacian, &lengths, f64::from(WHOLE) * length),
            unit,
            lengths,
            mass: operators.circumcentric_mass().into(),
            least_time_factor: least_time_factor(operators),
            bounds,
        }
    }

    /// The mass (`#V`) of the heat that it takes, in the unit of the lengths, squared.
    pub(super) fn mass(&self) -> &Arc<[f64]> {
        &self.mass
    }

    /// The least m in t = m h² with which that heat tells of distance.
    pub(super) fn least_time_factor(&self) -> f64 {
        self.least_time_factor
    }

    /// What its distances are to keep.
    pub(super) fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Distances (`#V`) along the field of `heat` (`#V`) that has flowed for this time, in the unit of the lengths, squared. Those below
    /// infinity in `known` (`#V`) stay; infinite where heat tells nothing.
    pub(super) fn distances(&self, operators: &Operators, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64> {
        let logarithms: Vec<f64> = heat.iter().map(|&heat| ln(larger(heat, f64::MIN_POSITIVE))).collect();
        let rates = self.rates(operators, &logarithms, MOST_RATE * time.sqrt() / self.unit);
        let laplacian = operators.laplacian();
        let mut inflows = self.upwind.inflows();
        for (low, &own) in logarithms.iter().enumerate() {
            let (first, entries) = laplacian.edges_of_column(low);
            let weights = &laplacian.stiffness.values()[entries.clone()];
            let edges = laplacian.rows()[entries].iter().zip(weights).zip(&rates[first..]).zip(&self.lengths[first..]);
            let field = edges.map(|(((&high, weight), rate), &length)| {
                let fall = own - logarithms[high as usize];
                (high, EdgeField { flow: (-weight * fall) as f32, rise: fall as f32 * rate, length })
            });
            inflows.add(low as u32, field);
        }
        self.upwind.distances(&inflows, &logarithms, known)
    }

    /// `#E`, what a unit of the logarithm is in distance along each edge, [`WHOLE`] for the length: the mean of one over the length of
    /// the gradient in the triangles beside it, times that of the field.
    fn rates(&self, operators: &Operators, logarithms: &[f64], most: f64) -> Vec<f32> {
        let elements = &operators.elements;
        let mut rates = vec![0.0; edge_count(operators.laplacian())];
        let blocks = elements.faces.chunks(BLOCK).zip(elements.shapes.chunks(BLOCK)).zip(self.sides.chunks(BLOCK));
        for ((faces, shapes), sides) in blocks {
            let [mut squares, mut areas] = [[1.0; BLOCK]; 2];
            for (place, (face, shape)) in faces.iter().zip(shapes).enumerate() {
                let [x, y] = shape.circulation(face.map(|vertex| logarithms[vertex as usize]));
                squares[place] = x * x + y * y + f64::MIN_POSITIVE;
                areas[place] = shape.twice_area();
            }
            let inverse: [f64; BLOCK] = std::array::from_fn(|place| areas[place] / squares[place].sqrt() / self.unit);
            for (sides, inverse) in sides.iter().zip(inverse) {
                let rate = smaller(inverse, most) as f32;
                for side in sides {
                    rates[side.edge as usize] += side.share * rate;
                }
            }
        }
        rates
    }
}

/// Number of the [edges](Laplacian::edges).
fn edge_count(laplacian: &Laplacian) -> usize {
    laplacian.rows().len() - laplacian.size()
}

fn least_time_factor(operators: &Operators) -> f64 {
    let sides = operators.elements.shapes.iter().flat_map(Element::sides).collect();
    smaller(long_edge_factor(sides, operators.mean_edge(), LONG_SIDE_SHARE), MOST_FOR_LONG_SIDES)
}

/// The edges of the sides opposite the corners of a triangle.
fn opposite_edges([a, b, c]: [u32; 3], laplacian: &Laplacian) -> [Option<usize>; 3] {
    // A side from a vertex to itself is no edge, and counts for nothing.
    [[b, c], [c, a], [a, b]].map(|ends| laplacian.edge(ends))
}

/// `#E`, the lengths of the edges, rounded down; the least where triangles differ.
fn lengths(elements: &Elements, laplacian: &Laplacian, unit: f64) -> Vec<Length> {
    let mut lengths = vec![f64::INFINITY; edge_count(laplacian)];
    for (&face, shape) in elements.faces.iter().zip(&elements.shapes) {
        let [of_c, of_a, of_b] = shape.sides();
        for (edge, length) in opposite_edges(face, laplacian).into_iter().zip([of_a, of_b, of_c]) {
            if let Some(edge) = edge {
                lengths[edge] = smaller(lengths[edge], length);
            }
        }
    }
    lengths.into_iter().map(|length| Length::at_most(length / unit)).collect()
}

/// The sides of all triangles. What those at an edge count for sums to `scale` over its length.
fn sides(elements: &Elements, laplacian: &Laplacian, lengths: &[Length], scale: f64) -> Vec<[Side; 3]> {
    let mut shares = vec![0.0_f32; edge_count(laplacian)];
    let mut sides = Vec::with_capacity(elements.faces.len());
    for (index, (&face, shape)) in elements.faces.iter().zip(&elements.shapes).enumerate() {
        let mut own = [Side::default(); 3];
        for ((side, edge), cotan) in own.iter_mut().zip(opposite_edges(face, laplacian)).zip(shape.cotans()) {
            if let Some(edge) = edge {
                let share = (elements.share(index) * larger(cotan, LEAST_COTAN)) as f32;
                shares[edge] += share;
                *side = Side { edge: edge as u32, share };
            }
        }
        sides.push(own);
    }
    for side in sides.as_flattened_mut() {
        let edge = side.edge as usize;
        // An edge that is too short to have a length is crossed for nothing.
        let length = larger(f64::from(lengths[edge].get()), f64::MIN_POSITIVE);
        side.share = (scale * f64::from(side.share) / f64::from(shares[edge]) / length) as f32;
    }
    sides
}
