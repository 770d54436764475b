//! Small dense linear systems that may be rank-deficient.

/// Solves A x = b by Gaussian elimination with full pivoting, where A may lack rank.
///
/// `a` is n×n by rows and `b` has n elements; both are overwritten, `b` with the solution. Pivots below `tolerance` times the first are
/// taken as zero and their unknowns set to zero: redundant constraints then share their load in some way that
/// satisfies all of them. `order` is scratch of n elements. Returns the rank found.
///
/// # Panics
/// If the slices are too short.
pub fn solve_rank_revealing(a: &mut [f64], b: &mut [f64], order: &mut [usize], tolerance: f64) -> usize {
    let n = b.len();
    assert!(a.len() >= n * n && order.len() >= n, "n×n elements and n places");
    for (i, o) in order.iter_mut().enumerate().take(n) {
        *o = i;
    }
    let mut rank = n;
    let mut first = 0.0;
    for k in 0..n {
        let (mut row, mut col, mut best) = (k, k, 0.0);
        for i in k..n {
            for j in k..n {
                if a[i * n + j].abs() > best {
                    (row, col, best) = (i, j, a[i * n + j].abs());
                }
            }
        }
        if k == 0 {
            first = best;
        }
        // Also stops where everything is zero; what is not a number never becomes the best.
        if best == 0.0 || best <= tolerance * first {
            rank = k;
            break;
        }
        for j in 0..n {
            a.swap(k * n + j, row * n + j);
        }
        b.swap(k, row);
        for i in 0..n {
            a.swap(i * n + k, i * n + col);
        }
        order.swap(k, col);
        let pivot = a[k * n + k];
        for i in k + 1..n {
            let factor = a[i * n + k] / pivot;
            for j in k..n {
                a[i * n + j] -= factor * a[k * n + j];
            }
            b[i] -= factor * b[k];
        }
    }
    b[rank..n].fill(0.0);
    for k in (0..rank).rev() {
        let mut sum = b[k];
        for j in k + 1..rank {
            sum -= a[k * n + j] * b[j];
        }
        b[k] = sum / a[k * n + k];
    }
    // Column exchanges permuted the unknowns: `order[k]` is the unknown that `b[k]` holds.
    for k in 0..n {
        while order[k] != k {
            let target = order[k];
            b.swap(k, target);
            order.swap(k, target);
        }
    }
    rank
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A x = b is satisfied by the solution whenever b lies in the range of A, whatever the rank.
        #[test]
        fn consistent_systems_are_solved(
            factors in prop::collection::vec(-1.0f64..1.0, 36),
            x in prop::collection::vec(-1.0f64..1.0, 6),
            rank in 1usize..=6,
        ) {
            let n = 6;
            // A = F Fᵀ with F of `rank` columns.
            let f = |i: usize, k: usize| factors[i * n + k] + if i == k { 1.5 } else { 0.0 };
            let mut a = vec![0.0; n * n];
            for i in 0..n { for j in 0..n { for k in 0..rank { a[i * n + j] += f(i, k) * f(j, k); } } }
            let mut b: Vec<f64> = (0..n).map(|i| (0..n).map(|j| a[i * n + j] * x[j]).sum()).collect();
            let (a0, b0) = (a.clone(), b.clone());
            let mut order = [0; 6];
            let found = solve_rank_revealing(&mut a, &mut b, &mut order, 1e-9);
            prop_assert!(found <= rank);
            for i in 0..n {
                let ax: f64 = (0..n).map(|j| a0[i * n + j] * b[j]).sum();
                // Pivots down to 1e-9 of the first may be dropped: an error of 1e-9 times |A| |x| ≤ 50.
                prop_assert!((ax - b0[i]).abs() < 1e-7, "row {} {} {}", i, ax, b0[i]);
            }
        }
    }
}
