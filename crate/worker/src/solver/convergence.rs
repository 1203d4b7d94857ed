//! How the linear solvers come to the last field, for charts.

use heatwalk::heat;
use heatwalk_bindings::Result;
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

use super::Solver;

/// Residuals of the two systems of the heat method, as shares of their right sides.
#[wasm_bindgen(inspectable)]
pub struct Convergence(heat::Convergence);

#[wasm_bindgen]
impl Convergence {
    /// Of the heat system, before the first step of conjugate gradients and after each.
    #[wasm_bindgen(getter)]
    pub fn heat(&self) -> Float64Array {
        self.0.heat.iterated.as_slice().into()
    }

    /// Of the Poisson system.
    #[wasm_bindgen(getter)]
    pub fn poisson(&self) -> Float64Array {
        self.0.poisson.iterated.as_slice().into()
    }

    /// Of the heat system by Cholesky factors.
    #[wasm_bindgen(getter, js_name = heatFactored)]
    pub fn heat_factored(&self) -> f64 {
        self.0.heat.factored
    }

    /// Of the Poisson system by Cholesky factors.
    #[wasm_bindgen(getter, js_name = poissonFactored)]
    pub fn poisson_factored(&self) -> f64 {
        self.0.poisson.factored
    }
}

#[wasm_bindgen]
impl Solver {
    /// Solves the systems of the last field anew, by both linear solvers.
    pub fn convergence(&mut self) -> Result<Convergence> {
        let sources = self.solved()?.solution.answer().sources.clone();
        let heat = self.factors()?;
        Ok(Convergence(heat.factorization().convergence(&heat.query(&sources)?)?))
    }
}
