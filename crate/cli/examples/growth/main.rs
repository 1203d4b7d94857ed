//! How time and memory grow with a surface of hostile form: on vertices of n triangles, edges of n triangles,
//! slivers, parts and boundaries that touch; and with polygons of n corners, n sources in one place of a curved surface, n places in faces, and
//! tetrahedra around an edge or a vertex.
//!
//! `cargo run --release -p heatwalk-cli --example growth [-- N] [WORD ...]`
//!
//! Measures every operation on every family at N, 4 N and 16 N triangles, corners, sources or tetrahedra, N being 2,000 if not given; of several words, those rows
//! whose name has each of them. A row is one operation on one family: seconds and megabytes at the largest size, and the exponents
//! with which both grew over the last factor of 4, of three runs the least seconds. Seconds below a hundredth and megabytes below one
//! have none: that is the noise of what does not grow.

mod inside;
mod operations;
mod outlines;
mod places;
mod surfaces;

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Context, Result};
use heatwalk::Soup;
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Operations that take less time are measured several times, and the least counts.
const SHORT: f64 = 0.5;
const RUNS: usize = 3;

/// What is measured.
type Operation = Box<dyn FnOnce() -> Result<()>>;

/// Keeps what an operation gives until it was measured.
fn does<T, E: Into<anyhow::Error>>(operation: impl FnOnce() -> Result<T, E> + 'static) -> Result<Operation> {
    Ok(Box::new(move || operation().map(|made| drop(black_box(made))).map_err(Into::into)))
}

fn main() -> Result<()> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let count = words.first().and_then(|word| word.parse().ok());
    if count.is_some() {
        words.remove(0);
    }
    let sizes = [1, 4, 16].map(|factor| factor * count.unwrap_or(2000));
    println!("{:<42} {:>9} {:>9} {:>8} {:>8}", format!("size: {}", sizes[2]), "s", "MB", "time", "memory");
    let row = |name: String, prepare: &dyn Fn(usize) -> Result<(usize, Operation)>| {
        if words.iter().all(|word| name.contains(word)) {
            let figures = sizes.map(|size| measure(|| prepare(size))).into_iter().collect::<Result<Vec<_>>>();
            print(&name, &figures.with_context(|| name.clone())?);
        }
        anyhow::Ok(())
    };
    for (family, make) in surfaces::FAMILIES {
        for (operation, prepare) in operations::OPERATIONS {
            row(format!("{operation}, {family}"), &|size| on(&make(size), |soup| soup.triangles.len(), prepare))?;
        }
    }
    for (family, make) in outlines::OUTLINES {
        row(format!("read, {family}"), &|size| Ok((size, outlines::read(&make(size))?)))?;
    }
    for family in places::FAMILIES {
        row(format!("exact, {}", family.0), &|size| Ok((size, places::exact(size, family)?)))?;
    }
    for (family, make) in surfaces::FAMILIES.into_iter().filter(|family| places::QUICK.contains(&family.0)) {
        let triangles = |soup: &Soup| soup.triangles.len();
        row(format!("places in faces, {family}"), &|size| on(&make(size), triangles, places::in_faces))?;
    }
    for (family, make) in inside::FAMILIES {
        for (operation, prepare) in inside::OPERATIONS {
            row(format!("{operation}, {family}"), &|size| on(&make(size), |soup| soup.tetrahedra.len(), prepare))?;
        }
    }
    Ok(())
}

/// How many elements a soup has, and an operation on it.
fn on<S>(
    soup: &S,
    count: impl Fn(&S) -> usize,
    prepare: impl Fn(&S) -> Result<Operation>,
) -> Result<(usize, Operation)> {
    Ok((count(soup), prepare(soup)?))
}

/// What one operation took.
struct Figures {
    size: f64,
    seconds: f64,
    megabytes: f64,
}

fn measure(prepare: impl Fn() -> Result<(usize, Operation)>) -> Result<Figures> {
    let mut least = run(&prepare)?;
    for _ in 1..RUNS {
        if least.seconds < SHORT {
            let next = run(&prepare)?;
            least.seconds = least.seconds.min(next.seconds);
        }
    }
    Ok(least)
}

fn run(prepare: impl Fn() -> Result<(usize, Operation)>) -> Result<Figures> {
    let (size, operation) = prepare()?;
    let before = MEMORY.current_usage_as_mb();
    MEMORY.reset_peak_usage();
    let start = Instant::now();
    operation()?;
    let seconds = start.elapsed().as_secs_f64();
    let megabytes = f64::from(MEMORY.peak_usage_as_mb() - before);
    Ok(Figures { size: size as f64, seconds, megabytes })
}

fn print(name: &str, figures: &[Figures]) {
    let [.., before, last] = figures else { return };
    let factor = (last.size / before.size).ln();
    let exponent = |[before, last]: [f64; 2], noise: f64| {
        if last < noise { "-".to_owned() } else { format!("{:.2}", (last / before.max(noise / 4.0)).ln() / factor) }
    };
    println!(
        "{name:<42} {:>9.3} {:>9.1} {:>8} {:>8}",
        last.seconds,
        last.megabytes,
        exponent([before.seconds, last.seconds], 0.01),
        exponent([before.megabytes, last.megabytes], 1.0)
    );
}
