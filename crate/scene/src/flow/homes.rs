//! Where walkers arrive, and where they start.

use heatwalk::Distance;
use heatwalk::Element;
use heatwalk::FaceId;
use heatwalk::Place;
use heatwalk::PortalCrossing;
use heatwalk::Surface;
use heatwalk_base::csr::Csr;
use heatwalk_base::parallel;
use rand::RngExt;
use rand_xoshiro::SplitMix64;

/// A place in the list of arrivals.
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

/// A source, or a portal, in one of the faces that it lies on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arrival {
    /// Barycentric.
    pub weights: [f64; 3],
    /// The distance of a portal, less than any before it; 0 for a source.
    pub distance: f64,
    /// Where a portal leads: a face and the weights there.
    pub leads_to: Option<(FaceId, [f64; 3])>,
}

/// The sources of a distance, and the portals on the way to them, in the faces that they lie on, and the area that they can
/// be reached from.
#[derive(Debug, Clone)]
pub(crate) struct Homes {
    sources: Vec<Place>,
    crossings: Vec<PortalCrossing>,
    arrivals: Vec<Arrival>,
    /// `#F`, indices into `arrivals`.
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
            crossings: Vec::new(),
            arrivals: Vec::new(),
            of_face: Csr::group::<FaceId>(surface.face_count(), &[], parallel::ONE),
            is_reached: Vec::new(),
            areas: Vec::new(),
        }
    }

    /// Takes over the sources of a distance, which must have one at least, and the portals.
    pub fn follow(&mut self, surface: &Surface, Distance { sources, crossings, .. }: &Distance) {
        if self.sources == *sources && self.crossings == *crossings {
            return;
        }
        self.sources.clone_from(sources);
        self.crossings.clone_from(crossings);
        self.arrivals.clear();
        let mut faces = Vec::new();
        let mut is_reached = vec![false; surface.report().components];
        let mut add = |place: Place, distance, leads_to| {
            is_reached[place.component(surface) as usize] = true;
            let place = place.snapped(surface);
            for face in place.faces(surface) {
                faces.push(face);
                self.arrivals.push(Arrival { weights: place.weights_in(surface, face), distance, leads_to });
            }
        };
        sources.iter().for_each(|&source| add(source, 0.0, None));
        for crossing in crossings {
            let face = crossing.to.faces(surface)[0];
            add(crossing.from, crossing.distance, Some((face, crossing.to.weights_in(surface, face))));
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

    /// The sources and portals on a face.
    pub fn in_face(&self, face: FaceId) -> impl Iterator<Item = Arrival> + '_ {
        self.of_face.row(face).iter().map(|home| self.arrivals[home.index()])
    }

    /// A random point, by area, that a source can be reached from: its face and barycentric weights.
    pub fn random_place(&self, random: &mut SplitMix64) -> (FaceId, [f64; 3]) {
        let total = self.areas.last().copied().unwrap_or(0.0);
        let wanted = random.random::<f64>() * total;
        // The product may round to the total; the face that completes it has an area, the last face need not have one.
        let face = self.areas.partition_point(|&area| area <= wanted && area < total);
        let [a, b] = random.random::<[f64; 2]>();
        // The other half of the parallelogram is turned onto the triangle.
        let [a, b] = if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] };
        (FaceId(face as u32), [1.0 - a - b, a, b])
    }
}
