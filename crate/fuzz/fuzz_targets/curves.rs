//! Distances from curves, and isolines and strips of distances, on small surfaces of any kind.
#![no_main]

use std::sync::Arc;

use arbitrary::Arbitrary;
use heatwalk::{Curve, DistanceSolver, Error, Place, Sign, Surface, curve_distance, go_on, signed_curve_distance};
use heatwalk_curves::{Field, Isolines, Levels, Strips};
use heatwalk_fuzz::distances::{check_edges, check_reached};
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_fuzz::soups::{AnyPlace, AnySoup};

#[derive(Arbitrary, Debug)]
struct Question {
    soup: AnySoup,
    places: Vec<AnyPlace>,
    is_closed: bool,
    levels: u8,
}

libfuzzer_sys::fuzz_target!(|question: Question| {
    let Ok(surface) = Surface::build(&question.soup.0) else { return };
    let mut solver = DistanceSolver::new(surface);
    let geometry = Arc::clone(solver.exact_geometry());
    let surface = geometry.surface();
    let places: Vec<Place> = question.places.iter().take(5).map(|place| place.on(surface)).collect();
    let curve = match Curve::through(&geometry, &places, question.is_closed, &mut go_on) {
        Ok(curve) => curve,
        Err(error) => return check_sentence(&error.to_string()),
    };
    let curves = [curve];
    let values = curve_distance(&geometry, &curves, &mut go_on).expect("distance from a curve");
    let values: Vec<f64> = values.iter().copied().collect();
    check_reached(surface, &places, values.iter().copied());
    check_edges(surface, &values);
    match signed_curve_distance(&geometry, &curves, Sign::Nearest, &mut go_on) {
        Ok(signed) => {
            let values = values.iter().zip(signed.values.iter());
            values.for_each(|(value, signed)| assert!(signed.abs() == *value, "{signed} for {value}"));
        }
        Err(error) => assert!(!matches!(error, Error::NoSource), "{error}"),
    }
    let positions: Vec<_> = surface.positions().iter().copied().collect();
    let triangles = surface.faces().iter().map(|corners| corners.map(|vertex| vertex.0)).collect();
    let field = Field::new(positions, triangles, values).expect("a distance of each vertex");
    let Ok(levels) = Levels::counted(usize::from(question.levels), field.largest()) else { return };
    let isolines = Isolines::trace(&field, &levels);
    for isoline in &isolines.isolines {
        assert!(isoline.length >= 0.0 && isoline.length.is_finite() && isoline.enclosed_area >= 0.0, "{isoline:?}");
    }
    let strips = Strips::cut(&field, &levels).expect("few vertices");
    assert!(strips.positions.iter().all(|position| position.is_finite()));
});
