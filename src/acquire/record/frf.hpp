#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/line_range.hpp"
#include "core/math/fft.hpp"

namespace percuss::acquire {

/// The largest number of averages that a file may state.
inline constexpr double kMaxAverages = 1e9;

/// The accelerance between one impact point and one response channel, averaged over hits.
struct Frf {
  std::vector<Complex> value;     // (m/s²)/N
  std::vector<double> std;        // rms of |value − truth|, from the scatter over hits, (m/s²)/N; empty for one hit
  std::vector<double> coherence;  // ordinary, 0 … 1; empty for one hit
  std::size_t averages = 0;
};

/// `count` values of an array with a value per line, from the one at `first` on; none of an empty array.
/// Precondition: first + count ≤ size, or the array is empty.
template <class Value>
std::vector<Value> lines_within(const std::vector<Value>& all, std::size_t first, std::size_t count) {
  if (all.empty()) return {};
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}
/// These lines of an FRF. Precondition: as above.
Frf lines_within(const Frf& all, std::size_t first, std::size_t count);

enum class FrfKind { accelerance, mobility, receptance };

const char* name_of(FrfKind kind);
/// (m/s^2)/N, (m/s)/N, m/N
const char* unit_of(FrfKind kind);

/// Accelerance as mobility (÷ jω) or receptance (÷ (jω)²); value and standard deviation alike. With an exponential
/// window of decay σ the values are the FRF at s = jω + σ, and the divisor is s or s². The line at s = 0 becomes 0.
/// theory (2.10)
Frf converted(const Frf& accelerance, const LineRange& lines, FrfKind kind, double decay_per_s = 0);

}  // namespace percuss::acquire
