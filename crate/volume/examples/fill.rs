//! Fills the shapes that are made in code, and files, with about so many tetrahedra each:
//! `cargo run --release -p heatwalk-volume --example fill -- 100000 [FILE ...]`. Prints a table of what came of it. Volumes are relative
//! to what the surface encloses, or, in brackets, where its triangles do not tell, to a filling with 16 times as many tetrahedra.

use std::error::Error;
use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;
use std::time::Instant;

use heatwalk::{Soup, Surface, go_on};
use heatwalk_model::io;
use heatwalk_volume::fill::{Resolution, Solid};

/// How many times as many tetrahedra tell the volume where triangles do not.
const FINER: usize = 16;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().map_or(Ok(100_000), |count| count.parse())?;
    let files: Vec<String> = arguments.collect();
    println!(
        "| surface | triangles | cells | tetrahedra | estimated | vertices | estimated | volume | dihedral angles | deviation, cells | ms |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---|---:|---:|");
    if files.is_empty() {
        for &name in heatwalk_shapes::names() {
            row(name, &heatwalk_shapes::by_name(name)?.soup, count)?;
        }
    }
    for file in files {
        let name = Path::new(&file).file_name().unwrap_or_default().to_string_lossy();
        row(&name, &io::read(&name, &fs::read(&file)?, &|_| None)?.soup, count)?;
    }
    Ok(())
}

fn row(name: &str, soup: &Soup, count: usize) -> Result<(), Box<dyn Error>> {
    let surface = Surface::build(soup)?;
    let resolution = Resolution::Tetrahedra(count);
    let start = Instant::now();
    let solid = match Solid::new(soup, &surface, NonZeroUsize::MIN) {
        Ok(solid) => solid,
        Err(error) => {
            println!("| {name} | {} | {error} |", soup.triangles.len());
            return Ok(());
        }
    };
    let estimate = solid.estimate(resolution)?;
    let fill = |resolution| solid.fill(resolution, &mut go_on);
    let report = fill(resolution)?.report;
    let milliseconds = start.elapsed().as_millis();
    let lost = |volume: f64| format!("{:+.2} %", 100.0 * (report.volume / volume - 1.0));
    let volume = match report.surface_volume {
        Some(volume) => lost(volume),
        None => format!("({})", lost(fill(Resolution::Tetrahedra(FINER * count))?.report.volume)),
    };
    let [least, greatest] = report.dihedral_angles;
    println!(
        "| {name} | {} | {:.1} | {} | {} | {} | {} | {volume} | {least:.1}° to {greatest:.1}° | {:.2} | {milliseconds} |",
        soup.triangles.len(),
        report.cells,
        report.tetrahedra,
        estimate.tetrahedra,
        report.vertices,
        estimate.vertices,
        report.deviation / report.cell_side
    );
    Ok(())
}
