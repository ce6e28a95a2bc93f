#include "support/live/live_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::test {

LiveSource::LiveSource(const acquire::Record& record, std::size_t row) {
  format.device = "memory";
  format.fs_Hz = record.fs_Hz;
  format.channels = record.accel.size() + 1;
  format.names = {"force"};
  format.units = {"N"};
  const std::size_t frames = record.rows[row].samples;
  values.resize(frames * format.channels);
  std::vector<double> x(frames);
  const auto interleave = [&](std::size_t channel) {
    for (std::size_t i = 0; i < frames; ++i) values[i * format.channels + channel] = x[i];
  };
  record.read_force_N(row, 0, x);
  interleave(0);
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    format.names.push_back(fmt::format("accel {}", c + 1));
    format.units.emplace_back("m/s^2");
    record.read_accel_mps2(row, c, 0, x);
    interleave(c + 1);
  }
}

acquire::SampleBlock LiveSource::block(std::size_t first, std::size_t count) const {
  const std::size_t last = std::min(first + count, frames());
  acquire::SampleBlock out{.first_frame = first, .frames = last - first};
  out.values.assign(values.begin() + static_cast<std::ptrdiff_t>(first * format.channels),
                    values.begin() + static_cast<std::ptrdiff_t>(last * format.channels));
  return out;
}

acquire::Record struck_tube(const std::string& times_s, double duration_s, const std::string& more) {
  const auto hits = std::count(times_s.begin(), times_s.end(), ',') + 1;
  const std::string spec = fmt::format(
      R"({{"schema": "percuss/synth/1", "name": "tube", "fs_hz": {}, "duration_s": {}, "layout": "continuous",
      "hits": {}, "hit_times_s": [{}], "band_hz": [60, 1200],
      "modes": [{{"frequency_hz": 200, "damping_ratio": 0.012, "family": "bending", "order": 1, "angle_deg": 30}},
                {{"frequency_hz": 450, "damping_ratio": 0.008, "family": "bending", "order": 2, "angle_deg": 40}},
                {{"frequency_hz": 700, "damping_ratio": 0.006, "family": "hoop", "order": 1, "angle_deg": 10}}],
      "sensors": [{{"position_m": 0.05, "angle_deg": 0}}, {{"position_m": 0.05, "angle_deg": 90}}],
      "impact": {{"position_m": 0.15, "angle_deg": 20}},
      "pulse": {{"kind": "haversine", "width_s": 0.0008, "peak_n": 300}},
      "noise": {{"force": 0.0002, "accel": 0.002}}{}}})",
      kTubeRate_Hz, duration_s, hits, times_s, more.empty() ? "" : ", " + more);
  return synth::synthesise(synth::parse_synth_spec(spec, "test")).record;
}

}  // namespace percuss::test
