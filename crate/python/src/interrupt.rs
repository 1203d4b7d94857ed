//! Long work: without Python's lock, told to a callback, and ended by Ctrl-C.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use heatwalk::{Progress, Stage};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::errors::{Failure, Result};

/// Between two looks at Python, which may have to wait for its lock: short for a person, long for a processor.
const BETWEEN: Duration = Duration::from_millis(50);

/// What is told of work, and what ends it.
struct Watch {
    callback: Option<Py<PyAny>>,
    looked: Instant,
    /// The last stage that the callback was told.
    told: Option<String>,
    /// What Python has raised meanwhile.
    raised: Option<PyErr>,
}

impl Watch {
    fn tell(&mut self, stage: Stage, done: f64) -> ControlFlow<()> {
        let is_new = self.callback.is_some() && self.told.as_deref().is_none_or(|told| told != stage.to_string());
        if !is_new && self.looked.elapsed() < BETWEEN {
            return ControlFlow::Continue(());
        }
        match Python::attach(|py| self.look(py, stage, done)) {
            Ok(true) => {}
            Ok(false) => return ControlFlow::Break(()),
            Err(error) => {
                self.raised = Some(error);
                return ControlFlow::Break(());
            }
        }
        self.looked = Instant::now();
        ControlFlow::Continue(())
    }

    /// Whether to go on.
    fn look(&mut self, py: Python<'_>, stage: Stage, done: f64) -> PyResult<bool> {
        py.check_signals()?;
        let Some(callback) = &self.callback else { return Ok(true) };
        let stage = self.told.insert(stage.to_string());
        let answer = callback.call1(py, (done, stage.as_str()))?;
        Ok(answer.is_none(py) || answer.is_truthy(py)?)
    }
}

/// Does work without Python's lock. `callback` is told the share that is done and the stage, and ends the work where it returns what is
/// false but not None. A panic is an error.
pub fn run<T: Send>(
    py: Python<'_>,
    callback: Option<Py<PyAny>>,
    work: impl FnOnce(Progress<'_>) -> Result<T> + Send,
) -> PyResult<T> {
    if callback.as_ref().is_some_and(|callback| !callback.bind(py).is_callable()) {
        let sentence = "progress is no function; give one of the fraction that is done and the stage";
        return Err(PyTypeError::new_err(sentence));
    }
    let mut watch = Watch { callback, looked: Instant::now(), told: None, raised: None };
    let outcome = py.detach(|| {
        let mut tell = |stage, done| watch.tell(stage, done);
        catch_unwind(AssertUnwindSafe(|| work(&mut tell)))
    });
    if let Some(error) = watch.raised {
        return Err(error);
    }
    let found = outcome.unwrap_or_else(|panic| Err(Failure::of_panic(&*panic)))?;
    if let (Some(callback), Some(stage)) = (&watch.callback, &watch.told) {
        callback.call1(py, (1.0, stage.as_str()))?;
    }
    Ok(found)
}
