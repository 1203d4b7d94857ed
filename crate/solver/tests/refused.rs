//! Searches that are refused memory while they go on.

#![expect(unsafe_code)]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::num::NonZeroU16;
use std::sync::Arc;

use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Error, Propagation, PropagationOptions, Result, Surface, VertexId, Windows};
use heatwalk_shapes as shapes;

thread_local! {
    /// Larger blocks are refused.
    static LARGEST: Cell<usize> = const { Cell::new(usize::MAX) };
}

struct Refusing;

#[global_allocator]
static ALLOCATOR: Refusing = Refusing;

fn is_refused(bytes: usize) -> bool {
    LARGEST.try_with(|largest| bytes > largest.get()).unwrap_or(false)
}

// SAFETY: every call is one of the system's allocator, or answered by the null pointer that stands for no memory.
unsafe impl GlobalAlloc for Refusing {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if is_refused(layout.size()) { std::ptr::null_mut() } else { unsafe { System.alloc(layout) } }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        if is_refused(bytes) { std::ptr::null_mut() } else { unsafe { System.realloc(block, layout, bytes) } }
    }
}

/// What `work` gives while blocks of more than so many bytes are refused.
fn within<T>(bytes: usize, work: impl FnOnce() -> T) -> T {
    LARGEST.set(bytes);
    let given = work();
    LARGEST.set(usize::MAX);
    given
}

fn is_out_of_memory<T>(result: &Result<T>) -> bool {
    matches!(result, Err(Error::OutOfMemory { stage: "keeping windows" }))
}

fn sphere() -> Arc<ExactGeometry> {
    Arc::new(ExactGeometry::new(Surface::build(&shapes::icosphere(5)).expect("a surface")))
}

#[test]
fn an_exact_search_says_so_and_can_be_started_anew() {
    let geometry = sphere();
    let start = || Wavefront::new(Arc::clone(&geometry), &[VertexId(0)]).expect("a source");
    let mut expected = start();
    assert!(expected.advance(f64::INFINITY, usize::MAX).expect("memory"));
    // What is refused first are buckets, lists, lists of lists, and the list of all vertices that are reached.
    for bytes in [128, 512, 2_048, 8_192, 16_384, 32_768] {
        let mut front = start();
        for _ in 0..2 {
            let refused = within(bytes, || front.advance(f64::INFINITY, usize::MAX));
            assert!(is_out_of_memory(&refused), "{bytes} bytes: {refused:?}");
            assert!(!front.is_done());
        }
        front.restart(&[VertexId(0)]).expect("a source");
        assert!(front.advance(f64::INFINITY, usize::MAX).expect("memory"));
        assert_eq!(front.values(), expected.values(), "{bytes} bytes");
    }
    assert!(is_out_of_memory(&within(65_536, || Wavefront::new(Arc::clone(&geometry), &[VertexId(0)]))));
}

#[test]
fn a_propagation_says_so_and_can_be_started_anew() {
    let geometry = sphere();
    for windows in [1, 2, 5] {
        let options = PropagationOptions {
            windows: Windows::AtMost(NonZeroU16::new(windows).expect("a window")),
            ..PropagationOptions::default()
        };
        let start = || Propagation::new(Arc::clone(&geometry), &[VertexId(0)], options).expect("a source");
        let mut expected = start();
        assert!(expected.advance(f64::INFINITY, usize::MAX).expect("memory"));
        // The values of the front, which begins where the exact search ends, are refused: nothing has changed then.
        let mut propagation = start();
        assert!(is_out_of_memory(&within(65_536, || propagation.advance(f64::INFINITY, usize::MAX))));
        assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("memory"));
        assert_eq!(propagation.values(), expected.values());
        // Past the exact search.
        let work = 8_000;
        for bytes in [1_024, 4_096, 12_288] {
            let mut propagation = start();
            propagation.advance(f64::INFINITY, work).expect("memory");
            for _ in 0..2 {
                let refused = within(bytes, || propagation.advance(f64::INFINITY, usize::MAX));
                assert!(is_out_of_memory(&refused), "{windows} windows, {bytes} bytes: {refused:?}");
                assert!(!propagation.is_done());
            }
            propagation.restart(&[VertexId(0)]).expect("a source");
            assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("memory"));
            assert_eq!(propagation.values(), expected.values(), "{windows} windows, {bytes} bytes");
        }
    }
}
