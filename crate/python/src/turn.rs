//! What one thread uses at a time.

use std::sync::{Condvar, Mutex, PoisonError};
use std::thread::{self, ThreadId};
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors::{Failure, Result};

/// Between two looks for Ctrl-C while others have their turn.
const BETWEEN: Duration = Duration::from_millis(50);

/// A value that is made when it is first used, and again after a panic.
pub struct Turns<T> {
    /// Whose turn it is.
    owner: Mutex<Option<ThreadId>>,
    ended: Condvar,
    value: Mutex<Option<T>>,
}

/// Ends a turn, however it ends.
struct Turn<'a, T>(&'a Turns<T>);

impl<T> Turns<T> {
    /// With a value that was made before.
    pub fn new(value: T) -> Self {
        Self { owner: Mutex::default(), ended: Condvar::new(), value: Mutex::new(Some(value)) }
    }

    /// Works on the value in turn, without Python's lock.
    ///
    /// # Errors
    /// Where the thread is in its turn already; what a signal raises while it waits; those of `make` and `work`.
    pub fn with<R>(&self, make: impl FnOnce() -> Result<T>, work: impl FnOnce(&mut T) -> Result<R>) -> Result<R> {
        let turn = self.wait()?;
        let mut kept = turn.0.value.lock().unwrap_or_else(PoisonError::into_inner);
        // It is away where a panic ends the work.
        let mut value = match kept.take() {
            Some(value) => value,
            None => make()?,
        };
        let result = work(&mut value);
        *kept = Some(value);
        result
    }

    fn wait(&self) -> Result<Turn<'_, T>> {
        let own = thread::current().id();
        let mut owner = self.owner.lock().unwrap_or_else(PoisonError::into_inner);
        while let Some(other) = *owner {
            if other == own {
                return Err(Failure::new(
                    "busy",
                    "this mesh is computing in this thread, so a callback cannot ask it; ask a copy",
                ));
            }
            owner = self.ended.wait_timeout(owner, BETWEEN).unwrap_or_else(PoisonError::into_inner).0;
            if owner.is_some() {
                Python::attach(|py| py.check_signals())?;
            }
        }
        *owner = Some(own);
        Ok(Turn(self))
    }
}

impl<T> Drop for Turn<'_, T> {
    fn drop(&mut self) {
        *self.0.owner.lock().unwrap_or_else(PoisonError::into_inner) = None;
        self.0.ended.notify_one();
    }
}
