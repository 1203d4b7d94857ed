//! Independent questions on several threads.

use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use crate::error::{Error, Result};
use heatwalk_base::sort;
use heatwalk_sparse::{Progress, Stage};

/// The answers to questions `0..count`, in their order. Each worker has a thread, the first one the caller's, and takes the
/// next question when it is done with one. `progress` is told by the first worker how many are answered, between its answers and
/// while it works on one.
///
/// # Errors
/// The first of `answer`, in the order of the questions asked until then; [`Error::Cancelled`]. Then no further question is
/// asked, and those that are worked on are cancelled by their progress.
pub(super) fn answers<W: Send, A: Send>(
    workers: &mut [W],
    count: usize,
    answer: impl Fn(&mut W, usize, Progress<'_>) -> Result<A> + Sync,
    progress: Progress<'_>,
) -> Result<Vec<A>> {
    let (next, done, is_over) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicBool::new(false));
    let work = |worker: &mut W, tell: &mut dyn FnMut(f64) -> ControlFlow<()>| {
        let mut answered: Vec<(usize, Result<A>)> = Vec::new();
        let share = |done: usize| done as f64 / count as f64;
        while !is_over.load(Ordering::Relaxed) {
            let question = next.fetch_add(1, Ordering::Relaxed);
            if question >= count {
                break;
            }
            let mut within = |_, _| match tell(share(done.load(Ordering::Relaxed))) {
                ControlFlow::Continue(()) if !is_over.load(Ordering::Relaxed) => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            };
            let mut answer = answer(worker, question, &mut within);
            let total = done.fetch_add(1, Ordering::Relaxed) + 1;
            if answer.is_ok() && tell(share(total)).is_break() {
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
        let go_on = |_| ControlFlow::Continue(());
        let spawned = others.iter_mut().map(|worker| scope.spawn(move || work(worker, &mut { go_on })));
        let others: Vec<_> = spawned.collect();
        let mut answered = work(first, &mut |done| progress(Stage::Answering, done));
        for other in others {
            // A panic there is one here.
            answered.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        answered
    });
    sort::sort_by_key(&mut answered, |&(question, _)| question);
    answered.into_iter().map(|(_, answer)| answer).collect()
}
