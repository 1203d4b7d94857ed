//! Distances of each method and their paths, on small surfaces of any kind.
#![no_main]

use std::num::NonZeroUsize;
use std::sync::Arc;

use arbitrary::Arbitrary;
use heatwalk::{DistanceOptions, DistanceSolver, Error, Method, PathKind, Place, Surface, go_on};
use heatwalk_fuzz::distances::{ROUNDING, check_edges, check_path, check_reached};
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_fuzz::soups::{AnyPlace, AnySoup};

const TWO: NonZeroUsize = NonZeroUsize::new(2).expect("two is not zero");

#[derive(Arbitrary, Debug)]
struct Question {
    soup: AnySoup,
    sources: [AnyPlace; 2],
    from: AnyPlace,
}

libfuzzer_sys::fuzz_target!(|question: Question| {
    let surface = match Surface::build(&question.soup.0) {
        Ok(surface) => Arc::new(surface),
        Err(error) => return check_sentence(&error.to_string()),
    };
    let sources: Vec<Place> = question.sources.iter().map(|place| place.on(&surface)).collect();
    let from = question.from.on(&surface);
    let mut exact = None;
    for method in [Method::Exact, Method::Propagation, Method::Heat] {
        let options = DistanceOptions::by(method);
        let mut solver = DistanceSolver::new(Arc::clone(&surface));
        let answer = match solver.distance(&sources, &options, &mut go_on) {
            Ok(answer) => answer,
            Err(error) => {
                check_sentence(&error.to_string());
                continue;
            }
        };
        let values: Vec<f64> = answer.distance.values.iter().copied().collect();
        check_reached(&surface, &sources, values.iter().copied());
        let again = DistanceSolver::on_threads(Arc::clone(&surface), TWO).distance(&sources, &options, &mut go_on);
        let again = again.expect("what one thread has answered").distance.values;
        assert!(again.iter().map(|value| value.to_bits()).eq(values.iter().map(|value| value.to_bits())));
        if method != Method::Heat {
            check_edges(&surface, &values);
        }
        let exact = exact.get_or_insert_with(|| values.clone());
        let largest = exact.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        if method == Method::Propagation {
            let is_no_less = exact.iter().zip(&values).all(|(exact, value)| *value >= exact - ROUNDING * largest);
            assert!(is_no_less, "{values:?} for {exact:?}");
        }
        for kind in [PathKind::Descent, PathKind::Straightened, PathKind::Exact] {
            match solver.path(&answer, from, kind) {
                Ok(path) => check_path(&surface, &path, &sources),
                Err(error) => assert!(matches!(error, Error::Unreachable), "{kind:?} by {method:?}: {error}"),
            }
        }
        let at = solver.at(&answer, from).expect("a place of the surface");
        assert!(at >= 0.0, "{at} at a place");
    }
});
