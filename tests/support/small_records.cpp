#include "support/small_records.hpp"

#include <fmt/format.h>

#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::test {

SmallRecord small_record() {
  synth::SynthSpec spec{.fs_Hz = 4096, .samples = 2048};
  spec.modes = {{.freq_Hz = 200, .damping_ratio = 0.01, .residue_per_kg = {1.0}}};
  spec.structure.rigid_line_per_kg = {0.1};
  spec.sensors = {{}};
  spec.pulse.width_s = 1e-3;
  spec.hits = 1;
  spec.band_high_Hz = 1000;
  const acquire::Record record = synth::synthesise(spec).record;
  SmallRecord out;
  out.force_N.resize(spec.samples);
  out.accel_mps2.resize(spec.samples);
  record.read_force_N(0, 0, out.force_N);
  record.read_accel_mps2(0, 0, 0, out.accel_mps2);
  for (std::size_t i = 0; i < spec.samples; ++i) out.time_s.push_back(static_cast<double>(i) / spec.fs_Hz);
  return out;
}

void write_columns(const std::string& path, const std::string& header,
                   const std::vector<std::vector<double>>& columns) {
  std::string text = header.empty() ? "" : header + "\n";
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) text += fmt::format("{}{}", c > 0 ? "," : "", columns[c][i]);
    text += '\n';
  }
  write_bytes(path, text);
}

}  // namespace percuss::test
