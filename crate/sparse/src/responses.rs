//! Responses to constraints, kept from one question to the next.

use std::collections::HashMap;
use std::sync::Arc;

use crate::constraints::{Functional, Response, System};
use crate::error::Result;

/// The responses of one system to the constraints of late, by constraint.
#[derive(Debug, Default)]
pub struct Responses {
    kept: HashMap<Key, Arc<Response>>,
}

/// A functional with its weights as bits, which can be compared.
type Key = Vec<(u32, u64)>;

impl Responses {
    /// Responses to these constraints, computed where they are not kept from before. Adding one source to many thus
    /// costs one. When more numbers are kept than `most`, those not asked for now are dropped.
    pub fn of(&mut self, system: &System, functionals: &[Functional], most: usize) -> Result<Vec<Arc<Response>>> {
        let keys: Vec<Key> = functionals.iter().map(key).collect();
        let is_missing = |key: &&Key| !self.kept.contains_key(*key);
        let missing: Vec<&Key> = keys.iter().filter(is_missing).collect();
        let wanted: Vec<Functional> = missing.iter().map(|key| functional(key)).collect();
        let made = system.responses(&wanted)?;
        for (key, response) in missing.into_iter().zip(made) {
            self.kept.insert(key.clone(), response);
        }
        let responses: Vec<Arc<Response>> = keys.iter().map(|key| Arc::clone(&self.kept[key])).collect();
        if self.kept.values().map(|response| response.value_count()).sum::<usize>() > most {
            self.kept = keys.into_iter().zip(responses.iter().cloned()).collect();
        }
        Ok(responses)
    }
}

fn key(functional: &Functional) -> Key {
    functional.iter().map(|&(unknown, weight)| (unknown, weight.to_bits())).collect()
}

fn functional(key: &Key) -> Functional {
    key.iter().map(|&(unknown, bits)| (unknown, f64::from_bits(bits))).collect()
}
