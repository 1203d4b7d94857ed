//! What opening a file takes, as a Markdown table: reading (with decompression), building the surface, and looking for the
//! contacts of its components, on one thread; the least of some runs.
//!
//! `cargo run --release -p heatwalk-model --example opening -- FILE...`

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;

use heatwalk_model::io;
use heatwalk_surface::{BridgeRule, Bridges, Surface};

/// Runs of which the least time counts.
const RUNS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| file | kB | triangles | read, ms | million triangles a second | build, ms | contacts | portals | contacts, ms |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|");
    for file in std::env::args().skip(1) {
        let path = Path::new(&file);
        let bytes = fs::read(path).map_err(|error| format!("{file}: {error}"))?;
        let name = path.file_name().ok_or("this is a folder")?.to_string_lossy();
        let beside = |uri: &str| fs::read(path.with_file_name(uri)).ok();
        let (soup, read) = timed(|| Ok(io::read(&name, &bytes, &beside)?.soup))?;
        let (surface, build) = timed(|| Ok(Surface::build(&soup)?))?;
        let (bridges, search) = timed(|| Ok(Bridges::find(&surface, BridgeRule::Automatic)))?;
        let triangles = soup.triangles.len();
        let rate = triangles as f64 / read / 1e3;
        let (contacts, portals) = (bridges.contacts().len(), bridges.portals().len());
        let kilobytes = bytes.len() / 1000;
        println!(
            "| {name} | {kilobytes} | {triangles} | {read:.2} | {rate:.1} | {build:.2} | {contacts} | {portals} | {search:.1} |"
        );
    }
    Ok(())
}

/// What is made, and the least time of some runs in milliseconds.
fn timed<T>(make: impl Fn() -> heatwalk_model::Result<T>) -> heatwalk_model::Result<(T, f64)> {
    let run = || -> heatwalk_model::Result<_> {
        let start = Instant::now();
        let made = make()?;
        Ok((made, 1e3 * start.elapsed().as_secs_f64()))
    };
    let (made, mut least) = run()?;
    for _ in 1..RUNS {
        least = least.min(run()?.1);
    }
    Ok((made, least))
}
