#include "synth/synthesise.hpp"

#include <algorithm>
#include <cmath>

#include "core/budget.hpp"
#include "core/parallel/parallel.hpp"
#include "synth/cramer_rao_bound.hpp"
#include "synth/recorder.hpp"
#include "synth/schedule.hpp"
#include "synth/structure.hpp"

namespace percuss::synth {
namespace {

Truth planned_truth(const SynthSpec& spec) {
  Truth truth;
  truth.spec = spec;
  truth.hits = schedule_hits(spec);
  for (std::size_t p = 0; p < spec.points.size(); ++p) {
    truth.residue_per_kg.emplace_back();
    truth.rigid_per_kg.emplace_back();
    for (std::size_t c = 0; c < spec.sensors.size(); ++c) {
      truth.rigid_per_kg[p].push_back(rigid_line_per_kg(spec, p, c));
      truth.residue_per_kg[p].emplace_back();
      for (std::size_t r = 0; r < spec.modes.size(); ++r)
        truth.residue_per_kg[p][c].push_back(residue_per_kg(spec, r, p, c));
    }
  }
  return truth;
}

// Adds the contribution of a hit to its row: the force with the gain of the recorder, and the accelerations by (1) of
// synthesise.hpp. The residues are per recorded force, so the gain of the force multiplies the accelerations too.
void add_hit(const Truth& truth, const TrueHit& hit, std::vector<double>& force_N,
             std::vector<std::vector<double>>& accel_mps2) {
  const SynthSpec& spec = truth.spec;
  std::vector<SynthPole> poles;
  for (const SynthMode& mode : spec.modes) poles.push_back({mode.freq_Hz, mode.damping_ratio});
  const auto add = [](const std::vector<double>& values, double scale, std::size_t first, std::vector<double>& to) {
    for (std::size_t i = 0; i < values.size(); ++i) to[first + i] += scale * values[i];
  };
  for (const Pulse& pulse : pulses_of(spec, hit)) {
    const PulseBasis basis = pulse_basis(pulse, spec.fs_Hz, poles, 0, spec.samples);
    const double gain = spec.recorder.force_gain;
    add(basis.force_N, hit.reversed ? -gain : gain, basis.first, force_N);
    for (std::size_t c = 0; c < accel_mps2.size(); ++c) {
      check_budget();
      double direct = truth.rigid_per_kg[hit.point][c];
      for (std::size_t r = 0; r < poles.size(); ++r) {
        const double residue = truth.residue_per_kg[hit.point][c][r];
        direct += residue;
        add(basis.regular_N[r], residue * gain, basis.first, accel_mps2[c]);
      }
      add(basis.force_N, direct * gain, basis.first, accel_mps2[c]);
    }
  }
}

SynthSamples clean_run(const Truth& truth, std::size_t threads) {
  const SynthSpec& spec = truth.spec;
  const std::size_t rows = rows_per_run(spec);
  SynthSamples out{std::vector<std::vector<double>>(rows), std::vector<std::vector<std::vector<double>>>(rows)};
  parallel_for(rows, threads, [&](std::size_t row) {
    out.force_N[row].assign(spec.samples, 0);
    out.accel_mps2[row].assign(spec.sensors.size(), std::vector<double>(spec.samples, 0));
    for (const TrueHit& hit : truth.hits) {
      if (hit.row == row) add_hit(truth, hit, out.force_N[row], out.accel_mps2[row]);
    }
  });
  return out;
}

void set_noise_levels(const SynthSamples& clean, Truth& truth) {
  double peak_N = 0;
  for (const auto& row : clean.force_N) {
    for (const double f : row) peak_N = std::max(peak_N, std::abs(f));
  }
  truth.force_noise_N = truth.spec.noise.force * peak_N;
  for (std::size_t c = 0; c < truth.spec.sensors.size(); ++c) {
    double squares = 0;
    for (const auto& row : clean.accel_mps2) {
      for (const double a : row[c]) squares += a * a;
    }
    const auto count = static_cast<double>(clean.accel_mps2.size() * truth.spec.samples);
    truth.accel_clean_rms_mps2.push_back(std::sqrt(squares / count));
    truth.accel_noise_mps2.push_back(truth.spec.noise.accel * truth.accel_clean_rms_mps2.back());
  }
}

// Repeats the clean run, each time with its own noise.
SynthSamples recorded_runs(SynthSamples clean, const Truth& truth, const RecorderRange& range, std::size_t threads) {
  const std::size_t rows = clean.force_N.size();
  SynthSamples out = std::move(clean);
  for (std::size_t row = rows; row < rows * truth.spec.runs; ++row) {
    out.force_N.push_back(out.force_N[row - rows]);
    out.accel_mps2.push_back(out.accel_mps2[row - rows]);
  }
  parallel_for(out.force_N.size(), threads,
               [&](std::size_t row) { record_row(truth, range, row, out.force_N[row], out.accel_mps2[row]); });
  return out;
}

acquire::Record record_of(const Truth& truth, SynthSamples samples) {
  const SynthSpec& spec = truth.spec;
  const std::size_t rows = rows_per_run(spec);
  acquire::Record record =
      acquire::record_in_memory(spec.fs_Hz, std::move(samples.force_N), std::move(samples.accel_mps2));
  record.format = "synthetic";
  record.continuous = spec.layout == SynthLayout::continuous;
  record.force.unit = "N";
  for (std::size_t c = 0; c < spec.sensors.size(); ++c) {
    record.accel[c].angle_rad = spec.sensors[c].angle_rad;
    record.accel[c].position_m = spec.sensors[c].position_m;
  }
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    record.rows[row].run = static_cast<int>(row / rows);
    record.rows[row].point = record.continuous ? 0 : static_cast<int>(truth.hits[row % rows].point);
  }
  if (spec.points.size() < 2) return record;
  for (const SynthPoint& p : spec.points) {
    const double r = spec.structure.radius_m;
    record.geometry.push_back(
        p.xyz_m.empty() ? std::vector{p.position_m, r * std::cos(p.angle_rad), r * std::sin(p.angle_rad)} : p.xyz_m);
  }
  return record;
}

}  // namespace

SyntheticTest synthesise(const SynthSpec& spec, std::size_t threads) {
  validate(spec);
  Truth truth = planned_truth(spec);
  SynthSamples clean = clean_run(truth, threads);
  set_noise_levels(clean, truth);
  const RecorderRange range = recorder_range(spec.recorder, clean);
  const bool noisy =
      std::all_of(truth.accel_noise_mps2.begin(), truth.accel_noise_mps2.end(), [](double s) { return s > 0; });
  if (noisy && !spec.modes.empty()) truth.bound = cramer_rao_bound(truth, threads);
  SynthSamples recorded = recorded_runs(std::move(clean), truth, range, threads);
  flag_clipped(range, recorded, spec.fs_Hz, truth.hits);
  return {record_of(truth, std::move(recorded)), std::move(truth)};
}

std::vector<Complex> exact_accelerance(const Truth& truth, std::size_t point, std::size_t channel,
                                       std::span<const double> freq_Hz) {
  std::vector<Complex> out;
  for (const double f : freq_Hz) {
    Complex h = truth.rigid_per_kg[point][channel];
    for (std::size_t r = 0; r < truth.spec.modes.size(); ++r) {
      const SynthMode& m = truth.spec.modes[r];
      h += truth.residue_per_kg[point][channel][r] * -f * f /
           Complex((m.freq_Hz - f) * (m.freq_Hz + f), 2 * m.damping_ratio * m.freq_Hz * f);
    }
    out.push_back(h);
  }
  return out;
}

}  // namespace percuss::synth
