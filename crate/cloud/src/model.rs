//! Points of files, and the surface that takes their place in a model.

use std::num::NonZeroUsize;
use std::sync::Arc;

use glam::DVec3;
use heatwalk_model::io::{self, Budget, Resources};
use heatwalk_model::{Appearance, Model, Result};
use heatwalk_surface::{Soup, WarningCode};

use crate::text::{self, Points};
use crate::{Cloud, Report};

/// Reads a mesh, or points without faces, of a format of meshes or of lines of text: the model then has no triangles, and all its vertices are
/// points.
///
/// # Errors
/// As [`io::read_mesh_or_points_within`] and [`text::read_points`].
pub fn read_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources<'_>) -> Result<Model> {
    if text::names_points(name) {
        let Points { positions, normals } = text::read_points(name, bytes)?;
        let normals = normals.iter().map(|normal| normal.normalize_or_zero().as_vec3()).collect();
        let appearance = Arc::new(Appearance { normals, ..Appearance::default() });
        return Ok(Model { appearance, ..Soup { positions, ..Soup::default() }.into() });
    }
    io::read_mesh_or_points_within(budget, name, bytes, resources)
}

/// Joins the points of a model without triangles, on so many threads; a mesh stays as it is. `name`: of the part. Tells what was done.
///
/// # Errors
/// As [`Cloud::join`].
pub fn join(name: &str, model: &mut Model, threads: NonZeroUsize) -> crate::Result<Option<Report>> {
    if !model.soup.triangles.is_empty() {
        return Ok(None);
    }
    let points = std::mem::take(&mut model.soup.positions);
    let normals: Vec<DVec3> = model.appearance.normals.iter().map(|normal| normal.as_dvec3()).collect();
    let Cloud { soup, report } = Cloud::join_oriented(name, points, &normals, threads)?;
    let Soup { positions, triangles, parts, .. } = soup;
    model.soup = Soup { positions, triangles, parts, ..std::mem::take(&mut model.soup) };
    // Points were not.
    model.soup.warnings.retain(|warning| warning.code != WarningCode::LinesLeftOut);
    Ok(Some(report))
}
