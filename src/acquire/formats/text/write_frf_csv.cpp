#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "acquire/formats/text/write_frf_csv.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// The numbers of averages: ", averages 5" where all FRFs have the same, else one for each.
std::string averages_text(const FrfRecord& record) {
  const auto& frfs = record.frfs;
  if (std::all_of(frfs.begin(), frfs.end(), [](const PointFrf& one) { return one.frf.averages == 0; })) return {};
  const bool same = std::all_of(frfs.begin(), frfs.end(),
                                [&](const PointFrf& one) { return one.frf.averages == frfs.front().frf.averages; });
  std::string out = ", averages";
  for (const PointFrf& one : std::span(frfs).first(same ? 1 : frfs.size())) out += fmt::format(" {}", one.frf.averages);
  return out;
}

// The sensors' angles, the decay of the window and the averages, for the first line: ", angle_deg 0 90, decay_per_s
// 4.6, averages 5".
std::string statements(const FrfRecord& record) {
  std::string out;
  const auto& accel = record.accel;
  const bool angles = std::all_of(accel.begin(), accel.end(), [](const SignalInfo& s) { return s.angle_rad; });
  if (angles) out += ", angle_deg";
  for (const SignalInfo& signal : accel) {
    if (angles) out += fmt::format(" {:.10g}", *signal.angle_rad * kRadian_deg);
  }
  if (record.decay_per_s > 0) out += fmt::format(", decay_per_s {}", record.decay_per_s);
  return out + averages_text(record);
}

}  // namespace

std::string frf_record_csv(const FrfRecord& record, FrfKind kind) {
  std::vector<Frf> shown;
  shown.reserve(record.frfs.size());
  for (const PointFrf& frf : record.frfs) shown.push_back(converted(frf.frf, record.lines, kind, record.decay_per_s));
  const std::string estimator = record.estimator.empty() ? "" : ", " + record.estimator;
  std::string out =
      fmt::format("# {} {}{}, exp(+jwt){}\nfrequency_hz", name_of(kind), unit_of(kind), estimator, statements(record));
  for (const PointFrf& frf : record.frfs) {
    for (const char* part : {"re", "im", "std", "coherence"})
      out += fmt::format(",p{}_c{}_{}", frf.point, frf.channel, part);
  }
  out += '\n';
  auto end = std::back_inserter(out);
  for (std::size_t k = 0; k < record.lines.count; ++k) {
    fmt::format_to(end, "{}", record.lines.freq_Hz(k));
    for (const Frf& frf : shown) {
      fmt::format_to(end, ",{},{}", frf.value[k].real(), frf.value[k].imag());
      for (const auto* companion : {&frf.std, &frf.coherence}) {
        out += ',';
        if (!companion->empty()) fmt::format_to(end, "{}", (*companion)[k]);
      }
    }
    out += '\n';
  }
  return out;
}

}  // namespace percuss::acquire
