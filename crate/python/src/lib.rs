//! The Python package `heatwalk`.
use pyo3::prelude::*;

#[pymodule]
fn _heatwalk(_module: &Bound<'_, PyModule>) -> PyResult<()> {
    Ok(())
}
