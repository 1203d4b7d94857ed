//! Options of distances, in the page's words.

use heatwalk::{DistanceOptions, Method};
use heatwalk_bindings::{Failure, Result, parameters};
use js_sys::{Object, Reflect};

use crate::given::{entries, parsed, property};

/// Options of the heat method alone.
const HEAT: [&str; 6] = ["operator", "solver", "timeStep", "boundary", "multiSource", "exactRadius"];

/// What is asked of the solver. An option that the method does not heed is refused.
///
/// # Errors
/// For an option that does not exist or that the method does not heed, and a value that it does not take.
pub fn distance_options(given: &Object) -> Result<DistanceOptions> {
    let method = property(given, "method").map(|method| parsed("method", &method)).transpose()?.unwrap_or_default();
    let mut options = DistanceOptions::by(method);
    let heat = Object::new();
    for (name, value) in entries(given) {
        let is_of_heat = HEAT.contains(&name.as_str());
        let is_heeded = match name.as_str() {
            "method" => continue,
            "windows" => matches!(method, Method::Auto | Method::Propagation),
            "maxDistance" => method != Method::Heat,
            _ if is_of_heat => method == Method::Heat,
            _ => {
                let known = HEAT.join(", ");
                let sentence =
                    format!("there is no option {name}; the options are method, maxDistance, windows, {known}");
                return Err(Failure::of("bad-parameter", &sentence));
            }
        };
        if !is_heeded {
            return Err(Failure::of("bad-parameter", &format!("{name} has no effect with the method {method}")));
        }
        match name.as_str() {
            "windows" => options.windows = parsed(&name, &value)?,
            "maxDistance" => {
                let refused = || Failure::of("bad-parameter", "maxDistance is no number");
                options.max_distance = value.as_f64().ok_or_else(refused)?;
            }
            _ => {
                // Setting a property of a plain object cannot fail.
                let name = if name == "multiSource" { "sources" } else { &name };
                let _ = Reflect::set(&heat, &name.into(), &value);
            }
        }
    }
    options.heat = parameters(&heat)?;
    Ok(options)
}

/// One of the methods that there are for something: `what` is not done by the others.
///
/// # Errors
/// For a name that is none of theirs.
pub fn method_of(name: &str, methods: &[Method], what: &str) -> Result<Method> {
    let method = name.parse::<Method>()?;
    if methods.contains(&method) {
        return Ok(method);
    }
    let known = methods.iter().map(|method| method.to_string()).collect::<Vec<_>>().join(", ");
    Err(Failure::of("unknown-choice", &format!("{what} by {method}; choose one of {known}")))
}
