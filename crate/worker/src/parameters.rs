//! The page's words for the solver's parameters.

use heatwalk::{Boundary, LinearSolver, MemoryLimit, MultiSource, NearField, Operator, Parameters, TimeStep};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

/// Reads `{ operator, solver, timeFactor, boundary, multi, nearField, memory }`; what is absent is as the solver has it.
pub fn parameters(given: &JsValue) -> Result<Parameters, JsError> {
    let given = Given(given);
    let default = Parameters::default();
    Ok(Parameters {
        operator: given.choice("operator", default.operator, |word| match word {
            "delaunay" => Some(Operator::Delaunay),
            "plain" => Some(Operator::Plain),
            "relocate" => Some(Operator::Relocate),
            _ => None,
        })?,
        solver: given.choice("solver", default.solver, |word| match word {
            "cholesky" => Some(LinearSolver::Cholesky),
            "cg" => Some(LinearSolver::ConjugateGradients),
            _ => None,
        })?,
        time_step: given.dial("timeFactor", TimeStep::Automatic, TimeStep::Factor)?,
        boundary: given.choice("boundary", default.boundary, |word| match word {
            "neumann" => Some(Boundary::Neumann),
            "dirichlet" => Some(Boundary::Dirichlet),
            "average" => Some(Boundary::Average),
            _ => None,
        })?,
        sources: given.choice("multi", default.sources, |word| match word {
            "exact" => Some(MultiSource::Exact),
            "superposed" => Some(MultiSource::Superposed),
            _ => None,
        })?,
        near_field: given.dial("nearField", NearField::Automatic, NearField::Edges)?,
        memory: given.dial("memory", MemoryLimit::Automatic, |mebibytes| {
            MemoryLimit::Bytes((mebibytes * f64::from(1 << 20)) as u64)
        })?,
    })
}

struct Given<'a>(&'a JsValue);

impl Given<'_> {
    fn value(&self, key: &str) -> JsValue {
        Reflect::get(self.0, &key.into()).unwrap_or(JsValue::UNDEFINED)
    }

    fn choice<T>(&self, key: &str, absent: T, read: impl Fn(&str) -> Option<T>) -> Result<T, JsError> {
        let value = self.value(key);
        if value.is_undefined() {
            return Ok(absent);
        }
        value.as_string().and_then(|word| read(&word)).ok_or_else(|| unknown(key, &value))
    }

    /// A number, or the word "auto".
    fn dial<T>(&self, key: &str, automatic: T, number: impl Fn(f64) -> T) -> Result<T, JsError> {
        let value = self.value(key);
        match value.as_f64() {
            Some(amount) => Ok(number(amount)),
            None if value.is_undefined() || value.as_string().as_deref() == Some("auto") => Ok(automatic),
            None => Err(unknown(key, &value)),
        }
    }
}

fn unknown(key: &str, value: &JsValue) -> JsError {
    let value = value.as_string().unwrap_or_else(|| format!("{value:?}"));
    JsError::new(&format!("the parameter {key} has no choice '{value}'"))
}
