//! Options by keyword, in the crates' names.

use std::str::FromStr;

use heatwalk::{Choice, DistanceOptions, Method, Parameters};
use heatwalk_volume::{VolumeMethod, VolumeOptions};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Failure, Result};

/// Options of the heat method alone.
const HEAT: [&str; 6] = ["operator", "solver", "time_step", "boundary", "multi_source", "exact_radius"];
/// Those of searches.
const SEARCH: [&str; 2] = ["windows", "max_distance"];

/// What is asked of the solver. An option that the method does not heed is refused.
pub fn distance_options(method: &str, given: Option<&Bound<'_, PyDict>>) -> Result<DistanceOptions> {
    let mut options = DistanceOptions::by(method.parse::<Method>()?);
    let method = options.method;
    for (name, value) in given.into_iter().flatten() {
        let name = name.to_string();
        let is_heeded = match name.as_str() {
            "windows" => matches!(method, Method::Auto | Method::Propagation),
            _ => HEAT.contains(&name.as_str()) == (method == Method::Heat),
        };
        require_known(&name, &[&SEARCH[..], &HEAT[..]].concat())?;
        require_heeded(&name, method.name(), is_heeded)?;
        match name.as_str() {
            "windows" => options.windows = from(&name, &value)?,
            "max_distance" => options.max_distance = number(&name, &value)?,
            _ => set_heat(&mut options.heat, &name, &value)?,
        }
    }
    Ok(options)
}

/// The same inside of tetrahedra.
pub fn volume_options(method: &str, given: Option<&Bound<'_, PyDict>>) -> Result<VolumeOptions> {
    let mut options = VolumeOptions::by(method.parse::<VolumeMethod>()?);
    let method = options.method;
    let known: Vec<&str> =
        ["max_distance"].into_iter().chain(HEAT.into_iter().filter(|&name| name != "operator")).collect();
    for (name, value) in given.into_iter().flatten() {
        let name = name.to_string();
        require_known(&name, &known)?;
        require_heeded(&name, method.name(), HEAT.contains(&name.as_str()) == (method == VolumeMethod::Heat))?;
        match name.as_str() {
            "max_distance" => options.max_distance = number(&name, &value)?,
            _ => set_heat(&mut options.heat, &name, &value)?,
        }
    }
    Ok(options)
}

fn require_known(name: &str, known: &[&str]) -> Result<()> {
    if known.contains(&name) {
        return Ok(());
    }
    let known = known.join(", ");
    Err(PyTypeError::new_err(format!("there is no option {name}; the options are {known}")).into())
}

fn require_heeded(name: &str, method: &str, is_heeded: bool) -> Result<()> {
    if is_heeded {
        return Ok(());
    }
    let sentence = if HEAT.contains(&name) {
        format!("{name} is an option of the heat method and has no effect with {method}; give method=\"heat\"")
    } else {
        format!("{name} has no effect with the method {method}")
    };
    Err(Failure::new("bad-parameter", sentence))
}

/// One of [`HEAT`].
fn set_heat(heat: &mut Parameters, name: &str, value: &Bound<'_, PyAny>) -> Result<()> {
    let Parameters { operator, solver, time_step, boundary, sources, exact_radius, .. } = heat;
    match name {
        "operator" => *operator = from(name, value)?,
        "solver" => *solver = from(name, value)?,
        "time_step" => *time_step = from(name, value)?,
        "boundary" => *boundary = from(name, value)?,
        "multi_source" => *sources = from(name, value)?,
        _ => *exact_radius = from(name, value)?,
    }
    Ok(())
}

/// One of the methods that there are for something: `what` is not done by the others.
pub fn method_of(name: &str, methods: &[Method], what: &str) -> Result<Method> {
    let method = name.parse::<Method>()?;
    if methods.contains(&method) {
        return Ok(method);
    }
    let known = methods.iter().map(|method| method.name()).collect::<Vec<_>>().join(", ");
    Err(Failure::new("unknown-choice", format!("{what} by {}; choose one of {known}", method.name())))
}

/// A choice by its name, a number, or a word in place of one.
pub fn from<T: FromStr>(name: &str, value: &Bound<'_, PyAny>) -> Result<T>
where
    Failure: From<T::Err>,
{
    let is_told = value.extract::<&str>().is_ok() || value.extract::<f64>().is_ok();
    if !is_told {
        return Err(PyTypeError::new_err(format!("{name} is {}; give a string or a number", value.repr()?)).into());
    }
    Ok(value.str()?.to_string().parse::<T>()?)
}

fn number(name: &str, value: &Bound<'_, PyAny>) -> Result<f64> {
    let bad = |_| PyTypeError::new_err(format!("{name} is no number"));
    Ok(value.extract().map_err(bad)?)
}
