//! Text files with something on each line.

use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context, Result, anyhow, ensure};
use heatwalk_model::io::text;

use crate::labels::named_vertices;

/// The lines of a text file that say something, with their numbers from 1: without blank ones, and without what follows `#`. Of a file of labels the
/// vertices of the label that is named.
pub fn statements(path: &Path) -> Result<Vec<(usize, String)>> {
    if let Some(vertices) = named_vertices(path)? {
        return Ok((1..).zip(vertices.iter().map(usize::to_string)).collect());
    }
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let text = text::decoded(&bytes).with_context(|| path.display().to_string())?;
    let text = String::from_utf8_lossy(text);
    let statements = text::lines(&text).map(|(number, line)| (number, text::statement(line).to_owned()));
    Ok(statements.filter(|(_, statement)| !statement.is_empty()).collect())
}

/// What each line of a file says, one line at least; `what`: how one is called.
pub fn listed<T: FromStr<Err = String>>(path: &Path, what: &str) -> Result<Vec<T>> {
    let listed = statements(path)?.into_iter().map(|(number, statement)| {
        statement.parse().map_err(|problem| anyhow!("{}, line {number}: {problem}", path.display()))
    });
    let listed = listed.collect::<Result<Vec<T>>>()?;
    ensure!(!listed.is_empty(), "{}: there is no {what}; write one a line", path.display());
    Ok(listed)
}

/// Those given on the command line, and then those of files.
pub fn with_listed<T: FromStr<Err = String> + Clone>(given: &[T], files: &[PathBuf], what: &str) -> Result<Vec<T>> {
    let mut all = given.to_vec();
    for file in files {
        all.extend(listed(file, what)?);
    }
    Ok(all)
}
