//! How the linear solvers come to the last field, for charts.

use heatwalk::heat;
use heatwalk_bindings::{Message, Result};
use wasm_bindgen::prelude::*;

use super::Solver;

/// Residuals of the two systems of the heat method, as shares of their right sides.
#[derive(Message)]
pub struct Convergence {
    /// Of the heat system, before the first step of conjugate gradients and after each.
    pub heat: Vec<f64>,
    /// Of the Poisson system.
    pub poisson: Vec<f64>,
    /// Of the heat system by Cholesky factors.
    pub heat_factored: f64,
    /// Of the Poisson system by Cholesky factors.
    pub poisson_factored: f64,
}

#[wasm_bindgen]
impl Solver {
    /// Solves the systems of the last field anew, by both linear solvers.
    pub fn convergence(&mut self) -> Result<Convergence> {
        let sources = self.solved()?.solution.answer().sources.clone();
        let factors = self.factors()?;
        let heat::Convergence { heat, poisson } = factors.factorization().convergence(&factors.query(&sources)?)?;
        Ok(Convergence {
            heat: heat.iterated,
            poisson: poisson.iterated,
            heat_factored: heat.factored,
            poisson_factored: poisson.factored,
        })
    }
}
