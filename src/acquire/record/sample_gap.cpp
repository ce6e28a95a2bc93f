#include "acquire/record/sample_gap.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace percuss::acquire {

RecordFault fault_of(const SampleGap& gap, double fs_Hz) {
  return {.kind = FaultKind::missing_samples,
          .row = static_cast<int>(gap.row),
          .time_s = static_cast<double>(gap.first) / fs_Hz,
          .value = static_cast<double>(gap.count)};
}

std::vector<SampleGap> gaps_of(const Record& record) {
  std::vector<SampleGap> out;
  for (const RecordFault& fault : record.faults) {
    if (fault.kind != FaultKind::missing_samples || fault.row < 0) continue;
    const auto row = static_cast<std::size_t>(fault.row);
    const auto samples = static_cast<double>(record.rows[row].samples);
    const double first = std::round(fault.time_s * record.fs_Hz);
    if (!(first >= 0 && fault.value >= 1 && first + fault.value <= samples)) continue;
    out.push_back(
        {.row = row, .first = static_cast<std::size_t>(first), .count = static_cast<std::size_t>(fault.value)});
  }
  std::sort(out.begin(), out.end(), [](const SampleGap& a, const SampleGap& b) {
    return std::tuple(a.row, a.first) < std::tuple(b.row, b.first);
  });
  return out;
}

}  // namespace percuss::acquire
