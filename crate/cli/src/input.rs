//! Mesh files and what they refer to.

use std::fs;
use std::path::{Component, Path};
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{LengthUnit, Soup, UnitRule, Warning, io};
use heatwalk_shapes as shapes;
use heatwalk_volume::io::{self as volume, Format};

use crate::args::Mesh;
use crate::complaint::complain;
use crate::report::milliseconds;

/// In place of a file: a shape by its name.
pub const SHAPE: &str = "shape:";

/// The chosen parts of a file.
pub struct Input {
    /// All of the file, with its animations, as its nodes stand.
    pub file: Soup,
    /// The chosen parts in the chosen pose, over all vertices and triangles of the file.
    pub soup: Soup,
    pub read_ms: f64,
    /// Of all of the file.
    pub unit: LengthUnit,
}

impl Input {
    /// A file, or a shape made in code; all of it where no parts are given. Of the lengths of a shape, nothing is assumed.
    pub fn read(path: &Path, parts: &[usize], unit: UnitRule) -> Result<Self> {
        let start = Instant::now();
        let shape = path.to_str().and_then(|path| path.strip_prefix(SHAPE));
        let file = match shape {
            Some(name) => shapes::by_name(name)?,
            None => read_mesh(path)?,
        };
        let read_ms = milliseconds(start);
        let unit = match (shape, unit) {
            (Some(_), UnitRule::Automatic) => LengthUnit::default(),
            _ => file.length_unit(unit),
        };
        tell(path, &file.warnings);
        let soup = if parts.is_empty() { file.clone() } else { file.chosen(parts)? };
        Ok(Self { file, soup, read_ms, unit })
    }

    /// What the arguments of a command name.
    pub fn of(arguments: &Mesh) -> Result<Self> {
        let input = Self::read(&arguments.mesh, &arguments.parts, arguments.unit)?;
        let Some(name) = &arguments.animation else { return Ok(input) };
        let motion = &input.file.motion;
        let clip = motion.clip_named(name)?;
        let (seconds, end) = (arguments.time, motion.clips()[clip].duration());
        ensure!(
            seconds <= end,
            "--time {seconds} is after the end of the animation {}, which lasts {end} s",
            motion.clips()[clip].name
        );
        Ok(Self { soup: input.soup.posed(clip, seconds)?, ..input })
    }
}

fn read_mesh(path: &Path) -> Result<Soup> {
    let bytes = read_file(path).with_context(|| format!("cannot read {}", path.display()))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let companion = |uri: &str| beside(Path::new(uri)).then(|| read_file(&folder.join(uri)).ok()).flatten();
    if Format::of_name(&name).is_some() {
        return volume::read_surface(&name, &bytes, &companion).with_context(|| path.display().to_string());
    }
    match io::read(&name, &bytes, &companion) {
        // It names the file itself.
        Err(error @ SurfaceError::UnknownFormat { .. }) => Err(error.into()),
        read => read.with_context(|| path.display().to_string()),
    }
}

/// A line on standard error for each warning.
fn tell(path: &Path, warnings: &[Warning]) {
    for warning in warnings {
        complain(&format!("warning: {}, {warning}", path.display()));
    }
}

/// Devices and pipes may never end, so only plain files are read.
pub fn read_file(path: &Path) -> Result<Vec<u8>> {
    ensure!(fs::metadata(path)?.is_file(), "it is not a file");
    Ok(fs::read(path)?)
}

/// A mesh may bring in files beside or below it, never from elsewhere on the disk.
pub fn beside(uri: &Path) -> bool {
    uri.components().all(|component| matches!(component, Component::Normal(_) | Component::CurDir))
}
