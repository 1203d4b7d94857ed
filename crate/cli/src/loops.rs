//! `heatwalk loop`.

use std::path::Path as File;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{Path, closed_geodesic, geodesic_loop, go_on, handle_loops};
use serde_json::{Value, json};

use crate::args::Loop;
use crate::complaint::complain;
use crate::input::Input;
use crate::locate::Locator;
use crate::output::Output;
use crate::question::joined;
use crate::report::{milliseconds, object};
use crate::volume;

/// Closed curves through places or around handles.
pub fn loops(arguments: &Loop) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "a loop is on a surface, not inside")?;
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    arguments.through.iter().try_for_each(|place| place.check(soup))?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(soup, solver.surface());
    let places = arguments.through.iter().map(|place| locator.point(place)).collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let start = Instant::now();
    let loops = if arguments.handles {
        handle_loops(solver.surface(), &mut go_on)?
    } else {
        let held = geodesic_loop(solver.exact_geometry(), &places, &mut go_on)?;
        vec![if arguments.free { closed_geodesic(solver.surface(), &held)? } else { held }]
    };
    let loops_ms = milliseconds(start);
    if let Some(output) = output {
        let lines: Vec<_> = loops.iter().map(Path::positions).collect();
        output.write_several(&lines, "loop", arguments.axis.up)?;
    }
    if arguments.handles {
        if loops.is_empty() {
            warn_of_no_handle(&arguments.mesh.mesh);
        }
        let of_loop = |path: &Path| object([("length", json!(path.length())), ("points", points(path))]);
        report.push("loops", loops.iter().map(of_loop).collect::<Vec<_>>());
    } else {
        for path in &loops {
            report.push("length", path.length());
            report.push("points", points(path));
        }
    }
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "loop": loops_ms }));
    Ok(report.render(arguments.mesh.json))
}

fn points(path: &Path) -> Value {
    path.positions().iter().map(|point| json!(point.to_array())).collect()
}

fn warn_of_no_handle(mesh: &File) {
    complain(&format!("warning: {}, the surface has no handle, so there are no loops around any", mesh.display()));
}
