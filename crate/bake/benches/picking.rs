//! Finding the triangle under the pointer, on a bumpy torus of 1.3 million triangles: building the hierarchy, and a ray
//! from all around.
//!
//! `cargo bench -p heatwalk-bake`

use std::f32::consts::TAU;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{Vec2, Vec3};
use heatwalk_bake::{Hierarchy, Picker, Ray};

/// Squares along either circle, each of two triangles.
const SIDE: u32 = 810;
const RAYS: usize = 4096;

fn torus() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let corners = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    let index = |i: u32, j: u32| (i % SIDE) + SIDE * (j % SIDE);
    let positions = corners.clone().map(|(i, j)| {
        let [around, along] = [i, j].map(|step| TAU * step as f32 / SIDE as f32);
        let bump = 0.3 + 0.02 * (31.0 * around).sin() * (17.0 * along).sin();
        let ring = Vec2::from_angle(around) * (1.0 + bump * along.cos());
        Vec3::new(ring.x, bump * along.sin(), ring.y)
    });
    let triangles = corners.flat_map(|(i, j)| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    (positions.collect(), triangles.collect())
}

/// From a sphere around the torus through its middle and beside it, spread by the golden ratio.
fn rays() -> Vec<Ray> {
    let golden = 0.5 * (5.0_f32.sqrt() - 1.0);
    let direction = |step: usize, turn: f32| {
        let y = 1.0 - 2.0 * (step as f32 + 0.5) / RAYS as f32;
        let ring = Vec2::from_angle(TAU * (step as f32 * turn).fract()) * (1.0 - y * y).sqrt();
        Vec3::new(ring.x, y, ring.y)
    };
    let ray = |step| {
        let origin = 4.0 * direction(step, golden);
        let target = direction((step * 1597) % RAYS, golden * golden);
        Ray { origin, direction: (target - origin).normalize() }
    };
    (0..RAYS).map(ray).collect()
}

fn picking(criterion: &mut Criterion) {
    let (positions, triangles) = torus();
    let mut group = criterion.benchmark_group("picking");
    group.sample_size(10);
    group.bench_function("the hierarchy", |bencher| {
        bencher.iter(|| Hierarchy::new(&positions, &triangles));
    });
    let hierarchy = Hierarchy::new(&positions, &triangles);
    let picker = Picker::new(positions, triangles, hierarchy);
    let rays = rays();
    let hits = rays.iter().filter(|ray| picker.cast(**ray).is_some()).count();
    assert!(hits > RAYS / 4, "most of the rays should meet the torus: {hits}");
    let mut next = rays.iter().cycle();
    group.bench_function("a ray", |bencher| {
        bencher.iter(|| picker.cast(black_box(*next.next().expect("an endless cycle"))));
    });
    group.finish();
}

criterion_group!(benches, picking);
criterion_main!(benches);
