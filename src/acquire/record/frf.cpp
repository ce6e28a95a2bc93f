#include "acquire/record/frf.hpp"

#include "core/units.hpp"

namespace percuss::acquire {

Frf lines_within(const Frf& all, std::size_t first, std::size_t count) {
  return {.value = lines_within(all.value, first, count),
          .std = lines_within(all.std, first, count),
          .coherence = lines_within(all.coherence, first, count),
          .averages = all.averages};
}

const char* name_of(FrfKind kind) {
  switch (kind) {
    case FrfKind::accelerance:
      return "accelerance";
    case FrfKind::mobility:
      return "mobility";
    case FrfKind::receptance:
      return "receptance";
  }
  return "";
}

const char* unit_of(FrfKind kind) {
  switch (kind) {
    case FrfKind::accelerance:
      return "(m/s^2)/N";
    case FrfKind::mobility:
      return "(m/s)/N";
    case FrfKind::receptance:
      return "m/N";
  }
  return "";
}

Frf converted(const Frf& accelerance, const LineRange& lines, FrfKind kind, double decay_per_s) {
  Frf out = accelerance;
  if (kind == FrfKind::accelerance) return out;
  for (std::size_t k = 0; k < out.value.size(); ++k) {
    const Complex s(decay_per_s, kTwoPi * lines.freq_Hz(k));
    const Complex divisor = kind == FrfKind::mobility ? s : s * s;
    out.value[k] = std::abs(divisor) > 0 ? out.value[k] / divisor : Complex{};
    if (!out.std.empty()) out.std[k] = std::abs(divisor) > 0 ? out.std[k] / std::abs(divisor) : 0;
  }
  return out;
}

}  // namespace percuss::acquire
