//! Results of sparse forward solves, kept and combined.
//!
//! Davis, "Direct Methods for Sparse Linear Systems" (2006), section 3.2 on the reach of a sparse right side.

use crate::simd::dot;

/// A vector in the elimination order that is zero outside some runs.
#[derive(Debug, Clone, Default)]
pub(crate) struct SparseVector {
    /// Where each run begins among the unknowns, ascending.
    starts: Vec<u32>,
    /// Where each run ends in `values`.
    ends: Vec<u32>,
    values: Vec<f64>,
}

impl SparseVector {
    /// Appends a run that lies after all others.
    pub(crate) fn push(&mut self, start: usize, values: impl Iterator<Item = f64>) {
        self.starts.push(start as u32);
        self.values.extend(values);
        self.ends.push(self.values.len() as u32);
    }

    /// Number of values kept.
    pub(crate) fn len(&self) -> usize {
        self.values.len()
    }

    fn runs(&self) -> impl Iterator<Item = (usize, &[f64])> {
        let mut from = 0;
        self.starts.iter().zip(&self.ends).map(move |(&start, &end)| {
            let run = &self.values[from..end as usize];
            from = end as usize;
            (start as usize, run)
        })
    }

    /// Inner product with another vector of the same factor, whose runs are the same wherever both have one.
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        let mut others = other.runs().peekable();
        let mut sum = 0.0;
        for (start, run) in self.runs() {
            while others.next_if(|&(other_start, _)| other_start < start).is_some() {}
            if let Some((_, other_run)) = others.next_if(|&(other_start, _)| other_start == start) {
                sum += dot(run, other_run);
            }
        }
        sum
    }

    /// Inner product with a whole vector.
    pub(crate) fn dot_dense(&self, vector: &[f64]) -> f64 {
        self.runs().map(|(start, run)| dot(run, &vector[start..start + run.len()])).sum()
    }

    /// `vector += factor · self`.
    pub(crate) fn add_to(&self, factor: f64, vector: &mut [f64]) {
        for (start, run) in self.runs() {
            for (target, value) in vector[start..].iter_mut().zip(run) {
                *target += factor * value;
            }
        }
    }
}
