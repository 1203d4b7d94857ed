//! What is enclosed, and tetrahedra in it.

use std::collections::HashMap;
use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk::surface::memory;
use heatwalk::{HalfedgeId, Progress, Soup, Stage, Surface};
use heatwalk_base::parallel;

use super::error::{Error, Result};
use super::field::Field;
use super::hierarchy::Hierarchy;
use super::lattice::Lattice;
use super::orientation::oriented;
use super::quality::{boundary, dihedral_angles, volume};
use super::sample::Sample;
use super::stuffing::{Stuffing, cut_edges};
use super::triangle::{Crossing, Triangle, area_vector};
use crate::soup::TetSoup;

/// A surface is open if more points than this have no whole winding number, as a share of those inside.
const OPEN: f64 = 0.25;

/// Most cells along the longest side.
const MOST_CELLS: f64 = 1024.0;
const RANGE_OF_CELLS: &str = "from 1 to 1024";
/// Most tetrahedra: they and their vertices are numbered by 32 bits.
const MOST_TETRAHEDRA: usize = 1 << 28;
const RANGE_OF_TETRAHEDRA: &str = "from 1 to 268435456";

/// Bytes in use at once, a lattice point: its sign, row and vertex, and what is made of it.
const BYTES_PER_POINT: u64 = 64;

/// Cells that a box may end beyond a whole number of them without another one: well above rounding.
const SLACK: f64 = 1e-6;

/// Tetrahedra of a cell.
const TETRAHEDRA_PER_CELL: f64 = 12.0;
const VERTICES_PER_CELL: f64 = 2.0;
/// How many there are more than by the volume, for each line through the lattice that enters or leaves, over the surfaces of
/// docs/accuracy.md at 5,000, 20,000 and 100,000 tetrahedra: the median of tetrahedra, and near the median what serves a sphere, which
/// has fewer vertices, as well as what is thinner than a cell, which has more.
const TETRAHEDRA_PER_CROSSING: f64 = 1.08;
const VERTICES_PER_CROSSING: f64 = 1.1;

/// Crossings of [`Sample::crossings`] per area, in the mean over all orientations.
const CROSSINGS_PER_AREA: f64 = 1.5;

/// Most cells that the boundary is shifted for volume to be kept, and least that are worth it.
const MOST_SHIFT: f64 = 0.1;
const LEAST_SHIFT: f64 = 1e-4;
/// Most times that the boundary is shifted; two are enough but where cells are few.
const SHIFTS: usize = 3;
/// Cells that an edge leads out of the surface at least where its cut is shifted, so that cuts on edges along the surface stay near.
const LEAST_RISE: f64 = 0.25;

/// Tetrahedra, and by vertex whether it is on the surface.
type Stuffed = (TetSoup, Vec<bool>);

/// How fine tetrahedra shall be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Resolution {
    /// So many cells of the lattice along the longest side of the surface's box; from 1 to 1024, whole or not.
    Cells(f64),
    /// About so many tetrahedra, by the [estimate](Solid::estimate).
    Tetrahedra(usize),
}

/// What filling will give, by volume and area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Cells along the longest side.
    pub cells: f64,
    /// Tetrahedra, to some per cent where what is enclosed is thicker than a few cells.
    pub tetrahedra: usize,
    /// Their vertices.
    pub vertices: usize,
}

/// What was made.
#[derive(Debug, Clone, PartialEq)]
pub struct FillReport {
    /// Number of tetrahedra.
    pub tetrahedra: usize,
    /// Number of vertices, each of a tetrahedron at least.
    pub vertices: usize,
    /// Cells of the lattice along the longest side.
    pub cells: f64,
    /// Side of a cell, in the file's unit; the tetrahedra's edges are about as long.
    pub cell_side: f64,
    /// Of all tetrahedra.
    pub volume: f64,
    /// Enclosed by the surface; None where its parts overlap or it has holes, for then its triangles do not tell.
    pub surface_volume: Option<f64>,
    /// The least and the greatest angle between faces of a tetrahedron, in degrees.
    pub dihedral_angles: [f64; 2],
    /// Farthest that a vertex or the middle of a face of the boundary is from the surface, in the file's unit.
    pub deviation: f64,
    /// Holes of the surface that were closed.
    pub holes: usize,
}

/// Tetrahedra, and what there is to say about them.
#[derive(Debug, Clone, PartialEq)]
pub struct Filled {
    /// All oriented alike: a right-handed corner each.
    pub soup: TetSoup,
    /// What was made.
    pub report: FillReport,
}

/// What a surface encloses.
#[derive(Debug)]
pub struct Solid {
    field: Field,
    threads: NonZeroUsize,
    volume: f64,
    /// Whether the triangles tell the volume: they close, and none lies inside.
    is_plain: bool,
    /// As [`Sample::crossings`].
    crossings: f64,
    holes: usize,
}

