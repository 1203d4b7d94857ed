//! Folded and rounded rectangles: distances are straight lines in the plane that they unroll to.

use std::f64::consts::PI;

use glam::DVec3;

use super::rows::{Rows, Seam};
use super::thin::{LEAST_THIN, THINNEST};
use super::{Case, Random};

pub fn case(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let (kind, make): (_, fn(&mut Random) -> Vec<Row>) =
        random.pick(&[("rounded edge", rounded_edge), ("folds", folds), ("thin folds", thin_folds)]);
    let rows_of_sheet = make(&mut random);
    let points = random.pick(&[0, 0, 1, 4]);
    let mut rows = Rows::default();
    // Where each row is in the plane across.
    let mut profile = Vec::new();
    let (mut height, mut direction, mut at) = (0.0, 0.0_f64, DVec3::ZERO);
    for Row { step, turn } in rows_of_sheet {
        height += step;
        at += step * DVec3::new(0.0, direction.cos(), direction.sin());
        direction += turn;
        let inner = random.count(0, points);
        rows.push(&random.cuts(inner), height, Seam::Any, &mut random);
        profile.resize(rows.points.len(), at);
    }
    let positions = rows.points.iter().zip(&profile).map(|(point, &at)| at + DVec3::X * point.x).collect();
    Case::placed(kind, &mut random, (positions, rows.triangles), Some(rows.points))
}

/// A row of points.
struct Row {
    /// From the one before.
    step: f64,
    /// By how much the sheet is folded there.
    turn: f64,
}

/// Two flat sides and an arc of strips between them.
fn rounded_edge(random: &mut Random) -> Vec<Row> {
    let strips = random.count(4, 64);
    let radius = random.log_between(1e-5, 1e-1);
    let turn = random.between(0.3, 3.0) / strips as f64;
    let mut side = || -> Vec<f64> {
        let count = random.count(1, 4);
        let sum = random.between(0.2, 1.0);
        (0..count).map(|_| sum / count as f64).collect()
    };
    let [before, after] = [side(), side()];
    let chord = 2.0 * radius * (0.5 * turn).sin();
    let flat = |step: &f64| Row { step: *step, turn: 0.0 };
    let mut rows = vec![Row { step: 0.0, turn: 0.0 }];
    rows.extend(before.iter().map(flat));
    rows.extend((0..strips).map(|_| Row { step: chord, turn }));
    rows.extend(after.iter().map(flat));
    // The first row of the arc is the last one before it.
    rows[before.len()].turn = turn;
    rows
}

/// A few folds, the sides of each no nearer than 60°.
fn folds(random: &mut Random) -> Vec<Row> {
    let count = random.count(3, 8);
    let row = |_| Row { step: random.between(0.1, 0.6), turn: random.between(-PI, PI) / 1.5 };
    (0..count).map(row).collect()
}

/// Many folds of strips, thin ones among them, that turn by a right angle at most in all.
fn thin_folds(random: &mut Random) -> Vec<Row> {
    let count = random.count(3, 24);
    let thin = random.log_between(THINNEST, LEAST_THIN);
    let most = 0.5 * PI / count as f64;
    let mut row = |_| {
        let step = if random.chance(0.3) { random.between(0.1, 0.5) } else { thin * random.between(0.5, 2.0) };
        Row { step, turn: random.between(-most, most) }
    };
    (0..count).map(&mut row).collect()
}
