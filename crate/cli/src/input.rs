//! Mesh files and what they refer to.

use std::num::NonZeroUsize;
use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::{LengthUnit, UnitRule, Warning};
use heatwalk_cloud::Report as Joining;
use heatwalk_files::read_surface_or_points;
use heatwalk_model::Model;
use heatwalk_shapes as shapes;
use serde_json::json;

use crate::args::Mesh;
use crate::complaint::complain;
use crate::report::{Report, milliseconds, object};

/// In place of a file: a shape by its name.
pub const SHAPE: &str = "shape:";

/// The chosen parts of a file.
pub struct Input {
    /// All of the file, with its animations, as its nodes stand.
    pub file: Model,
    /// The chosen parts in the chosen pose, over all vertices and triangles of the file.
    pub model: Model,
    pub read_ms: f64,
    /// Of all of the file.
    pub unit: LengthUnit,
    /// What was made of points without faces; none of a mesh.
    pub cloud: Option<Joining>,
}

impl Input {
    /// A file, or a shape made in code; all of it where no parts are given. Of the lengths of a shape, nothing is assumed.
    pub fn read(path: &Path, parts: &[usize], unit: UnitRule, threads: NonZeroUsize) -> Result<Self> {
        let start = Instant::now();
        let shape = path.to_str().and_then(|path| path.strip_prefix(SHAPE));
        let mut file = match shape {
            Some(name) => shapes::by_name(name)?,
            None => read_surface_or_points(path)?,
        };
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let cloud = heatwalk_cloud::join(&name, &mut file, threads).with_context(|| path.display().to_string())?;
        let read_ms = milliseconds(start);
        let unit = match (shape, unit) {
            (Some(_), UnitRule::Automatic) => LengthUnit::default(),
            _ => file.soup.length_unit(unit),
        };
        tell(path, &file.soup.warnings);
        if let Some(joining) = cloud {
            complain(&format!("warning: {}, {joining}", path.display()));
        }
        let model = if parts.is_empty() { file.clone() } else { file.chosen(parts)? };
        Ok(Self { file, model, read_ms, unit, cloud })
    }

    /// Its unit, and what was left out of it or made of it.
    pub fn tell(&self, report: &mut Report) {
        report.push_unit(self.unit);
        report.push_warnings(&self.file.soup.warnings);
        if let Some(Joining { points, triangles, boundary_loops, unjoined_points }) = self.cloud {
            let made = [
                ("points", points),
                ("triangles", triangles),
                ("boundary_loops", boundary_loops),
                ("unjoined_points", unjoined_points),
            ];
            report.push("cloud", object(made.map(|(name, count)| (name, json!(count)))));
        }
    }

    /// What the arguments of a command name.
    pub fn of(arguments: &Mesh) -> Result<Self> {
        let input = Self::read(&arguments.mesh, &arguments.parts, arguments.unit, arguments.threads())?;
        let Some(name) = &arguments.animation else { return Ok(input) };
        let motion = &input.file.motion;
        let clip = motion.clip_named(name)?;
        let (seconds, end) = (arguments.time, motion.clips()[clip].duration());
        ensure!(
            seconds <= end,
            "--time {seconds} is after the end of the animation {}, which lasts {end} s",
            motion.clips()[clip].name
        );
        Ok(Self { model: input.model.posed(clip, seconds)?, ..input })
    }
}

/// A line on standard error for each warning.
fn tell(path: &Path, warnings: &[Warning]) {
    for warning in warnings {
        complain(&format!("warning: {}, {warning}", path.display()));
    }
}
