//! By which method a command finds distances.

use anyhow::{Result, bail};
use clap::Args;
use heatwalk::{Choice, Method, Windows};

use crate::options::choice;

/// What every command that may find distances in several ways has.
#[derive(Args)]
pub struct Methods {
    /// How distances are found; without it heat where an option of the heat method is given, else auto
    #[arg(long, value_parser = choice::<Method>())]
    pub method: Option<Method>,
    /// Windows that propagation keeps of each half-edge, or all; 2 if not given
    #[arg(long, value_name = "K")]
    pub windows: Option<Windows>,
}

/// The options given that some methods only heed, by their names on the command line.
pub struct Given {
    /// One of the heat method.
    pub heat: Option<&'static str>,
    /// `--exact`.
    pub exact: bool,
    /// One that all methods but heat heed.
    pub search: Option<&'static str>,
}

impl Methods {
    /// The method that the options mean. One that would have no effect is refused.
    pub fn chosen(&self, given: &Given) -> Result<Method> {
        let explicit = match self.method {
            Some(method) => Some((method, format!("--method {}", method.name()))),
            None => given.exact.then(|| (Method::Exact, "--exact".to_owned())),
        };
        let (method, name) = match (explicit, given.heat) {
            (Some((method, name)), Some(option)) if method != Method::Heat => {
                bail!("{option} is an option of the heat method and has no effect with {name}")
            }
            (Some(explicit), _) => explicit,
            (None, Some(option)) => (Method::Heat, option.to_owned()),
            (None, None) => (Method::Auto, String::new()),
        };
        let windows = self.windows.map(|_| "--windows");
        let unheeded = match method {
            Method::Heat => windows.or(given.search),
            Method::Exact => windows,
            Method::Auto | Method::Propagation => None,
        };
        match unheeded {
            Some(option) => bail!("{option} has no effect with {name}, which means the method {}", method.name()),
            None => Ok(method),
        }
    }
}
