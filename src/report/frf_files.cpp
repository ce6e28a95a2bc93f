#include "report/frf_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "acquire/atomic_file.hpp"
#include "core/units.hpp"

namespace percuss {
namespace {

// What a reader needs beside the numbers: ", angle_deg 0 90, decay_per_s 4.6".
std::string statements(const Analysis& analysis) {
  std::string out;
  const auto& accel = analysis.record().accel;
  const bool angles = std::all_of(accel.begin(), accel.end(), [](const SignalInfo& s) { return s.angle_rad; });
  if (angles) out += ", angle_deg";
  for (const SignalInfo& signal : accel) {
    if (angles) out += fmt::format(" {:.10g}", *signal.angle_rad * kRadian_deg);
  }
  if (analysis.window_decay_per_s() > 0) out += fmt::format(", decay_per_s {}", analysis.window_decay_per_s());
  return out;
}

}  // namespace

std::string frf_csv(const Analysis& analysis, FrfKind kind) {
  const auto& frfs = analysis.frfs();
  const LineRange& lines = analysis.lines();
  std::vector<Frf> shown;
  shown.reserve(frfs.size());
  for (const PointFrf& frf : frfs) shown.push_back(converted(frf.frf, lines, kind, analysis.window_decay_per_s()));
  std::string out = fmt::format("# {} {}, {}, exp(+jwt){}\nfrequency_hz", name_of(kind), unit_of(kind),
                                name_of(analysis.options().estimator), statements(analysis));
  for (const PointFrf& frf : frfs) {
    for (const char* part : {"re", "im", "std", "coherence"})
      out += fmt::format(",p{}_c{}_{}", frf.point, frf.channel, part);
  }
  out += '\n';
  const auto [low, high] = analysis.band_Hz();
  const double edge_Hz = 1e-6 * lines.df_Hz();
  auto end = std::back_inserter(out);
  for (std::size_t k = 0; k < lines.count; ++k) {
    const double freq_Hz = lines.freq_Hz(k);
    if (freq_Hz < low - edge_Hz || freq_Hz > high + edge_Hz) continue;
    fmt::format_to(end, "{}", freq_Hz);
    for (const Frf& frf : shown) {
      fmt::format_to(end, ",{},{}", frf.value[k].real(), frf.value[k].imag());
      if (frf.std.empty()) {
        out += ",,";
      } else {
        fmt::format_to(end, ",{},{}", frf.std[k], frf.coherence[k]);
      }
    }
    out += '\n';
  }
  return out;
}

void write_frf_csv(const std::string& path, const Analysis& analysis, FrfKind kind, bool force) {
  write_file(path, frf_csv(analysis, kind), force);
}

}  // namespace percuss
