//! Monotone queues of items by distance: a ring of buckets of one width, in order between buckets, not inside.

use crate::extremum::smaller;
use crate::room;

/// Buckets of the ring. Most items are pushed a few edges ahead; the rest wait in a list of their own.
const RING: u32 = 1024;

/// The last bucket takes everything beyond, so that bucket numbers fit.
const LAST: u32 = u32::MAX - 2 * RING;

/// Items that wait, each as often as it was pushed.
#[derive(Debug)]
pub(crate) struct Ring {
    /// Distance at which bucket 0 begins.
    base: f64,
    width: f64,
    per_distance: f64,
    /// The lowest bucket that may hold items.
    current: u32,
    /// Items of the buckets of the current round, `current − current % RING` and following.
    ring: Vec<Vec<u32>>,
    /// `(bucket, item)` of later rounds.
    later: Vec<(u32, u32)>,
    waiting: usize,
    is_refused: bool,
}

impl Ring {
    pub fn new(base: f64, width: f64) -> Self {
        Self {
            base,
            width,
            per_distance: 1.0 / width,
            current: 0,
            ring: vec![Vec::new(); RING as usize],
            later: Vec::new(),
            waiting: 0,
            is_refused: false,
        }
    }

    /// Takes all items out, with a word on each to `forget`, to begin again at `base`.
    pub fn clear(&mut self, base: f64, mut forget: impl FnMut(u32)) {
        let later = self.later.drain(..).map(|(_, item)| item);
        self.ring.iter_mut().flat_map(|bucket| bucket.drain(..)).chain(later).for_each(&mut forget);
        (self.base, self.current, self.waiting, self.is_refused) = (base, 0, 0, false);
    }

    /// Whether there was no memory for an item, which is lost.
    pub fn is_refused(&self) -> bool {
        self.is_refused
    }

    /// Every waiting item is at least this far; infinity where none waits.
    pub fn floor(&self) -> f64 {
        if self.waiting == 0 { f64::INFINITY } else { self.first() }
    }

    /// Where the first bucket that may hold items ends; infinity where none waits.
    pub fn ceiling(&self) -> f64 {
        self.floor() + self.width
    }

    /// Where the current bucket begins.
    fn first(&self) -> f64 {
        self.base + f64::from(self.current) * self.width
    }

    /// The items that wait, each with its bucket.
    fn waiting(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        let first = self.current - self.current % RING;
        let in_ring = (first..).zip(&self.ring);
        in_ring
            .flat_map(|(number, items)| items.iter().map(move |&item| (number, item)))
            .chain(self.later.iter().copied())
    }

    /// Bytes held.
    fn bytes(&self) -> usize {
        8 * self.later.capacity() + self.ring.iter().map(|bucket| 24 + 4 * bucket.capacity()).sum::<usize>()
    }

    /// The bucket for an item at `distance`.
    fn bucket_at(&self, distance: f64) -> u32 {
        let number = smaller((distance - self.base) * self.per_distance, f64::from(LAST)) as u32;
        number.max(self.current)
    }

    /// Lets an item wait at `distance`.
    pub fn push(&mut self, item: u32, distance: f64) {
        self.place(self.bucket_at(distance), item);
    }

    fn place(&mut self, number: u32, item: u32) {
        self.waiting += 1;
        let is_kept = if number / RING == self.current / RING {
            room::push(&mut self.ring[(number % RING) as usize], item)
        } else {
            room::push(&mut self.later, (number, item))
        };
        if !is_kept {
            self.refuse();
        }
    }

    #[cold]
    fn refuse(&mut self) {
        self.waiting -= 1;
        self.is_refused = true;
    }

    /// Begins anew at `distance`, or in the first bucket of the ring that is not before, so that items may wait there again.
    fn rewind(&mut self, distance: f64) {
        let number = smaller((distance - self.base) * self.per_distance, f64::from(LAST)) as u32;
        self.current = self.current.min(number.max(self.current - self.current % RING));
    }

    /// Whether none waits in the current bucket.
    fn is_between_buckets(&self) -> bool {
        self.ring[(self.current % RING) as usize].is_empty()
    }

