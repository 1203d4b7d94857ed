//! The page's words for the solver's parameters.

use heatwalk::{AUTOMATIC, Choice, ExactRadius, MemoryLimit, Parameters, TimeStep};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

/// Reads `{ operator, solver, timeFactor, boundary, multi, nearField, memory }`; what is absent is as the solver has it.
pub fn parameters(given: &JsValue) -> Result<Parameters, JsError> {
    let given = Given(given);
    let default = Parameters::default();
    Ok(Parameters {
        operator: given.choice("operator", default.operator)?,
        solver: given.choice("solver", default.solver)?,
        time_step: given.number("timeFactor", TimeStep::Automatic, TimeStep::Factor)?,
        boundary: given.choice("boundary", default.boundary)?,
        sources: given.choice("multi", default.sources)?,
        exact_radius: given.number("nearField", ExactRadius::Automatic, ExactRadius::Edges)?,
        memory: given.number("memory", MemoryLimit::Automatic, MemoryLimit::mebibytes)?,
    })
}

struct Given<'a>(&'a JsValue);

impl Given<'_> {
    fn value(&self, key: &str) -> JsValue {
        Reflect::get(self.0, &key.into()).unwrap_or(JsValue::UNDEFINED)
    }

    fn choice<C: Choice>(&self, key: &str, absent: C) -> Result<C, JsError> {
        let value = self.value(key);
        if value.is_undefined() {
            return Ok(absent);
        }
        let name = value.as_string().ok_or_else(|| unknown(key, &value))?;
        Ok(name.parse::<C>()?)
    }

    /// A number, or the word "auto".
    fn number<T>(&self, key: &str, automatic: T, number: impl Fn(f64) -> T) -> Result<T, JsError> {
        let value = self.value(key);
        match value.as_f64() {
            Some(amount) => Ok(number(amount)),
            None if value.is_undefined() || value.as_string().as_deref() == Some(AUTOMATIC) => Ok(automatic),
            None => Err(unknown(key, &value)),
        }
    }
}

fn unknown(key: &str, value: &JsValue) -> JsError {
    let value = value.as_string().unwrap_or_else(|| format!("{value:?}"));
    JsError::new(&format!("the parameter {key} has no choice '{value}'"))
}
