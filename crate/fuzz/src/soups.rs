//! Small shapes of any kind, made of a target's bytes.

use arbitrary::{Arbitrary, Result, Unstructured};
use glam::DVec3;
use heatwalk::{FaceId, Place, Soup, Surface, VertexId};
use heatwalk_volume::TetSoup;

/// Vertices of a shape at most; as many triangles twice.
const MOST_VERTICES: usize = 20;
/// Sides of the lattice that vertices mostly lie on: small, so that many coincide, or are in a line or a plane.
const SIDE: i8 = 4;
/// Powers of ten by which an axis is stretched.
const POWERS: [i32; 8] = [0, 0, 0, -12, -6, -2, 3, 8];
/// Powers of ten by which a whole shape is larger.
const SIZES: [i32; 8] = [0, 0, 0, 0, -120, -30, 30, 120];

/// Where a vertex is.
#[derive(Arbitrary, Debug)]
enum Position {
    /// On the lattice.
    Lattice([i8; 3]),
    /// Beside a place of the lattice, by so many parts in 2⁴⁰.
    Beside([i8; 3], [i8; 3]),
    /// Somewhere between.
    Between([i16; 3]),
    /// Whatever eight bytes say, infinite and not a number among them.
    Any([f64; 3]),
}

impl Position {
    fn place(&self) -> DVec3 {
        let lattice = |at: &[i8; 3]| DVec3::from(at.map(|along| f64::from(along % SIDE)));
        match self {
            Self::Lattice(at) => lattice(at),
            Self::Beside(at, by) => lattice(at) + DVec3::from(by.map(f64::from)) * (-40_f64).exp2(),
            Self::Between(at) => DVec3::from(at.map(|along| f64::from(along) / f64::from(1 << 13))),
            Self::Any(at) => DVec3::from(*at),
        }
    }
}

/// A soup of triangles: edges of many faces, faces through each other, needles, folds, several components.
#[derive(Debug)]
pub struct AnySoup(pub Soup);

impl<'a> Arbitrary<'a> for AnySoup {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let positions = positions(data)?;
        let corner = |data: &mut Unstructured<'a>| Ok(data.int_in_range(0..=positions.len() - 1)? as u32);
        let count = data.int_in_range(1..=2 * MOST_VERTICES)?;
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        for _ in 0..count {
            // Mostly beside an edge of the one before, so that surfaces are larger than a triangle.
            let fresh = [corner(data)?, corner(data)?, corner(data)?];
            let next = match triangles.last() {
                Some(&[_, b, c]) if data.ratio(3, 4)? => [c, b, fresh[0]],
                _ => fresh,
            };
            triangles.push(next);
        }
        Ok(Self(Soup::single("any", positions, triangles)))
    }
}

/// A soup of tetrahedra of the same kind.
#[derive(Debug)]
pub struct AnyTetSoup(pub TetSoup);

impl<'a> Arbitrary<'a> for AnyTetSoup {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let positions = positions(data)?;
        let corner = |data: &mut Unstructured<'a>| Ok(data.int_in_range(0..=positions.len() - 1)? as u32);
        let count = data.int_in_range(1..=MOST_VERTICES)?;
        let mut tetrahedra: Vec<[u32; 4]> = Vec::new();
        for _ in 0..count {
            let fresh = [corner(data)?, corner(data)?, corner(data)?, corner(data)?];
            let next = match tetrahedra.last() {
                Some(&[_, b, c, d]) if data.ratio(3, 4)? => [b, c, d, fresh[0]],
                _ => fresh,
            };
            tetrahedra.push(next);
        }
        Ok(Self(TetSoup { positions, tetrahedra }))
    }
}

fn positions(data: &mut Unstructured) -> Result<Vec<DVec3>> {
    let power = |data: &mut Unstructured, of: &[i32; 8]| Ok(10_f64.powi(*data.choose(of)?));
    let scale = DVec3::new(power(data, &POWERS)?, power(data, &POWERS)?, power(data, &POWERS)?);
    let scale = scale * power(data, &SIZES)?;
    let count = data.int_in_range(3..=MOST_VERTICES)?;
    (0..count).map(|_| Ok(Position::arbitrary(data)?.place() * scale)).collect()
}

/// A place on a surface that is not known yet.
#[derive(Arbitrary, Debug)]
pub enum AnyPlace {
    /// A vertex, of so many as there are.
    Vertex(u16),
    /// A place in a face, by shares.
    Face(u16, [u8; 3]),
}

impl AnyPlace {
    /// The place on a surface.
    pub fn on(&self, surface: &Surface) -> Place {
        match *self {
            Self::Vertex(vertex) => Place::Vertex(VertexId(u32::from(vertex) % surface.vertex_count() as u32)),
            Self::Face(face, shares) => {
                let shares = shares.map(f64::from);
                let sum: f64 = shares.iter().sum();
                let weights = if sum > 0.0 { shares.map(|share| share / sum) } else { [1.0, 0.0, 0.0] };
                Place::Face { face: FaceId(u32::from(face) % surface.face_count() as u32), weights }
            }
        }
    }
}
