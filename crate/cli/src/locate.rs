//! Where the places of the command line are on a surface.

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use anyhow::{Context, Result};
use glam::DVec3;
use heatwalk::{InputPlace, NearestPlaces, Soup, Source, Surface, SurfacePoint};
use serde_json::{Value, json};

use crate::complaint::complain;
use crate::place::{Place, SourcePlace};
use crate::report::{Report, object};

/// Of the diagonal of the surface: coordinates that are farther from it are warned of, as they may be in another unit or other axes.
const FAR: f64 = 0.01;

/// Finds places on the surface of an input, and remembers how far coordinates were from it.
pub struct Locator<'a> {
    soup: &'a Soup,
    surface: Arc<Surface>,
    /// Made for the first place by coordinates.
    nearest: OnceCell<NearestPlaces>,
    snapped: RefCell<Vec<Snapped>>,
}

/// Coordinates, and what was taken for them.
struct Snapped {
    given: Place,
    taken: Place,
    /// Between both, in the file's unit.
    distance: f64,
}

impl<'a> Locator<'a> {
    /// `soup`: that the surface is made of.
    pub fn new(soup: &'a Soup, surface: &Arc<Surface>) -> Self {
        Self { soup, surface: Arc::clone(surface), nearest: OnceCell::new(), snapped: RefCell::default() }
    }

    /// The point of the surface; of coordinates the one nearest to them.
    pub fn point(&self, place: &Place) -> Result<SurfacePoint> {
        let Place::Coordinates(position) = *place else {
            return Ok(place.of_surface()?.on(self.soup, &self.surface)?);
        };
        let nearest = self.nearest.get_or_init(|| NearestPlaces::new(&self.surface)).nearest(&self.surface, position);
        let (found, distance) = nearest
            .with_context(|| format!("{place} is too far from the surface to be measured; give coordinates near it"))?;
        let taken = InputPlace::of(found, found.faces(&self.surface)[0], self.soup, &self.surface);
        self.snapped.borrow_mut().push(Snapped { given: *place, taken: taken.into(), distance });
        Ok(self.surface.point(found)?)
    }

    /// The source there.
    pub fn source(&self, source: &SourcePlace) -> Result<Source> {
        Ok(self.surface.source(self.point(&source.place)?, source.initial_distance)?)
    }

    /// Where coordinates were taken, if there were any, and a warning on standard error of the farthest.
    pub fn tell(&self, report: &mut Report) {
        let snapped = self.snapped.borrow();
        let Some(farthest) = snapped.iter().max_by(|a, b| a.distance.total_cmp(&b.distance)) else { return };
        let share = farthest.distance / diagonal(&self.surface);
        if share > FAR {
            let Snapped { given, distance, .. } = farthest;
            complain(&format!(
                "warning: {given} is {distance} away from the surface, {:.1} % of its diagonal; its nearest point is taken",
                100.0 * share
            ));
        }
        report.push("snapped", snapped.iter().map(Snapped::told).collect::<Vec<_>>());
    }
}

impl Snapped {
    fn told(&self) -> Value {
        object([
            ("given", json!(self.given.to_string())),
            ("place", json!(self.taken.to_string())),
            ("distance", json!(self.distance)),
        ])
    }
}

/// Of the box around a surface.
fn diagonal(surface: &Surface) -> f64 {
    let box_of = |(low, high): (DVec3, DVec3), &position| (low.min(position), high.max(position));
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = surface.positions().iter().fold(none, box_of);
    (high - low).length()
}
