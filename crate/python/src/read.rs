//! Meshes of files and shapes.

use std::path::PathBuf;

use heatwalk_model::Model;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::cloud::PointCloud;
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::{Mesh, Options, all_threads};

/// Read a mesh file, or the bytes of one.
///
/// Formats: glTF and GLB, OBJ, OFF, PLY, STL, 3MF, VTK, GIFTI (`.surf.gii`) and surfaces of FreeSurfer, packed by gzip or in a zip too; of tetrahedra (Gmsh, Medit, VTK, TetGen)
/// the boundary; points without faces (PLY, OBJ, `.xyz`, `.csv` and others) are joined to a `PointCloud`. Of bytes, `name` tells the format by its extension where the first bytes do not; they cannot refer to other files.
///
/// `parts` chooses parts of the file, counted from 0; vertices and faces keep their numbers. For `weld`, `bridges`, `links` and `threads` see
/// `Mesh`. What was left out of the file is in `Mesh.warnings`.
///
/// Raises OSError where the file cannot be read, HeatwalkError where it holds no mesh.
#[pyfunction]
#[pyo3(signature = (source, *, name=None, parts=None, weld=None, bridges=None, links=0, threads=None))]
#[allow(clippy::too_many_arguments, reason = "keywords of Python")]
pub fn read(
    py: Python<'_>,
    source: &Bound<'_, PyAny>,
    name: Option<&str>,
    parts: Option<Vec<usize>>,
    weld: Option<&Bound<'_, PyAny>>,
    bridges: Option<&Bound<'_, PyAny>>,
    links: usize,
    threads: Option<usize>,
) -> PyResult<Py<Mesh>> {
    let options = Options::new(weld, bridges, links, threads)?;
    let bytes = source.cast::<PyBytes>().ok().map(|bytes| bytes.as_bytes().to_vec());
    let path = match bytes {
        Some(_) => PathBuf::from(name.unwrap_or("mesh")),
        None => source.extract::<PathBuf>().map_err(|_| {
            PyTypeError::new_err("the source is neither a path nor bytes; of a file that is open, give its read()")
        })?,
    };
    let (mesh, joined) = run(py, None, move |_| {
        let mut model = match bytes {
            Some(bytes) => heatwalk_files::surface_or_points_of_bytes(&path.to_string_lossy(), &bytes)?,
            None => heatwalk_files::read_surface_or_points(&path)?,
        };
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let joined = PointCloud::of_model(&name, &mut model, options.threads.unwrap_or_else(all_threads))?;
        Ok((of_model(model, parts.as_deref(), options)?, joined))
    })?;
    match joined {
        Some(joined) => Ok(Bound::new(py, joined.over(mesh))?.into_super().unbind()),
        None => Py::new(py, mesh),
    }
}

/// A shape that is made in code, 5,000 to 50,000 triangles, to try things on: "animal", "torus", "icosphere", ...; an unknown name is answered by the
/// names that there are.
#[pyfunction]
#[pyo3(signature = (name))]
pub fn shape(py: Python<'_>, name: String) -> PyResult<Mesh> {
    run(py, None, move |_| {
        let model = heatwalk_shapes::by_name(&name).map_err(Failure::from)?;
        of_model(model, None, Options::default())
    })
}

fn of_model(model: Model, parts: Option<&[usize]>, options: Options) -> Result<Mesh> {
    let model = match parts {
        Some(parts) => model.chosen(parts)?,
        None => model,
    };
    Mesh::build(model.soup, options)
}
