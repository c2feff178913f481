/// @file
/// Sums of very many numbers that round no more than sums of two.
#pragma once

namespace tumble {

/// Kahan's sum: what each addition rounds off is carried to the next one. The error stays near two
/// units of roundoff of Σ|terms|, however many terms there are; a plain sum loses up to one unit a
/// term. `Value` is a number or a matrix.
//! [compensated_sum]
template <class Value>
struct CompensatedSum {
  Value sum;            ///< of all that was added
  Value carried = sum;  ///< what has been rounded off and not yet put back

  /// Begins with `zero`, which also gives a matrix its size.
  explicit CompensatedSum(const Value& zero) : sum(zero) {}

  void add(const Value& term) {
    const Value owed = term - carried;
    const Value next = sum + owed;
    carried = (next - sum) - owed;
    sum = next;
  }
};
//! [compensated_sum]

}  // namespace tumble
