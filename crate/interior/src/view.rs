//! What is seen of the inside: the cut, shells of equal distance, arrows.

use glam::DVec3;
use heatwalk_bindings::{Failure, Message, Result, number, numbers};
use heatwalk_scene::DrawTransform;
use heatwalk_volume::section::{Cut, Plane, Section, Shells};
use heatwalk_volume::{TetMesh, VolumeDistance};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;

/// What [`InnerView::new`] reads.
#[wasm_bindgen(typescript_custom_section)]
const CUT: &str = "
/** How the inside is looked into. */
export interface InnerCut {
  /** Four numbers a plane: unit normal and offset, as they are drawn. What is beyond one plane, or beyond both of two, is cut away. */
  planes: readonly number[];
  /** Whether whole tetrahedra stay; else the cut is smooth. */
  whole: boolean;
  /** How far apart tetrahedra are moved: 0 leaves them, 1 makes the mesh twice as wide. */
  gap: number;
  /** From one shell of equal distance to the next, as a share of the largest distance; 0 for none. */
  spacing: number;
  /** Whether there are arrows along the gradient on the cut. */
  arrows: boolean;
}
";

/// Tetrahedra that are moved apart at most: each is drawn as four triangles.
const MOST_EXPLODED: usize = 300_000;

/// The narrowest spacing of shells: more could not be told apart.
const LEAST_SPACING: f64 = 0.02;

/// What is drawn of the inside.
#[derive(Message)]
pub struct InnerView {
    /// What closes the cut, or whole tetrahedra.
    pub section: InnerSection,
    /// Whether the section stands in for the boundary.
    pub hides_surface: bool,
    /// Shells of equal distance, whose normals point away from the sources.
    pub shells: InnerTriangles,
    /// Arrows along the gradient of distance.
    pub arrows: InnerArrows,
}

/// Triangles that close the cut, or of whole tetrahedra, and where they are.
#[derive(Message)]
pub struct InnerSection {
    /// Its triangles.
    pub mesh: InnerTriangles,
    /// `#N × 4`: direction in which distance grows, 127 for a unit; the fourth number is 0.
    pub tangents: Vec<i8>,
    /// `#T`, the tetrahedron of the input that each triangle is in.
    pub tetrahedra: Vec<u32>,
    /// `#N × 4`, barycentric weights of each vertex in the tetrahedron of its triangles, by the corners that it has in the input.
    pub weights: Vec<f32>,
}

/// Triangles inside of the solid.
#[derive(Default, Message)]
pub struct InnerTriangles {
    /// `#N × 3`, as they are drawn.
    pub positions: Vec<f32>,
    /// `#N × 3`, unit length.
    pub normals: Vec<f32>,
    /// `#N`, distances; Infinity where no source can be reached; empty without a field.
    pub values: Vec<f32>,
    /// `#T × 3`, indices of the vertices.
    pub triangles: Vec<u32>,
}

/// Arrows inside of the solid; none where the arrays are empty.
#[derive(Default, Message)]
pub struct InnerArrows {
    /// `#A × 3`, as they are drawn.
    pub places: Vec<f32>,
    /// `#A × 3`, the gradient of distance there.
    pub vectors: Vec<f32>,
}

impl InnerView {
    pub(crate) fn new(
        mesh: &TetMesh,
        drawn: &Drawn,
        distance: Option<&VolumeDistance>,
        wanted: &JsValue,
    ) -> Result<Self> {
        let cut = cut_of(&numbers(wanted, "planes"), &drawn.transform)?;
        let spacing = number(wanted, "spacing").unwrap_or(0.0);
        let gap = number(wanted, "gap").unwrap_or(0.0);
        let is_whole = flag(wanted, "whole");
        let section = if gap > 0.0 {
            if mesh.tetrahedron_count() > MOST_EXPLODED {
                return Err(Failure::misuse(&format!(
                    "{} tetrahedra are too many to be moved apart; up to {MOST_EXPLODED} can, so fill it more coarsely",
                    mesh.tetrahedron_count()
                )));
            }
            Section::exploded(mesh, &cut, gap)
        } else if is_whole {
            Section::of_tetrahedra(mesh, &cut)
        } else {
            Section::of_cut(mesh, &cut)
        };
        // Without a cut, shells would be behind all the rest.
        let has_only_shells = spacing > 0.0 && cut == Cut::Whole && gap == 0.0 && !is_whole;
        let shells = match distance.filter(|_| spacing > 0.0) {
            Some(distance) => {
                let levels = levels(distance.max(), spacing.max(LEAST_SPACING));
                InnerTriangles::of_shells(drawn, Shells::in_cut(mesh, distance, &levels, &cut)?)
            }
            None => InnerTriangles::default(),
        };
        let arrows = match distance.filter(|_| flag(wanted, "arrows")) {
            Some(distance) => InnerArrows::on(mesh, drawn, distance, &section)?,
            None => InnerArrows::default(),
        };
        Ok(Self {
            section: InnerSection::new(mesh, drawn, distance, &section)?,
            hides_surface: gap > 0.0 || is_whole || has_only_shells,
            shells,
            arrows,
        })
    }
}

