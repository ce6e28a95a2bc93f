#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "synth/spec.hpp"

namespace percuss::synth {
namespace {

constexpr double kMaxAngle_deg = 5700;   // 100 rad
constexpr double kMaxValues = 1U << 28;  // samples of all signals together: 2 GiB
constexpr double kLarge = 1e12;          // beyond any force, acceleration or ratio of a hammer test

// A spec and its name in messages.
class Checker {
 public:
  Checker(const SynthSpec& spec, std::string_view where) : spec_(spec), where_(where) {}
  void size() const;
  void structure() const;
  void places() const;
  void hits() const;
  void recorder() const;

 private:
  void require(bool ok, const std::string& problem, const std::string& key, const std::string& remedy) const {
    if (!ok) throw InputError(problem, fmt::format("{}, {}", where_, key), remedy);
  }
  // low <= value <= high; NaN fails.
  void in_range(double value, double low, double high, const std::string& key) const {
    require(value >= low && value <= high, fmt::format("{:g} is out of range", value), key,
            fmt::format("give {:g} to {:g}", low, high));
  }
  void count_in_range(std::size_t value, std::size_t low, std::size_t high, const std::string& key) const {
    require(value >= low && value <= high, fmt::format("{} is out of range", value), key,
            fmt::format("give {} to {}", low, high));
  }
  void residues(const std::vector<double>& values, const std::string& key) const;

