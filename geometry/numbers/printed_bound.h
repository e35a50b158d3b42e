#pragma once

namespace gnomon {

/// An error bound that holds for a printed number: the shortest decimal that reads back as a double is in general not
/// that double.
///
/// Requires: `bound` is not negative.
/// Returns:  a double whose own shortest decimal is at least |d - x|, d the shortest decimal of `value`, for every x
/// with
///           |value - x| <= bound. 0 if the bound is 0 and d is `value` itself; infinite if the bound is.
/// Exactness: at most half an ulp of `value` and three ulps of itself larger than `bound`.
double printed_error_bound(double value, double bound);

}  // namespace gnomon