    /// Takes an item out of the first bucket that has any, unless that begins at `limit` or beyond.
    fn pop(&mut self, limit: f64) -> Option<u32> {
        while self.waiting > 0 && self.first() < limit {
            if let Some(item) = self.ring[(self.current % RING) as usize].pop() {
                self.waiting -= 1;
                return Some(item);
            }
            self.step();
        }
        None
    }

    /// Takes some items out of the first bucket that has any, unless that begins at `limit` or beyond: `most` at most.
    pub fn pop_some(&mut self, limit: f64, most: usize, items: &mut Vec<u32>) {
        items.clear();
        items.extend(self.pop(limit));
        if !items.is_empty() {
            let bucket = &mut self.ring[(self.current % RING) as usize];
            let rest = bucket.len().saturating_sub(most - 1);
            self.waiting -= bucket.len() - rest;
            items.extend(bucket.drain(rest..));
        }
    }

    fn step(&mut self) {
        self.current += 1;
        if !self.current.is_multiple_of(RING) {
            return;
        }
        let first = self.later.iter().map(|&(number, _)| number).min();
        if let Some(first) = first {
            self.current = self.current.max(first - first % RING);
        }
        for (number, item) in std::mem::take(&mut self.later) {
            self.waiting -= 1;
            self.place(number, item);
        }
    }
}

/// Items `0..n`, each in the queue once at most.
#[derive(Debug)]
pub(crate) struct Buckets {
    /// Items that have moved to a lower bucket stay behind in the higher one too.
    ring: Ring,
    /// `#items`, the bucket that the item waits in, plus 1; 0 where it waits in none.
    bucket: Vec<u32>,
    waiting: usize,
}

impl Buckets {
    pub fn new(items: usize, base: f64, width: f64) -> Self {
        Self { ring: Ring::new(base, width), bucket: vec![0; items], waiting: 0 }
    }

    /// Takes all items out, with a word on each to `forget`, to begin again at `base`.
    pub fn clear(&mut self, base: f64, mut forget: impl FnMut(u32)) {
        self.ring.clear(base, |item| {
            self.bucket[item as usize] = 0;
            forget(item);
        });
        self.waiting = 0;
    }

    /// Whether there was no memory for an item, which is lost.
    pub fn is_refused(&self) -> bool {
        self.ring.is_refused()
    }

    /// Every waiting item is at least this far; infinity where none waits.
    pub fn floor(&self) -> f64 {
        if self.waiting == 0 { f64::INFINITY } else { self.ring.first() }
    }

    /// The items that wait.
    pub fn waiting(&self) -> impl Iterator<Item = u32> + '_ {
        let is_there = |&(number, item): &(u32, u32)| self.bucket[item as usize] == number + 1;
        self.ring.waiting().filter(is_there).map(|(_, item)| item)
    }

    /// Whether an item waits.
    pub fn holds(&self, item: u32) -> bool {
        self.bucket[item as usize] != 0
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        4 * self.bucket.capacity() + self.ring.bytes()
    }

    /// Lets the item wait at `distance`, unless it waits at a lower one.
    pub fn push(&mut self, item: u32, distance: f64) {
        let number = self.ring.bucket_at(distance);
        let bucket = &mut self.bucket[item as usize];
        if *bucket != 0 && *bucket <= number + 1 {
            return;
        }
        self.waiting += usize::from(*bucket == 0);
        *bucket = number + 1;
        self.ring.place(number, item);
    }

    /// Whether none waits in the current bucket.
    pub fn is_between_buckets(&self) -> bool {
        self.ring.is_between_buckets()
    }

    /// Lets items wait at `distance` again, as far as the ring goes back: what waits nearer than that waits there.
    pub fn rewind(&mut self, distance: f64) {
        self.ring.rewind(distance);
    }

    /// Takes some items out of the first bucket, unless that begins at `limit` or beyond: `most` at most.
    pub fn pop_some(&mut self, limit: f64, most: usize, items: &mut Vec<u32>) {
        items.clear();
        while items.is_empty() && self.waiting > 0 {
            self.ring.pop_some(limit, most, items);
            if items.is_empty() {
                return;
            }
            let here = self.ring.current + 1;
            items.retain(|&item| {
                let bucket = &mut self.bucket[item as usize];
                let is_there = *bucket == here;
                *bucket = if is_there { 0 } else { *bucket };
                is_there
            });
            self.waiting -= items.len();
        }
    }
}
