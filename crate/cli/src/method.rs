//! By which method a command finds distances.

use anyhow::{Result, bail};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use heatwalk::{Choice, Method, Windows};
use heatwalk_volume::VolumeMethod;

/// What every command that may find distances in several ways has.
#[derive(Args)]
pub struct Methods {
    /// How distances are found, inside of tetrahedra by march or heat; without it heat where an option of the heat method is given,
    /// else auto
    #[arg(long, value_parser = named())]
    pub method: Option<Named>,
    /// Windows that propagation keeps of each half-edge, or all; 2 if not given
    #[arg(long, value_name = "K")]
    pub windows: Option<Windows>,
}

/// A method by its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Named {
    /// One of surfaces.
    Surface(Method),
    /// [`VolumeMethod::March`], of tetrahedra alone.
    March,
}

impl Named {
    fn name(self) -> &'static str {
        match self {
            Self::Surface(method) => method.name(),
            Self::March => VolumeMethod::March.name(),
        }
    }
}

fn named() -> impl TypedValueParser<Value = Named> {
    let names = Method::ALL.iter().map(|method| method.name()).chain([VolumeMethod::March.name()]);
    PossibleValuesParser::new(names).try_map(|name| {
        if name == VolumeMethod::March.name() { Ok(Named::March) } else { name.parse().map(Named::Surface) }
    })
}

/// The options given that some methods only heed, by their names on the command line.
pub struct MethodOptions {
    /// One of the heat method.
    pub heat: Option<&'static str>,
    /// `--exact`.
    pub exact: bool,
    /// One that all methods but heat heed.
    pub search: Option<&'static str>,
}

impl Methods {
    /// The method that the options mean. One that would have no effect is refused.
    pub fn chosen(&self, given: &MethodOptions) -> Result<Method> {
        let explicit = match self.method {
            Some(Named::March) => bail!("--method march is for tetrahedra; choose auto or heat for a surface"),
            Some(Named::Surface(method)) => Some((method, format!("--method {}", method.name()))),
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

    /// The same for tetrahedra; `heat` is the option of the heat method that is given.
    pub fn chosen_inside(&self, heat: Option<&'static str>) -> Result<VolumeMethod> {
        match (self.method, heat) {
            (None | Some(Named::Surface(Method::Heat)), Some(_)) | (Some(Named::Surface(Method::Heat)), None) => {
                Ok(VolumeMethod::Heat)
            }
            (Some(Named::March | Named::Surface(Method::Auto)), Some(option)) => {
                bail!("{option} is an option of the heat method and has no effect with --method march")
            }
            (None | Some(Named::March | Named::Surface(Method::Auto)), None) => Ok(VolumeMethod::March),
            (Some(method), _) => {
                bail!("--method {} is for surfaces; choose march or heat inside of tetrahedra", method.name())
            }
        }
    }
}
