//! The named tuples of `heatwalk._answers`, which questions are answered with.

use pyo3::call::PyCallArgs;
use pyo3::prelude::*;

/// A named tuple of these fields.
pub fn named<'py, A>(py: Python<'py>, name: &str, fields: A) -> PyResult<Bound<'py, PyAny>>
where
    A: PyCallArgs<'py>,
{
    py.import("heatwalk._answers")?.getattr(name)?.call1(fields)
}
