//! Work on blocks of bodies, on one thread or several, with the same result.
//!
//! A stage is a loop over blocks that write disjoint slices and read what no block writes, so neither the number of threads
//! nor their timing can show in a result. Sums over bodies are not made here: they run in slot order on one thread.

use std::sync::Arc;

/// Several slices of one length that can be cut at the same place.
pub trait Split: Sized + Send {
    /// Number of elements.
    fn len(&self) -> usize;
    /// The first `at` elements and the rest.
    fn split_at(self, at: usize) -> (Self, Self);
    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Who runs the blocks of a step.
#[derive(Clone, Default)]
pub enum Executor {
    /// The calling thread.
    #[default]
    Serial,
    /// A pool of threads; the whole step runs inside it.
    Pool(Arc<rayon::ThreadPool>),
}

impl core::fmt::Debug for Executor {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Serial => f.write_str("Serial"),
            Self::Pool(pool) => write!(f, "Pool({} threads)", pool.current_num_threads()),
        }
    }
}

impl Executor {
    /// A pool of `threads` threads of its own, in which a step runs; for one, the calling thread.
    ///
    /// # Errors
    /// If the operating system refuses the threads.
    pub fn with_threads(threads: usize) -> Result<Self, crate::Error> {
        if threads <= 1 {
            return Ok(Self::Serial);
        }
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(|i| format!("polhode-{i}"))
            .build()
            .map(|pool| Self::Pool(Arc::new(pool)))
            .map_err(|e| crate::Error::new("threads", format!("{threads} threads could not be started: {e}")))
    }
    /// The number of threads.
    pub fn threads(&self) -> usize {
        match self {
            Self::Serial => 1,
            Self::Pool(pool) => pool.current_num_threads(),
        }
    }
    /// Runs a whole step where its blocks will run, so that a stage does not pay for entering the pool.
    pub fn enter<R: Send>(&self, step: impl FnOnce() -> R + Send) -> R {
        match self {
            Self::Serial => step(),
            Self::Pool(pool) => pool.install(step),
        }
    }
    /// Calls `work(first, block)` for consecutive blocks of at most `block` elements.
    pub fn for_each<B: Split>(&self, all: B, block: usize, work: &(impl Fn(usize, B) + Sync)) {
        match self {
            Self::Serial => serial(all, 0, block, work),
            Self::Pool(_) => halves(all, 0, block, work),
        }
    }
}

fn serial<B: Split>(mut rest: B, mut first: usize, block: usize, work: &(impl Fn(usize, B) + Sync)) {
    while rest.len() > block {
        let (now, later) = rest.split_at(block);
        work(first, now);
        first += block;
        rest = later;
    }
    if !rest.is_empty() {
        work(first, rest);
    }
}

fn halves<B: Split>(all: B, first: usize, block: usize, work: &(impl Fn(usize, B) + Sync)) {
    let n = all.len();
    if n <= block {
        return serial(all, first, block, work);
    }
    // Cuts lie at whole blocks, so that the blocks are the same ones as on one thread.
    let at = n.div_ceil(block) / 2 * block;
    let (a, b) = all.split_at(at);
    rayon::join(|| halves(a, first, block, work), || halves(b, first + at, block, work));
}

impl<T: Send> Split for &mut [T] {
    fn len(&self) -> usize {
        (**self).len()
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        self.split_at_mut(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_element_is_visited_once_in_the_same_blocks() {
        for threads in [1, 2, 3] {
            let executor = Executor::with_threads(threads).unwrap();
            for n in [0, 1, 7, 8, 9, 1000] {
                let mut seen = vec![usize::MAX; n];
                executor.enter(|| {
                    executor.for_each(seen.as_mut_slice(), 8, &|first, block: &mut [usize]| {
                        assert!(first % 8 == 0 && block.len() <= 8);
                        for (i, s) in block.iter_mut().enumerate() {
                            *s = first + i;
                        }
                    });
                });
                assert!(seen.iter().enumerate().all(|(i, &s)| i == s));
            }
        }
    }
}
