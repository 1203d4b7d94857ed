//! The stages of the solver on one sphere of 20,480 triangles, each by itself: building, the stages of precompute, the
//! parts of a solve, and the way home.
//!
//! `cargo bench -p heatwalk`, or `cargo bench -p heatwalk -- factoring` for those whose name has the word.

use std::hint::black_box;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use heatwalk::operator::Operators;
use heatwalk::operator::intrinsic::IntrinsicTriangulation;
use heatwalk::{
    Boundary, ExactRadius, HeatSolver, Operator, Parameters, Place, Stage, Surface, TimeStep, VertexId, descend, go_on,
    straighten,
};
use heatwalk_scene::{Crowd, DrawTransform};
use heatwalk_shapes as shapes;

const LEVEL: u32 = 5;
const STAGES: [Stage; 4] = [Stage::Assembling, Stage::Ordering, Stage::Analysing, Stage::Factoring];
const SOURCE: Place = Place::Vertex(VertexId(4321));
const START: Place = Place::Vertex(VertexId(0));

fn surface() -> Arc<Surface> {
    Arc::new(Surface::build(&shapes::icosphere(LEVEL)).expect("an icosphere is a surface"))
}

fn solver(surface: &Arc<Surface>, exact_radius: ExactRadius) -> HeatSolver {
    let parameters = Parameters { exact_radius, ..Parameters::default() };
    HeatSolver::new(Arc::clone(surface), parameters, &mut go_on).expect("a sphere can be factored")
}

fn building(criterion: &mut Criterion) {
    let soup = shapes::icosphere(LEVEL);
    let surface = surface();
    criterion.bench_function("surface", |bencher| bencher.iter(|| Surface::build(black_box(&soup))));
    criterion.bench_function("Delaunay triangulation", |bencher| {
        bencher.iter(|| IntrinsicTriangulation::delaunay(black_box(&surface)));
    });
    criterion.bench_function("Laplacian, plain", |bencher| {
        bencher.iter(|| Operators::new(black_box(&surface), Operator::Plain));
    });
}

/// The time that one stage of making a solver takes.
fn precompute(criterion: &mut Criterion) {
    let surface = surface();
    for stage in STAGES {
        criterion.bench_function(&stage.to_string().to_lowercase(), |bencher| {
            bencher.iter_custom(|count| (0..count).map(|_| time_of(stage, &surface)).sum());
        });
    }
}

fn time_of(stage: Stage, surface: &Arc<Surface>) -> Duration {
    let mut marks = Vec::new();
    let mut mark = |stage, _| {
        marks.push((stage, Instant::now()));
        ControlFlow::Continue(())
    };
    let solver = HeatSolver::new(Arc::clone(surface), Parameters::default(), &mut mark);
    let end = Instant::now();
    black_box(solver).expect("a sphere can be factored");
    let index = marks.iter().position(|mark| mark.0 == stage).expect("every stage is reported");
    let next = marks.get(index + 1).map_or(end, |mark| mark.1);
    next - marks[index].1
}

/// A solve with an exact region, without it, and the cost of the parameters that factor again.
fn solving(criterion: &mut Criterion) {
    let surface = surface();
    for (name, exact_radius) in [
        ("solve", ExactRadius::Automatic),
        ("solve, heat alone", ExactRadius::Edges(0.0)),
        ("solve, exact radius of 16 edges", ExactRadius::Edges(16.0)),
    ] {
        let solver = solver(&surface, exact_radius);
        criterion.bench_function(name, |bencher| bencher.iter(|| solver.distance(black_box(&[SOURCE]))));
    }
    let hemisphere = shapes::hemisphere(70).select(&[0]).expect("part 0 is the hemisphere");
    let hemisphere = Arc::new(Surface::build(&hemisphere).expect("a hemisphere is a surface"));
    for (name, change) in [
        ("another time", Parameters { time_step: TimeStep::Factor(3.0), ..Parameters::default() }),
        ("another boundary condition", Parameters { boundary: Boundary::Dirichlet, ..Parameters::default() }),
    ] {
        criterion.bench_function(name, |bencher| {
            let fresh = || solver(&hemisphere, ExactRadius::Automatic);
            bencher.iter_batched_ref(
                fresh,
                |solver| solver.set_parameters(change, &mut go_on),
                BatchSize::PerIteration,
            );
        });
    }
}

fn fields_and_paths(criterion: &mut Criterion) {
    let surface = surface();
    let distance = solver(&surface, ExactRadius::Automatic).distance(&[SOURCE]).expect("the source is on the sphere");
    let path = descend(&surface, &distance, START).expect("all of a sphere is reachable");
    criterion.bench_function("gradients", |bencher| bencher.iter(|| black_box(&distance).gradients(&surface)));
    criterion.bench_function("descend", |bencher| bencher.iter(|| descend(&surface, black_box(&distance), START)));
    criterion.bench_function("straighten", |bencher| bencher.iter(|| straighten(&surface, black_box(&path))));
}

/// A step of half an edge for as many walkers as the page has at most, and their poses.
fn crowds(criterion: &mut Criterion) {
    let surface = surface();
    let distance = solver(&surface, ExactRadius::Automatic).distance(&[SOURCE]).expect("the source is on the sphere");
    let mut crowd = Crowd::new(Arc::clone(&surface), 10_000, 0.03, 1).expect("a height");
    crowd.follow(&distance).expect("a source");
    criterion.bench_function("a distance for a crowd", |bencher| bencher.iter(|| crowd.follow(black_box(&distance))));
    criterion.bench_function("a step of a crowd", |bencher| {
        bencher.iter(|| crowd.advance(black_box(0.5 * surface.mean_edge())));
    });
    criterion.bench_function("poses of a crowd", |bencher| {
        bencher.iter(|| black_box(&crowd).poses(&DrawTransform::IDENTITY));
    });
}

criterion_group!(stages, building, precompute, solving, fields_and_paths, crowds);
criterion_main!(stages);
