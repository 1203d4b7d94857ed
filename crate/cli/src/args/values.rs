//! Numbers and directions, as they are written on the command line.

use glam::DVec3;

use crate::place::vector;

/// A number of links.
pub fn links(text: &str) -> Result<usize, String> {
    match text {
        "all" => Ok(usize::MAX),
        _ => text.parse().map_err(|_| "a number of links or all is needed".to_owned()),
    }
}

/// A direction in space.
pub fn direction(text: &str) -> Result<DVec3, String> {
    let direction = vector(text).filter(|direction| direction.try_normalize().is_some());
    direction.ok_or_else(|| "give a direction as three numbers, such as 0,0,1".to_owned())
}

/// A number of things, one at least.
pub fn at_least_one(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|&number| number > 0);
    number.ok_or_else(|| "a number of at least 1 is needed".to_owned())
}

/// A positive number.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number: &f64| number > 0.0);
    number.ok_or_else(|| "a positive number is needed".to_owned())
}
