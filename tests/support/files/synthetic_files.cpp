#include "support/files/synthetic_files.hpp"

#include "acquire/write_record.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::test {

std::string small_spec(const std::string& more) {
  return R"({"fs_hz": 4096, "samples": 4096, "band_hz": [60, 1000], "pretrigger_s": 0.05,
             "modes": [{"frequency_hz": 200, "damping_ratio": 0.01, "family": "bending", "residue_per_kg": [0.9, 0.3]},
                       {"frequency_hz": 700, "damping_ratio": 0.005, "family": "hoop", "residue_per_kg": [0.8, -0.8]}],
             "sensors": [{"position_m": 0.05, "angle_deg": 0}, {"position_m": 0.05, "angle_deg": 90}],
             "impact": {"position_m": 0.15, "angle_deg": 20}, "noise": {"force": 1e-4, "accel": 1e-3},
             "pulse": {"width_s": 0.001}, )" +
         more + "}";
}

void write_small_test(const std::string& path, const std::string& more) {
  const auto made = synth::synthesise(synth::parse_synth_spec(small_spec(more), "the small test"));
  acquire::write_record(path, made.record, true);
}

}  // namespace percuss::test