impl InnerTriangles {
    fn of_shells(drawn: &Drawn, shells: Shells) -> Self {
        Self {
            positions: drawn.transform.places(shells.positions),
            normals: drawn.transform.directions(shells.normals),
            values: singles(shells.values),
            triangles: shells.triangles.into_flattened(),
        }
    }
}

impl InnerSection {
    fn new(mesh: &TetMesh, drawn: &Drawn, distance: Option<&VolumeDistance>, section: &Section) -> Result<Self> {
        let (values, tangents) = match distance {
            Some(distance) => (
                singles(section.interpolate(mesh, &distance.values)?),
                section.gradients(mesh, distance)?.into_iter().flat_map(|gradient| drawn.bytes(gradient)).collect(),
            ),
            None => Default::default(),
        };
        let tetrahedron = |corners: &[u32; 3]| drawn.input_of(section.tetrahedra[corners[0] as usize]);
        let weights = (section.tetrahedra.iter().zip(&section.weights))
            .flat_map(|(&tetrahedron, &weights)| drawn.input_weights(tetrahedron, weights));
        Ok(Self {
            mesh: InnerTriangles {
                positions: drawn.transform.places(section.positions.iter().copied()),
                normals: drawn.transform.directions(section.normals.iter().copied()),
                values,
                triangles: section.triangles.as_flattened().to_vec(),
            },
            tangents,
            tetrahedra: section.triangles.iter().map(tetrahedron).collect(),
            weights: singles(weights),
        })
    }
}

impl InnerArrows {
    /// One a triangle of the section.
    fn on(mesh: &TetMesh, drawn: &Drawn, distance: &VolumeDistance, section: &Section) -> Result<Self> {
        let gradients = section.gradients(mesh, distance)?;
        let middle =
            |corners: &[u32; 3]| corners.iter().map(|&corner| section.positions[corner as usize]).sum::<DVec3>() / 3.0;
        let gradient = |corners: &[u32; 3]| gradients[corners[0] as usize];
        Ok(Self {
            places: drawn.transform.places(section.triangles.iter().map(middle)),
            vectors: drawn.transform.directions(section.triangles.iter().map(gradient)),
        })
    }
}

fn singles(numbers: impl IntoIterator<Item = f64>) -> Vec<f32> {
    numbers.into_iter().map(|number| number as f32).collect()
}

/// The distances of shells up to the largest distance.
fn levels(largest: f64, spacing: f64) -> Vec<f64> {
    let shares = (1..).map(|number| f64::from(number) * spacing).take_while(|&share| share < 1.0);
    shares.map(|share| share * largest).collect()
}

/// What planes that are drawn cut away.
fn cut_of(planes: &[f64], transform: &DrawTransform) -> Result<Cut> {
    let axes = DVec3::AXES.map(|axis| transform.direction(axis));
    let plane = |&[x, y, z, offset]: &[f64; 4]| {
        let drawn = DVec3::new(x, y, z);
        let normal = DVec3::from_array(axes.map(|axis| axis.dot(drawn)));
        Plane { normal, offset: offset / transform.scale + normal.dot(transform.center) }
    };
    let (planes, rest) = planes.as_chunks::<4>();
    match (planes, rest) {
        ([], []) => Ok(Cut::Whole),
        ([one], []) => Ok(Cut::Plane(plane(one))),
        ([one, other], []) => Ok(Cut::Wedge([plane(one), plane(other)])),
        _ => Err(Failure::misuse("a cut is made by no, one or two planes of four numbers each")),
    }
}

fn flag(object: &JsValue, key: &str) -> bool {
    Reflect::get(object, &key.into()).is_ok_and(|value| value.is_truthy())
}
