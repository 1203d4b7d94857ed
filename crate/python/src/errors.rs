//! Failures of the crates as Python sees them: a `HeatwalkError` with a sentence and a code, or what Python itself raises.

use std::any::Any;
use std::io::ErrorKind;

use pyo3::exceptions::{PyFileNotFoundError, PyOSError, PyPermissionError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

/// What went wrong, told without Python.
pub enum Failure {
    /// A sentence, and the kind of failure in kebab case.
    Coded { sentence: String, code: String },
    /// An exception.
    Raised(PyErr),
}

/// What work without Python gives.
pub type Result<T> = std::result::Result<T, Failure>;

impl Failure {
    /// Of this kind.
    pub fn new(code: &str, sentence: impl Into<String>) -> Self {
        Self::Coded { sentence: sentence.into(), code: code.to_owned() }
    }

    /// A broken invariant of the crates.
    pub fn of_panic(panic: &(dyn Any + Send)) -> Self {
        let message = panic.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message");
        Self::new("panic", format!("Heatwalk has an error of its own, please report it: {message}"))
    }
}

impl From<PyErr> for Failure {
    fn from(error: PyErr) -> Self {
        Self::Raised(error)
    }
}

macro_rules! coded {
    ($($error:ty),*) => {
        $(impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::new(error.code(), error.to_string())
            }
        })*
    };
}

coded!(
    heatwalk::Error,
    heatwalk::surface::Error,
    heatwalk_cloud::Error,
    heatwalk_files::TetPlaceError,
    heatwalk_index::Error,
    heatwalk_model::Error,
    heatwalk_volume::Error
);

impl From<heatwalk::UnknownChoice> for Failure {
    fn from(unknown: heatwalk::UnknownChoice) -> Self {
        heatwalk::Error::from(unknown).into()
    }
}

impl From<heatwalk_curves::Error> for Failure {
    fn from(error: heatwalk_curves::Error) -> Self {
        Self::new("bad-isolines", error.to_string())
    }
}

/// Of a file.
impl From<anyhow::Error> for Failure {
    fn from(error: anyhow::Error) -> Self {
        let sentence = format!("{error:#}");
        match error.chain().find_map(|cause| cause.downcast_ref::<std::io::Error>()) {
            Some(cause) => Self::Raised(match cause.kind() {
                ErrorKind::NotFound => PyFileNotFoundError::new_err(sentence),
                ErrorKind::PermissionDenied => PyPermissionError::new_err(sentence),
                _ => PyOSError::new_err(sentence),
            }),
            None => Self::new(heatwalk_files::code(&error).unwrap_or("unreadable"), sentence),
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Raised(error) => error,
            Failure::Coded { sentence, code } => {
                Python::attach(|py| exception(py, &sentence, &code).unwrap_or_else(|error| error))
            }
        }
    }
}

fn exception(py: Python<'_>, sentence: &str, code: &str) -> PyResult<PyErr> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let class = CLASS.import(py, "heatwalk._errors", "HeatwalkError")?;
    Ok(PyErr::from_value(class.call1((sentence, code))?))
}
