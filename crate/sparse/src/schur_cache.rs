//! Schur columns, kept from one set of constraints to the next.

use std::collections::HashMap;
use std::sync::Arc;

use crate::error::Result;
use crate::scalar::Scalar;
use crate::schur::{Functional, SchurColumn};
use crate::system::System;

#[cfg(test)]
mod tests;

/// The Schur columns of one system for the constraints of late, by constraint.
#[derive(Debug, Default)]
pub struct SchurCache<T: Scalar = f64> {
    columns: HashMap<Key<T>, Arc<SchurColumn<T>>>,
}

/// A functional with its weights as bits, which can be compared.
type Key<T> = Vec<(u32, <T as Scalar>::Bits)>;

impl<T: Scalar> SchurCache<T> {
    /// Schur columns of these constraints, computed where they are not kept from before. Adding one constraint to many thus
    /// costs one. When more numbers than `capacity` are kept, columns not asked for now are dropped.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn columns(
        &mut self,
        system: &System<T>,
        functionals: &[Functional<T>],
        capacity: usize,
    ) -> Result<Vec<Arc<SchurColumn<T>>>> {
        let keys: Vec<Key<T>> = functionals.iter().map(key).collect();
        let is_missing = |(key, _): &(&Key<T>, &Functional<T>)| !self.columns.contains_key(*key);
        let missing = keys.iter().zip(functionals).filter(is_missing);
        let (missing, wanted): (Vec<&Key<T>>, Vec<Functional<T>>) =
            missing.map(|(key, functional)| (key, functional.clone())).unzip();
        let made = system.schur_columns(&wanted)?;
        for (key, column) in missing.into_iter().zip(made) {
            self.columns.insert(key.clone(), column);
        }
        let columns: Vec<Arc<SchurColumn<T>>> = keys.iter().map(|key| Arc::clone(&self.columns[key])).collect();
        if self.columns.values().map(|column| column.nonzeros()).sum::<usize>() > capacity {
            self.columns = keys.into_iter().zip(columns.iter().cloned()).collect();
        }
        Ok(columns)
    }
}

fn key<T: Scalar>(functional: &Functional<T>) -> Key<T> {
    functional.iter().map(|&(unknown, weight)| (unknown, weight.bits())).collect()
}
