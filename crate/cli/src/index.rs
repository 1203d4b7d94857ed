//! `heatwalk index`, and indices that it has made.

use std::fs;
use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::Surface;
use heatwalk_index::DistanceIndex;
use serde_json::json;

use crate::args::Index;
use crate::destination::is_standard;
use crate::input::Input;
use crate::output::Output;
use crate::progress::Ticker;
use crate::report::{Report, milliseconds};
use crate::timing::build;
use crate::volume;

/// Makes an index of a surface.
pub fn index(arguments: &Index) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "an index is of distances on a surface, not inside")?;
    ensure!(!is_standard(&arguments.output), "an index is for other runs; give its file a name");
    let output = Output::index(&arguments.output)?;
    let input = Input::of(&arguments.mesh)?;
    let threads = arguments.mesh.threads();
    let (surface, build_ms) = build(&input, arguments.mesh.weld, threads)?;
    let start = Instant::now();
    let count = surface.vertex_count();
    let mut ticker = Ticker::new("vertices", count, 0);
    let index = DistanceIndex::build(&surface, threads, &mut |_, share| ticker.tell(0, count, share))?;
    ticker.end();
    let index_ms = milliseconds(start);
    let mut bytes = Vec::new();
    index.write(&mut bytes)?;
    output.save(&bytes)?;
    let mut report = Report::default();
    report.push_surface(surface.report());
    input.tell(&mut report);
    report.push("bytes", bytes.len());
    report.push("labels", index.label_count());
    report.push("threads", threads.get());
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "index": index_ms }));
    Ok(report.render(arguments.mesh.json))
}

/// The index of a file, if it is of this surface.
pub fn read(path: &Path, surface: &Surface) -> Result<DistanceIndex> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let index = DistanceIndex::from_bytes(&bytes).with_context(|| path.display().to_string())?;
    index.require(surface).with_context(|| path.display().to_string())?;
    Ok(index)
}
