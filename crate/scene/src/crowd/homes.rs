//! Where walkers arrive, and where they start.

use heatwalk::Element;
use heatwalk::FaceId;
use heatwalk::Place;
use heatwalk::Surface;
use heatwalk::surface::csr::Csr;
use heatwalk::surface::parallel;
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::Rng;

/// A place in the list of weights.
#[derive(Debug, Clone, Copy, bytemuck::Zeroable)]
struct Home(u32);

impl Element for Home {
    fn from_index(index: usize) -> Self {
        Self(index as u32)
    }

    fn index(self) -> usize {
        self.0 as usize
    }
}

/// The sources of a distance in the faces that they lie on, and the area that they can be reached from.
#[derive(Debug, Clone)]
pub(super) struct Homes {
    sources: Vec<Place>,
    /// Barycentric weights of each source in each of its faces.
    weights: Vec<[f64; 3]>,
    /// `#F`, indices into `weights`.
    of_face: Csr<FaceId, Home>,
    /// Per connected component whether it has a source.
    is_reached: Vec<bool>,
    /// `#F`, area of the faces up to and with each; those on components without a source count nothing.
    areas: Vec<f64>,
}

impl Homes {
    pub fn new(surface: &Surface) -> Self {
        Self {
            sources: Vec::new(),
            weights: Vec::new(),
            of_face: Csr::group::<FaceId>(surface.face_count(), &[], parallel::ONE),
            is_reached: Vec::new(),
            areas: Vec::new(),
        }
    }

    /// Takes over the sources of a distance, which must have one at least.
    pub fn follow(&mut self, surface: &Surface, sources: &[Place]) {
        if self.sources == sources {
            return;
        }
        self.sources = sources.to_vec();
        self.weights.clear();
        let mut faces = Vec::new();
        let mut is_reached = vec![false; surface.report().components];
        for &source in sources {
            is_reached[source.component(surface) as usize] = true;
            let source = source.snapped(surface);
            for face in source.faces(surface) {
                faces.push(face);
                self.weights.push(source.weights_in(surface, face));
            }
        }
        self.of_face = Csr::group(surface.face_count(), &faces, parallel::ONE);
        if self.is_reached != is_reached {
            let area = |face: FaceId| {
                let component = surface.component(surface.faces()[face][0]);
                if is_reached[component as usize] { surface.face_area(face) } else { 0.0 }
            };
            let sums = surface.mesh().faces().scan(0.0, |sum, face| {
                *sum += area(face);
                Some(*sum)
            });
            self.areas = sums.collect();
            self.is_reached = is_reached;
        }
    }

    /// Barycentric weights of the sources on a face.
    pub fn in_face(&self, face: FaceId) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.of_face.row(face).iter().map(|home| self.weights[home.index()])
    }

    /// A random point, by area, that a source can be reached from: its face and barycentric weights.
    pub fn random_place(&self, random: &mut SplitMix64) -> (FaceId, [f64; 3]) {
        let total = self.areas.last().copied().unwrap_or(0.0);
        let wanted = share(random) * total;
        // The product may round to the total; the face that completes it has an area, the last face need not have one.
        let face = self.areas.partition_point(|&area| area <= wanted && area < total);
        let [a, b] = [(); 2].map(|()| share(random));
        // The other half of the parallelogram is turned onto the triangle.
        let [a, b] = if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] };
        (FaceId(face as u32), [1.0 - a - b, a, b])
    }
}

/// The next number as a share, 0 to below 1.
fn share(random: &mut SplitMix64) -> f64 {
    // As many bits as a share has: 53.
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}
