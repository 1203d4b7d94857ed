//! The memory that reading takes, against the budget of the file.

use heatwalk_model::io::Budget;
use peak_alloc::PeakAlloc;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// A list that grows is in memory twice while it is copied, once half as long.
const GROWING: f64 = 1.5;
/// What the parsed JSON, XML or text of a file takes for each of its bytes, which is not counted.
const PARSED: usize = 100;

/// What reading so many bytes gives, those of other files among them.
///
/// # Panics
/// Where more memory was in use at once than their budget allows.
pub fn within_budget<T>(bytes: usize, read: impl FnOnce() -> T) -> T {
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let done = read();
    let used = ALLOCATOR.peak_usage().saturating_sub(before);
    let most = (GROWING * Budget::of_file(bytes).left() as f64) as usize + PARSED * bytes;
    assert!(used <= most, "reading {bytes} bytes took {used} bytes of memory, more than {most}");
    done
}