impl Solid {
    /// Of the surface that was built of a soup (its active parts alone, where it has others), on so many threads, the same however
    /// many.
    ///
    /// # Errors
    /// [`Error::Open`] where it does not enclose anything, with its largest hole; [`Error::NotOriented`].
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    pub fn new(soup: &Soup, surface: &Surface, threads: NonZeroUsize) -> Result<Self> {
        let triangles = oriented(soup, surface);
        let field = Field::new(Hierarchy::new(&triangles, threads));
        let sample = Sample::new(&field, &triangles, threads);
        let holes = surface.report().boundary_loops;
        if sample.undecided > OPEN || (sample.volume == 0.0 && holes > 0) {
            return Err(open(surface));
        }
        let is_nearly_plain = holes == 0 && !sample.has_overlaps;
        let (volume, crossings) =
            if is_nearly_plain { measures(&triangles) } else { (sample.volume, sample.crossings) };
        let is_plain = is_nearly_plain && !sample.has_thin_overlaps;
        Ok(Self { field, threads, volume, is_plain, crossings, holes })
    }

    /// What filling would give, at once.
    ///
    /// # Errors
    /// [`Error::BadParameter`].
    pub fn estimate(&self, resolution: Resolution) -> Result<Estimate> {
        let cells = self.cells(resolution)?;
        let side = self.longest() / cells;
        let (volume, crossings) = (self.volume / side.powi(3), self.crossings / side.powi(2));
        let count = |per_cell: f64, more: f64| (per_cell * volume + more * crossings).max(0.0).round() as usize;
        Ok(Estimate {
            cells,
            tetrahedra: count(TETRAHEDRA_PER_CELL, TETRAHEDRA_PER_CROSSING),
            vertices: count(VERTICES_PER_CELL, VERTICES_PER_CROSSING),
        })
    }

    fn longest(&self) -> f64 {
        self.field.bounds().size().max_element()
    }

    fn cells(&self, resolution: Resolution) -> Result<f64> {
        match resolution {
            Resolution::Cells(cells) if (1.0..=MOST_CELLS).contains(&cells) => Ok(cells),
            Resolution::Cells(cells) => Err(Error::BadParameter {
                name: "the number of cells",
                value: cells.to_string(),
                range: RANGE_OF_CELLS,
            }),
            Resolution::Tetrahedra(count) if (1..=MOST_TETRAHEDRA).contains(&count) => {
                // More cells, more tetrahedra: halved until the number is the nearest.
                let (mut low, mut high) = (1.0, MOST_CELLS);
                for _ in 0..f64::MANTISSA_DIGITS {
                    let middle = 0.5 * (low + high);
                    let is_enough = self.estimate(Resolution::Cells(middle))?.tetrahedra >= count;
                    if is_enough { high = middle } else { low = middle }
                }
                Ok(high)
            }
            Resolution::Tetrahedra(count) => Err(Error::BadParameter {
                name: "the number of tetrahedra",
                value: count.to_string(),
                range: RANGE_OF_TETRAHEDRA,
            }),
        }
    }

