//! Independent questions on several threads.

use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use crate::error::{Error, Result};
use crate::progress::{Step, Steps};

/// The answers to questions `0..count`, in their order. Each worker has a thread, the first one the caller's, and takes the
/// next question when it is done with one. `progress` is told how many are answered, between those of the first worker.
///
/// # Errors
/// The first of `answer`, in the order of the questions asked until then; [`Error::Cancelled`]. Then no further question is
/// asked.
pub(super) fn answers<W: Send, A: Send>(
    workers: &mut [W],
    count: usize,
    answer: impl Fn(&mut W, usize) -> Result<A> + Sync,
    progress: Steps<'_>,
) -> Result<Vec<A>> {
    let (next, done, is_over) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicBool::new(false));
    let work = |worker: &mut W, between: Steps<'_>| {
        let mut answered: Vec<(usize, Result<A>)> = Vec::new();
        while !is_over.load(Ordering::Relaxed) {
            let question = next.fetch_add(1, Ordering::Relaxed);
            if question >= count {
                break;
            }
            let mut answer = answer(worker, question);
            let total = done.fetch_add(1, Ordering::Relaxed) + 1;
            if answer.is_ok() && between(Step::Answered(total)).is_break() {
                answer = Err(Error::Cancelled);
            }
            if answer.is_err() {
                is_over.store(true, Ordering::Relaxed);
            }
            answered.push((question, answer));
        }
        answered
    };
    let (first, others) = workers.split_first_mut().expect("a worker");
    let mut answered = thread::scope(|scope| {
        let work = &work;
        let others: Vec<_> = others
            .iter_mut()
            .map(|worker| scope.spawn(move || work(worker, &mut |_| ControlFlow::Continue(()))))
            .collect();
        let mut answered = work(first, progress);
        for other in others {
            // A panic there is one here.
            answered.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        answered
    });
    answered.sort_unstable_by_key(|&(question, _)| question);
    answered.into_iter().map(|(_, answer)| answer).collect()
}
