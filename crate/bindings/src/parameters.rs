//! The page's words for the options of the solver: those of `Parameters` in the generated contract.

use heatwalk::{AUTOMATIC, Choice, ExactRadius, MemoryLimit, Parameters, TimeStep};
use js_sys::{Array, Object};
use wasm_bindgen::JsValue;

use crate::failure::{Failure, Result};

/// Reads options; those that are absent are as the solver has them.
///
/// # Errors
/// For an option that does not exist, or a value that it does not take.
pub fn parameters(given: &Object) -> Result<Parameters> {
    let mut parameters = Parameters::default();
    for entry in Object::entries(given) {
        let entry = Array::from(&entry);
        let key = entry.get(0).as_string().unwrap_or_default();
        let value = Value { key: &key, value: entry.get(1) };
        match key.as_str() {
            "operator" => parameters.operator = value.choice()?,
            "solver" => parameters.solver = value.choice()?,
            "timeStep" => parameters.time_step = value.automatic_or(TimeStep::Factor)?,
            "boundary" => parameters.boundary = value.choice()?,
            "sources" => parameters.sources = value.choice()?,
            "exactRadius" => parameters.exact_radius = value.automatic_or(ExactRadius::Edges)?,
            "memory" => parameters.memory = value.automatic_or(MemoryLimit::mebibytes)?,
            _ => return Err(Failure::misuse(&format!("there is no option '{key}'"))),
        }
    }
    Ok(parameters)
}

struct Value<'a> {
    key: &'a str,
    value: JsValue,
}

impl Value<'_> {
    fn choice<C: Choice>(&self) -> Result<C> {
        let name = self.value.as_string().ok_or_else(|| self.refused())?;
        Ok(name.parse()?)
    }

    /// A number, or the word for an automatic choice, which is the default of all numbers.
    fn automatic_or<T: Default>(&self, number: impl Fn(f64) -> T) -> Result<T> {
        match self.value.as_f64() {
            Some(amount) => Ok(number(amount)),
            None if self.value.as_string().as_deref() == Some(AUTOMATIC) => Ok(T::default()),
            None => Err(self.refused()),
        }
    }

    fn refused(&self) -> Failure {
        Failure::misuse(&format!("the option {} does not take {:?}", self.key, self.value))
    }
}
