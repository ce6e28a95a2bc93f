#pragma once
#include <algorithm>
#include <cmath>

namespace percuss::model {

/// Where f, continuous and of different signs at low and high, is zero: Ridders' method, which keeps the bracket, to
/// the last bits of the root. A zero at an end is that end.
template <class Function>
double ridders_root(double low, double high, const Function& f) {
  constexpr int kMaxRounds = 200;
  double at_low = f(low), at_high = f(high);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  double root = high;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    const double at_middle = f(middle);
    if (at_middle == 0) return middle;
    const double left = at_low / at_middle, right = at_high / at_middle;
    const double step = (middle - low) * (left > right ? 1 : -1) / std::sqrt(1 - left * right);
    const double guess = std::isfinite(step) ? std::clamp(middle + step, low, high) : middle;
    const double at_guess = f(guess);
    if (at_guess == 0) return guess;
    const bool settled = std::abs(guess - root) <= 1e-16 * std::abs(guess);
    root = guess;
    if (settled) break;
    // The narrowest of the four points' brackets.
    if ((at_middle > 0) != (at_guess > 0)) {
      const bool rising = middle < guess;
      low = rising ? middle : guess;
      high = rising ? guess : middle;
      at_low = rising ? at_middle : at_guess;
      at_high = rising ? at_guess : at_middle;
    } else if ((at_low > 0) != (at_guess > 0)) {
      high = std::min(guess, middle);
      at_high = guess < middle ? at_guess : at_middle;
    } else {
      low = std::max(guess, middle);
      at_low = guess > middle ? at_guess : at_middle;
    }
  }
  return root;
}

}  // namespace percuss::model
