#include <algorithm>
#include <array>
#include <set>

#include "acquire/formats/mat/mat_output.hpp"
#include "acquire/formats/mat/mat_sensors.hpp"
#include "acquire/formats/mat/write_frf_mat.hpp"

namespace percuss::acquire {
namespace {

// Appends get(frf, line) of every FRF, line by line, in MATLAB's order: points fastest, then channels, then lines.
template <class Get>
void append_lines(MatOutput& out, const std::vector<Frf>& frfs, std::size_t points, std::size_t channels,
                  std::size_t lines, Get&& get) {
  std::vector<double> line(points * channels);
  for (std::size_t k = 0; k < lines; ++k) {
    for (std::size_t p = 0; p < points; ++p) {
      for (std::size_t c = 0; c < channels; ++c) line[c * points + p] = get(frfs[p * channels + c], k);
    }
    out.append(line);
  }
}

}  // namespace

void write_frf_record_mat(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) {
  std::vector<Frf> shown;
  std::set<int> numbers;
  bool has_std = true, has_coherence = true;
  for (const PointFrf& frf : record.frfs) {
    shown.push_back(converted(frf.frf, record.lines, kind, record.decay_per_s));
    numbers.insert(frf.point);
    has_std = has_std && !frf.frf.std.empty();
    has_coherence = has_coherence && !frf.frf.coherence.empty();
  }
  const std::size_t points = numbers.size(), channels = record.accel.size(), lines = record.lines.count;
  const std::array shape{points, channels, lines};
  const auto append = [&](MatOutput& out, auto&& get) { append_lines(out, shown, points, channels, lines, get); };
  MatOutput out(path, force);
  out.begin("frequency_hz", std::array<std::size_t, 2>{1, lines});
  for (std::size_t k = 0; k < lines; ++k) {
    const double freq_Hz = record.lines.freq_Hz(k);
    out.append(std::span(&freq_Hz, 1));
  }
  out.begin("frf", shape, true);
  append(out, [](const Frf& frf, std::size_t k) { return frf.value[k].real(); });
  append(out, [](const Frf& frf, std::size_t k) { return frf.value[k].imag(); });
  if (has_std) out.begin("frf_std", shape);
  if (has_std) append(out, [](const Frf& frf, std::size_t k) { return frf.std[k]; });
  if (has_coherence) out.begin("coherence", shape);
  if (has_coherence) append(out, [](const Frf& frf, std::size_t k) { return frf.coherence[k]; });
  out.numbers("point", std::vector<double>(numbers.begin(), numbers.end()));
  write_mat_sensors(out, record.accel);
  if (record.decay_per_s > 0) out.number("decay_per_s", record.decay_per_s);
  out.text("kind", name_of(kind));
  out.text("unit", unit_of(kind));
  if (!record.estimator.empty()) out.text("estimator", record.estimator);
  std::size_t averages = shown.front().averages;
  for (const Frf& frf : shown) averages = std::min(averages, frf.averages);
  out.number("averages", static_cast<double>(averages));
  out.commit();
}

}  // namespace percuss::acquire
