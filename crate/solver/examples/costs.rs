//! Errors on ground of different costs.
#[path = "../tests/common/mod.rs"]
mod common;

use std::ops::ControlFlow;
use std::sync::Arc;

use common::media::{jittered_square, least_cost, two_media};
use glam::DVec2;
use heatwalk::exact::ExactGeometry;
use heatwalk::{ExactSearch, Propagation, PropagationOptions, Surface, VertexId, Windows};

fn main() {
    for (x, name) in [(0.2, "cheap"), (0.8, "dear")] {
        for edges in [50u32, 100, 200] {
            for ratio in [1.001, 2.0, 5.0, 10.0, 100.0] {
                let surface = Arc::new(Surface::build(&jittered_square(edges, 1)).unwrap());
                let costs = two_media(&surface, ratio);
                let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)).weighted(&costs));
                let flat = |v: VertexId| DVec2::new(surface.position(v).x, surface.position(v).y);
                let source = surface
                    .vertices()
                    .min_by(|&a, &b| {
                        (flat(a) - DVec2::new(x, 0.5)).length().total_cmp(&(flat(b) - DVec2::new(x, 0.5)).length())
                    })
                    .unwrap();
                let mut solver = heatwalk::DistanceSolver::new(Arc::clone(&surface)).weighted(costs.clone());
                let start = std::time::Instant::now();
                solver
                    .prepare(&heatwalk::DistanceOptions::by(heatwalk::Method::Heat), &mut |_| ControlFlow::Continue(()))
                    .unwrap();
                let prep = start.elapsed();
                let start = std::time::Instant::now();
                let a = solver
                    .distance(&[source], &heatwalk::DistanceOptions::by(heatwalk::Method::Heat), &mut |_| {
                        ControlFlow::Continue(())
                    })
                    .unwrap();
                let solve = start.elapsed();
                let errs: Vec<f64> = surface
                    .vertices()
                    .filter(|&v| v != source)
                    .map(|v| (a.distance.values[v] / least_cost(flat(source), flat(v), ratio) - 1.0).abs())
                    .collect();
                println!(
                    "{name} {edges} 1:{ratio} heat: mean {:.4} max {:.3} prep {prep:?} solve {solve:?}",
                    100.0 * errs.iter().sum::<f64>() / errs.len() as f64,
                    100.0 * errs.iter().fold(0.0f64, |a, &b| a.max(b))
                );
                for windows in [4u16] {
                    let options = PropagationOptions {
                        windows: Windows::AtMost(windows.try_into().unwrap()),
                        exact: ExactSearch::Automatic,
                    };
                    let start = std::time::Instant::now();
                    let mut p = Propagation::new(Arc::clone(&geometry), &[source], options).unwrap();
                    p.advance(f64::INFINITY, usize::MAX);
                    let time = start.elapsed();
                    let (mut sum, mut max, mut far, mut under, mut count) = (0.0, 0.0f64, 0.0f64, 0.0f64, 0);
                    for v in surface.vertices().filter(|&v| v != source) {
                        let truth = least_cost(flat(source), flat(v), ratio);
                        let error = p.values()[v] / truth - 1.0;
                        sum += error.abs();
                        count += 1;
                        max = max.max(error.abs());
                        under = under.min(error);
                        if (flat(v) - flat(source)).length() > 10.0 / f64::from(edges) {
                            far = far.max(error.abs());
                        }
                    }
                    println!(
                        "{name} {edges} 1:{ratio} K={windows}: mean {:.4} max {:.3} beyond ten {:.3} under {:.4} %  {:.1} ms, {} windows",
                        100.0 * sum / count as f64,
                        100.0 * max,
                        100.0 * far,
                        100.0 * under,
                        time.as_secs_f64() * 1e3,
                        p.windows()
                    );
                }
            }
        }
    }
    let _ = ControlFlow::<()>::Continue(());
}