  const SynthSpec& spec_;
  std::string where_;
};

void Checker::size() const {
  in_range(spec_.fs_Hz, 1, 1e8, "fs_hz");
  count_in_range(spec_.samples, 16, std::size_t{1} << 28, "samples");
  count_in_range(spec_.points.size(), 1, 10000, "number of impact points");
  count_in_range(spec_.sensors.size(), 1, 256, "number of sensors");
  count_in_range(spec_.hits, 1, 10000, "hits");
  count_in_range(spec_.runs, 1, 10000, "runs");
  count_in_range(spec_.modes.size(), 0, 200, "number of modes");
  const bool rows = spec_.layout == SynthLayout::rows;
  const double hits = rows ? static_cast<double>(spec_.hits) * static_cast<double>(spec_.points.size()) : 1;
  const double values = static_cast<double>(spec_.samples) * static_cast<double>(spec_.sensors.size() + 1) *
                        static_cast<double>(spec_.runs) * hits;
  require(values <= kMaxValues, fmt::format("the record would hold {:g} samples", values),
          "samples × signals × hits × points × runs",
          fmt::format("reduce one of them: at most {:g} in all", kMaxValues));
}

void Checker::residues(const std::vector<double>& values, const std::string& key) const {
  const std::size_t wanted = spec_.points.size() * spec_.sensors.size();
  require(values.empty() || values.size() == wanted, fmt::format("{} numbers", values.size()), key,
          fmt::format("give one per impact point and sensor, {} in all", wanted));
  for (const double v : values) in_range(v, -kLarge, kLarge, key);
}

void Checker::structure() const {
  const SynthStructure& s = spec_.structure;
  in_range(s.length_m, 1e-3, 100, "structure.length_m");
  in_range(s.barrel_m, 1e-3, s.length_m, "structure.barrel_m");
  in_range(s.radius_m, 1e-6, 100, "structure.radius_m");
  in_range(s.mass_kg, 1e-6, 1e9, "structure.mass_kg");
  in_range(s.inertia_kgm2, 1e-9, 1e12, "structure.inertia_kgm2");
  in_range(s.cm_m, 0, s.length_m, "structure.cm_m");
  residues(s.rigid_line_per_kg, "structure.rigid_line_per_kg");
  for (std::size_t i = 0; i < spec_.modes.size(); ++i) {
    const SynthMode& m = spec_.modes[i];
    const std::string key = fmt::format("modes[{}].", i);
    in_range(m.freq_Hz, 1e-6 * spec_.fs_Hz, spec_.fs_Hz, key + "frequency_hz");
    in_range(m.damping_ratio, 1e-6, 0.5, key + "damping_ratio");
    in_range(m.order, 1, 50, key + "order");
    in_range(m.angle_rad / kDegree_rad, -kMaxAngle_deg, kMaxAngle_deg, key + "angle_deg");
    in_range(m.amplitude_per_sqrt_kg, -1e6, 1e6, key + "amplitude_per_sqrt_kg");
    residues(m.residue_per_kg, key + "residue_per_kg");
  }
}

void Checker::places() const {
  for (std::size_t i = 0; i < spec_.sensors.size(); ++i) {
    const SynthSensor& s = spec_.sensors[i];
    const std::string key = fmt::format("sensors[{}].", i);
    in_range(s.position_m, 0, spec_.structure.length_m, key + "position_m");
    in_range(s.angle_rad / kDegree_rad, -kMaxAngle_deg, kMaxAngle_deg, key + "angle_deg");
    require(std::abs(s.sign) == 1, fmt::format("{:g} is not a sign", s.sign), key + "sign", "give 1 or -1");
    in_range(s.gain, 1e-9, 1e9, key + "gain");
  }
  for (std::size_t i = 0; i < spec_.points.size(); ++i) {
    const std::string key = fmt::format("impact[{}].", i);
    in_range(spec_.points[i].position_m, 0, spec_.structure.length_m, key + "position_m");
    in_range(spec_.points[i].angle_rad / kDegree_rad, -kMaxAngle_deg, kMaxAngle_deg, key + "angle_deg");
    const std::vector<double>& xyz_m = spec_.points[i].xyz_m;
    require(xyz_m.empty() || xyz_m.size() == 3, "not three coordinates", key + "xyz_m", "give [x, y, z] in m");
    for (const double x : xyz_m) in_range(x, -100, 100, key + "xyz_m");
  }
}

void Checker::hits() const {
  const double duration_s = static_cast<double>(spec_.samples) / spec_.fs_Hz;
  in_range(spec_.pulse.width_s, 0.01 / spec_.fs_Hz, 4096 / spec_.fs_Hz, "pulse.width_s");
  in_range(spec_.pulse.peak_N, 1e-9, 1e9, "pulse.peak_n");
  in_range(spec_.pulse.width_spread, 0, 0.9, "pulse.width_spread");
  in_range(spec_.pulse.peak_spread, 0, 0.9, "pulse.peak_spread");
  in_range(spec_.pretrigger_s, -duration_s, duration_s, "pretrigger_s");
  in_range(spec_.onset_spread_s, 0, duration_s, "onset_spread_s");
  in_range(spec_.band_low_Hz, 0, spec_.fs_Hz / 2, "band_hz[0]");
  in_range(spec_.band_high_Hz, spec_.band_low_Hz, spec_.fs_Hz / 2, "band_hz[1]");
  const bool continuous = spec_.layout == SynthLayout::continuous;
  require(continuous || spec_.hit_times_s.empty(), "hit_times_s with one hit per row", "hit_times_s",
          "set layout to continuous, or give pretrigger_s instead");
  require(!continuous || spec_.points.size() == 1, "several impact points in one continuous row", "impact",
          "set layout to rows, or give one point");
  require(spec_.hit_times_s.empty() || spec_.hit_times_s.size() == spec_.hits,
          fmt::format("{} hits but {} times", spec_.hits, spec_.hit_times_s.size()), "hit_times_s",
          "give one time per hit");
  for (std::size_t i = 0; i < spec_.hit_times_s.size(); ++i) {
    in_range(spec_.hit_times_s[i], i > 0 ? spec_.hit_times_s[i - 1] : 0, duration_s, fmt::format("hit_times_s[{}]", i));
  }
}

void Checker::recorder() const {
  const SynthRecorder& r = spec_.recorder;
  in_range(spec_.noise.force, 0, 10, "noise.force");
  in_range(spec_.noise.accel, 0, 1000, "noise.accel");
  in_range(r.force_gain, 1e-9, 1e9, "recorder.force_gain");
  in_range(r.force_bias_N, -kLarge, kLarge, "recorder.force_bias_n");
  in_range(r.accel_bias_mps2, -kLarge, kLarge, "recorder.accel_bias_mps2");
  in_range(r.accel_drift_mps2_per_s, -kLarge, kLarge, "recorder.accel_drift_mps2_per_s");
  in_range(r.bits, 0, 32, "recorder.bits");
  in_range(r.force_clip_N.value_or(1), 1e-12, kLarge, "recorder.force_clip_n");
  in_range(r.accel_clip_mps2.value_or(1), 1e-12, kLarge, "recorder.accel_clip_mps2");
  in_range(r.force_range_N.value_or(1), 1e-12, kLarge, "recorder.force_range_n");
  in_range(r.accel_range_mps2.value_or(1), 1e-12, kLarge, "recorder.accel_range_mps2");
  require(r.bits > 0 || (!r.force_range_N && !r.accel_range_mps2), "a range without bits", "recorder",
          "give bits, or force_clip_n and accel_clip_mps2");
  for (std::size_t i = 0; i < spec_.faults.size(); ++i) {
    const SynthFault& f = spec_.faults[i];
    const std::string key = fmt::format("faults[{}].", i);
    count_in_range(f.hit, 0, spec_.hits * spec_.points.size() - 1, key + "hit");
    in_range(f.ratio, 1e-9, 100, key + "ratio");
    in_range(f.delay_s, 0, static_cast<double>(spec_.samples) / spec_.fs_Hz, key + "delay_s");
    require(f.kind != SynthFaultKind::late || spec_.layout == SynthLayout::rows,
            "a late trigger in a continuous record", key + "kind", "set layout to rows, or leave the fault out");
  }
}

}  // namespace

void validate(const SynthSpec& spec, std::string_view where) {
  const Checker checker(spec, where);
  checker.size();
  checker.structure();
  checker.places();
  checker.hits();
  checker.recorder();
}

}  // namespace percuss::synth