    /// Fills it, to the same bits every time.
    ///
    /// # Errors
    /// [`Error::BadParameter`], [`Error::TooCoarse`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn fill(&self, resolution: Resolution, progress: Progress<'_>) -> Result<Filled> {
        let cells = self.cells(resolution)?;
        let lattice = self.lattice(cells)?;
        let (is_inside, near) = self.field.insides(&lattice, self.threads, 0.0..0.35, progress)?;
        let edges = cut_edges(&lattice, &is_inside);
        let cuts = self.field.cuts(&lattice, &edges, self.threads, 0.35..0.65, progress)?;
        let warped = |shift: f64| {
            let share = |cut: &Crossing| cut.share_beyond(shift, LEAST_RISE * lattice.side);
            let shares: Vec<f64> = cuts.iter().map(share).collect();
            let mut stuffing = Stuffing::new(&lattice, &is_inside, &edges, &shares);
            stuffing.warp();
            stuffing
        };
        let plain = warped(0.0);
        let apart: Vec<usize> = near.iter().copied().filter(|&point| plain.is_apart(point)).collect();
        drop(plain);
        let ways = self.field.ways(&lattice, &apart, self.threads, 0.65..0.75, progress)?;
        // A shift hardly moves a tetrahedron, and asking takes long.
        let mut known = HashMap::new();
        let mut stuffed = |shift: f64| {
            let mut stuffing = warped(shift);
            stuffing.pull(&apart, &ways);
            stuffing.tetrahedra(|corners, middle| *known.entry(corners).or_insert_with(|| self.field.is_inside(middle)))
        };
        let first = stuffed(0.0);
        if first.0.tetrahedra.is_empty() {
            return Err(Error::TooCoarse { cells });
        }
        let missing = if self.is_plain {
            self.volume - volume_of(&first.0)
        } else {
            self.field.missing(&first.0, &lattice, &near, self.threads, 0.75..0.9, progress)?
        };
        if progress(Stage::Filling, 0.9).is_break() {
            return Err(Error::Cancelled);
        }
        let (soup, is_on_surface) = self.with_volume(missing, lattice.side, first, stuffed);
        let report = FillReport {
            tetrahedra: soup.tetrahedra.len(),
            vertices: soup.positions.len(),
            cells,
            cell_side: lattice.side,
            volume: volume_of(&soup),
            surface_volume: self.is_plain.then_some(self.volume),
            dihedral_angles: dihedral_angles(&soup).map(f64::to_degrees),
            deviation: self.deviation(&soup, &is_on_surface),
            holes: self.holes,
        };
        Ok(Filled { soup, report })
    }

    /// Tetrahedra with the volume that the first ones are missing, as near as that comes within [`MOST_SHIFT`]: `stuffed` with the
    /// boundary so far beyond the surface. Chords across what bulges and notches where it is thin would take volume away.
    fn with_volume(&self, missing: f64, side: f64, first: Stuffed, mut stuffed: impl FnMut(f64) -> Stuffed) -> Stuffed {
        let enclosed = volume_of(&first.0) + missing;
        let area = self.crossings / CROSSINGS_PER_AREA;
        let (mut all, mut shift) = (first, 0.0);
        for _ in 0..SHIFTS {
            // Area is what volume grows by with the shift, but for jumps where points change sides.
            let next = (shift + (enclosed - volume_of(&all.0)) / area).clamp(-MOST_SHIFT * side, MOST_SHIFT * side);
            if (next - shift).abs() <= LEAST_SHIFT * side {
                break;
            }
            shift = next;
            all = stuffed(shift);
        }
        all
    }

    /// A lattice around the box, in its middle, with a layer of cells to spare on the low sides and two on the high ones.
    fn lattice(&self, cells: f64) -> Result<Lattice> {
        let bounds = self.field.bounds();
        let side = self.longest() / cells;
        let along = (bounds.size() / side - SLACK).ceil().max(DVec3::ONE);
        let origin = bounds.middle() - (0.5 * along + 1.0) * side;
        let counts = along.to_array().map(|count| count as usize + 3);
        let points = 2 * counts.iter().map(|&count| count as u64).product::<u64>();
        let is_numbered = points < u64::from(u32::MAX);
        memory::require(if is_numbered { BYTES_PER_POINT * points } else { u64::MAX }, "filling")
            .map_err(|_| Error::OutOfMemory { stage: "filling" })?;
        Ok(Lattice::new(origin, side, counts))
    }

    /// How far the boundary is from the surface at most.
    fn deviation(&self, soup: &TetSoup, is_on_surface: &[bool]) -> f64 {
        let faces = boundary(soup, is_on_surface);
        let distances = parallel::collect(faces.len(), self.threads, |face| {
            let corners = faces[face].map(|corner| soup.positions[corner as usize]);
            let middle = corners.iter().sum::<DVec3>() / 3.0;
            corners.into_iter().chain([middle]).map(|point| self.field.to_nearest(point).length()).fold(0.0, f64::max)
        });
        distances.into_iter().fold(0.0, f64::max)
    }
}

fn volume_of(soup: &TetSoup) -> f64 {
    let corners = |tetrahedron: &[u32; 4]| tetrahedron.map(|corner| soup.positions[corner as usize]);
    soup.tetrahedra.iter().map(|tetrahedron| volume(corners(tetrahedron))).sum()
}

/// Volume, and how often lines along the axes cross, as [`Sample::crossings`].
fn measures(triangles: &[Triangle]) -> (f64, f64) {
    let origin = triangles[0][0];
    let volume: f64 = triangles.iter().map(|triangle| area_vector(triangle).dot(triangle[0] - origin)).sum();
    let area: f64 = triangles.iter().map(|triangle| area_vector(triangle).abs().element_sum()).sum();
    (volume / 6.0, 0.5 * area)
}

/// Why a surface has no inside.
fn open(surface: &Surface) -> Error {
    let mesh = surface.mesh();
    let is_open = |&halfedge: &HalfedgeId| surface.edges().is_single(mesh.twin(halfedge));
    let hole = |cap| {
        let mut open = mesh.halfedges_of_face(cap).filter(is_open);
        let first = open.next()?;
        Some((1 + open.count(), mesh.vertex(first)))
    };
    let holes: Vec<_> = mesh.boundary_loops().filter_map(hole).collect();
    match holes.iter().max_by_key(|&&(edges, _)| edges) {
        Some(&(edges, vertex)) => {
            let vertex = surface.inputs_of_vertex(surface.vertex_of_cut(vertex))[0].0;
            Error::Open { holes: holes.len(), edges, vertex }
        }
        None => Error::NotOriented,
    }
}
