//! Polygons of many corners, read as the one face of a file.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use anyhow::Result;

use crate::{Operation, does};

/// A polygon by its name, of so many corners in the plane.
pub type Outline = (&'static str, fn(usize) -> Vec<[f64; 2]>);

pub const OUTLINES: [Outline; 6] = [
    ("circle", |count| (0..count).map(|index| at(1.0, index as f64 / count as f64)).collect()),
    ("spikes", |count| {
        (0..count).map(|index| at(1.0 + 100.0 * (index % 2) as f64, index as f64 / count as f64)).collect()
    }),
    ("comb", |count| {
        let teeth = (0..count - 2).map(|index| [index as f64, (index % 2) as f64 * count as f64]);
        teeth.chain([[count as f64, -1.0], [-1.0, -1.0]]).collect()
    }),
    ("spiral outline", |count| {
        let half = count / 2;
        let turns = 20.0;
        let side = |inset: f64| {
            move |index: usize| at(1.0 + turns * index as f64 / half as f64 - inset, turns * index as f64 / half as f64)
        };
        (0..half).map(side(0.0)).chain((0..half).rev().map(side(0.5))).collect()
    }),
    ("zigzag", |count| {
        let half = count / 2;
        let side = |shift: f64| move |index: usize| [index as f64, shift + 50.0 * (index % 2) as f64];
        (0..half).map(side(0.0)).chain((0..half).rev().map(side(1.0))).collect()
    }),
    ("crossed star", |count| {
        let count = count | 1;
        (0..count).map(|index| at(1.0, (index * (count / 2)) as f64 / count as f64)).collect()
    }),
];

fn at(radius: f64, turns: f64) -> [f64; 2] {
    let (y, x) = (TAU * turns).sin_cos();
    [radius * x, radius * y]
}

/// Reads a polygon.
pub fn read(corners: &[[f64; 2]]) -> Result<Operation> {
    let mut text = format!("OFF\n{} 1 0\n", corners.len());
    for [x, y] in corners {
        writeln!(text, "{x} {y} 0")?;
    }
    write!(text, "{}", corners.len())?;
    (0..corners.len()).try_for_each(|corner| write!(text, " {corner}"))?;
    does(move || heatwalk_model::io::read("a.off", text.as_bytes(), &|_| None))
}
