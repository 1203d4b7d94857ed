//! Schur columns, kept from one set of constraints to the next.

use std::collections::HashMap;
use std::sync::Arc;

use crate::error::Result;
use crate::schur::{Functional, SchurColumn};
use crate::system::System;

#[cfg(test)]
mod tests;

/// The Schur columns of one system for the constraints of late, by constraint.
#[derive(Debug, Default)]
pub struct SchurCache {
    columns: HashMap<Key, Arc<SchurColumn>>,
}

/// A functional with its weights as bits, which can be compared.
type Key = Vec<(u32, u64)>;

impl SchurCache {
    /// Schur columns of these constraints, computed where they are not kept from before. Adding one constraint to many thus
    /// costs one. When more numbers than `capacity` are kept, columns not asked for now are dropped.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn columns(
        &mut self,
        system: &System,
        functionals: &[Functional],
        capacity: usize,
    ) -> Result<Vec<Arc<SchurColumn>>> {
        let keys: Vec<Key> = functionals.iter().map(key).collect();
        let is_missing = |key: &&Key| !self.columns.contains_key(*key);
        let missing: Vec<&Key> = keys.iter().filter(is_missing).collect();
        let wanted: Vec<Functional> = missing.iter().map(|key| functional(key)).collect();
        let made = system.schur_columns(&wanted)?;
        for (key, column) in missing.into_iter().zip(made) {
            self.columns.insert(key.clone(), column);
        }
        let columns: Vec<Arc<SchurColumn>> = keys.iter().map(|key| Arc::clone(&self.columns[key])).collect();
        if self.columns.values().map(|column| column.nonzeros()).sum::<usize>() > capacity {
            self.columns = keys.into_iter().zip(columns.iter().cloned()).collect();
        }
        Ok(columns)
    }
}

fn key(functional: &Functional) -> Key {
    functional.iter().map(|&(unknown, weight)| (unknown, weight.to_bits())).collect()
}

fn functional(key: &Key) -> Functional {
    key.iter().map(|&(unknown, bits)| (unknown, f64::from_bits(bits))).collect()
}
