//! The Python package `heatwalk`: converts arrays, calls the solver, turns errors into exceptions. No algorithm lives here.

// A program of tests would have to be linked with Python; pytest runs all that are here.
#![cfg(not(test))]

mod answers;
mod arrays;
mod cloud;
mod curves;
mod directions;
mod distance;
mod errors;
mod index;
mod interrupt;
mod labels;
mod mesh;
mod named;
mod options;
mod paths;
mod read;
mod samples;
mod sources;
mod tets;
mod turn;
mod values;

use pyo3::prelude::*;

#[pymodule]
fn _heatwalk(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<mesh::Mesh>()?;
    module.add_class::<cloud::PointCloud>()?;
    module.add_class::<index::Index>()?;
    module.add_class::<tets::TetMesh>()?;
    module.add_function(wrap_pyfunction!(labels::read_labels, module)?)?;
    module.add_function(wrap_pyfunction!(read::read, module)?)?;
    module.add_function(wrap_pyfunction!(read::shape, module)?)
}
