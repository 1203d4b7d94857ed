//! Results of sparse forward solves, kept and combined.
//!
//! Davis, "Direct Methods for Sparse Linear Systems" (2006), section 3.2 on the reach of a sparse right side.

use crate::scalar::{Scalar, dot};

/// A vector in the elimination order that is zero outside some runs.
#[derive(Debug, Clone, Default)]
pub(crate) struct SparseVector<T> {
    /// Where each run begins among the unknowns, ascending.
    starts: Vec<u32>,
    /// Where each run ends in `values`.
    ends: Vec<u32>,
    values: Vec<T>,
}

impl<T: Scalar> SparseVector<T> {
    /// Appends a run that lies after all others.
    pub(crate) fn push(&mut self, start: usize, values: impl Iterator<Item = T>) {
        self.starts.push(start as u32);
        self.values.extend(values);
        self.ends.push(self.values.len() as u32);
    }

    /// Number of values kept.
    pub(crate) fn len(&self) -> usize {
        self.values.len()
    }

    fn runs(&self) -> impl Iterator<Item = (usize, &[T])> {
        let mut from = 0;
        self.starts.iter().zip(&self.ends).map(move |(&start, &end)| {
            let run = &self.values[from..end as usize];
            from = end as usize;
            (start as usize, run)
        })
    }

    /// Inner product `selfᴴ other` with another vector of the same factor, whose runs are the same wherever both have one.
    pub(crate) fn dot(&self, other: &Self) -> T {
        let mut others = other.runs().peekable();
        let mut sum = T::ZERO;
        for (start, run) in self.runs() {
            while others.next_if(|&(other_start, _)| other_start < start).is_some() {}
            if let Some((_, other_run)) = others.next_if(|&(other_start, _)| other_start == start) {
                sum += dot(run, other_run);
            }
        }
        sum
    }

    /// Inner product `selfᴴ vector` with a whole vector.
    pub(crate) fn dot_dense(&self, vector: &[T]) -> T {
        self.runs().map(|(start, run)| dot(run, &vector[start..start + run.len()])).sum()
    }

    /// `vector += factor · self`.
    pub(crate) fn add_to(&self, factor: T, vector: &mut [T]) {
        for (start, run) in self.runs() {
            for (target, &value) in vector[start..].iter_mut().zip(run) {
                *target += factor * value;
            }
        }
    }
}
