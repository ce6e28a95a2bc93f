#include "support/modal_frfs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "core/units.hpp"
#include "identify/noise/force_noise.hpp"
#include "synth/random_stream.hpp"

namespace percuss::test {
namespace {

// The row as one hit whose pulse covers the whole row.
acquire::Hit whole_row(const acquire::Record& record, std::size_t row) {
  const std::size_t samples = record.rows[row].samples;
  acquire::Hit hit{.row = row, .samples = samples, .gated_N = std::vector<double>(samples)};
  record.read_force_N(row, 0, hit.gated_N);
  return hit;
}

}  // namespace

identify::FrfDataset frf_set_of(const acquire::Record& record, double low_Hz, double high_Hz, double decay_per_s) {
  identify::FrfDataset set{.lines = frf::lines_in_band(record.fs_Hz, record.rows.front().samples, low_Hz, high_Hz)};
  std::map<int, std::vector<std::size_t>> points;
  for (std::size_t row = 0; row < record.rows.size(); ++row) points[record.rows[row].point].push_back(row);
  for (const auto& [point, rows] : points) {
    std::vector<frf::ForceBlock> blocks;
    std::vector<frf::Spectrum> force;
    for (const std::size_t row : rows) {
      blocks.push_back(frf::force_block(whole_row(record, row), record.fs_Hz, decay_per_s));
      force.push_back(make_spectrum(frf::force_spectrum(blocks.back(), set.lines)));
    }
    for (std::size_t c = 0; c < record.accel.size(); ++c) {
      std::vector<Complex> h(set.lines.count);
      std::vector<double> power(set.lines.count);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<double> x(set.lines.samples);
        record.read_accel_mps2(rows[i], c, 0, x);
        const auto a = frf::accel_spectrum(whole_row(record, rows[i]), x, set.lines, decay_per_s);
        for (std::size_t k = 0; k < h.size(); ++k) {
          h[k] += std::conj(force[i].get()[k]) * a[k];
          power[k] += std::norm(force[i].get()[k]);
        }
      }
      for (std::size_t k = 0; k < h.size(); ++k) h[k] /= power[k];
      set.channels.push_back({.point = set.points.size(), .channel = c, .frf = h});
    }
    set.points.push_back(identify::point_force(blocks, force, set.lines, 0));
  }
  return set;
}

frf::Spectrum make_spectrum(std::vector<Complex> lines) {
  const auto owner = std::make_shared<const std::vector<Complex>>(std::move(lines));
  return {owner, owner->data()};
}

identify::FrfDataset empty_set(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz, std::size_t channels) {
  identify::FrfDataset set{.lines = frf::lines_in_band(fs_Hz, samples, low_Hz, high_Hz)};
  const frf::Spectrum flat = make_spectrum(std::vector<Complex>(set.lines.count, Complex(1, 0)));
  set.points.push_back(identify::point_force({{.force_N = {1}}}, {flat}, set.lines, 0));
  for (std::size_t c = 0; c < channels; ++c)
    set.channels.push_back({.point = 0, .channel = c, .frf = std::vector<Complex>(set.lines.count)});
  return set;
}

Complex mode_accelerance(const identify::Pole& pole, Complex s) {
  const double omega = kTwoPi * pole.freq_Hz;
  return s * s / (s * s + 2 * pole.damping_ratio * omega * s + omega * omega);
}

Complex exact_at(const synth::Truth& truth, Complex s, std::size_t channel) {
  Complex h = truth.rigid_per_kg[0][channel];
  for (std::size_t m = 0; m < truth.spec.modes.size(); ++m) {
    const synth::SynthMode& mode = truth.spec.modes[m];
    h += truth.residue_per_kg[0][channel][m] *
         mode_accelerance({.freq_Hz = mode.freq_Hz, .damping_ratio = mode.damping_ratio}, s);
  }
  return h;
}

void add_mode(identify::FrfDataset& set, std::size_t channel, const identify::Pole& pole, Complex residue) {
  for (std::size_t k = 0; k < set.lines.count; ++k)
    set.channels[channel].frf[k] += residue * mode_accelerance(pole, Complex(0, kTwoPi * set.lines.freq_Hz(k)));
}

void add_frf_noise(identify::FrfDataset& set, double deviation, std::uint64_t seed) {
  for (std::size_t c = 0; c < set.channels.size(); ++c) {
    std::vector<double> noise(2 * set.lines.count);
    synth::RandomStream({seed, c}).add_normal(deviation, noise);
    for (std::size_t k = 0; k < set.lines.count; ++k) set.channels[c].frf[k] += Complex(noise[2 * k], noise[2 * k + 1]);
  }
}

identify::FrfDataset frfs_of_changing_mode() {
  identify::FrfDataset set = empty_set(4096, 32768, 250, 650, 1);
  for (int part = 0; part < 40; ++part)
    add_mode(set, 0, {500 + 0.1 * part, 0.01}, Complex(0.02, part % 3 == 0 ? 0.01 : 0));
  add_mode(set, 0, {320, 0.008}, Complex(0.5, 0.2));
  add_frf_noise(set, 1e-3, 4);
  return set;
}

void set_gated_pulse(identify::FrfDataset& set, double noise_N) {
  frf::ForceBlock block{.offset = 100, .force_N = std::vector<double>(90), .ungated_N = {}};
  for (std::size_t n = 0; n < 9; ++n) block.force_N[40 + n] = std::sin(kTwoPi * (static_cast<double>(n) + 0.5) / 18);
  const frf::Spectrum spectrum = make_spectrum(frf::force_spectrum(block, set.lines));
  set.points[0] = identify::point_force({block}, {spectrum}, set.lines, noise_N);
}

void add_random_gain(identify::FrfDataset& set, std::uint64_t seed) {
  std::vector<std::size_t> lines(set.lines.count);
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  const Eigen::MatrixXcd errors = identify::gain_errors(set, 0, lines);
  std::vector<double> draw(static_cast<std::size_t>(errors.cols()));
  synth::RandomStream({seed, 1}).add_normal(1, draw);
  const Eigen::VectorXcd gain = errors * Eigen::Map<const Eigen::VectorXd>(draw.data(), errors.cols());
  for (identify::FrfChannel& channel : set.channels) {
    for (const std::size_t k : lines) channel.frf[k] *= 1.0 + gain(static_cast<Eigen::Index>(k));
  }
}

std::vector<Eigen::VectorXcd> frf_vectors(const identify::FrfDataset& set) {
  std::vector<Eigen::VectorXcd> out;
  const auto lines = static_cast<Eigen::Index>(set.lines.count);
  for (const identify::FrfChannel& channel : set.channels)
    out.emplace_back(Eigen::Map<const Eigen::VectorXcd>(channel.frf.data(), lines));
  return out;
}

Eigen::VectorXcd vector_of(const std::vector<Complex>& lines) {
  return Eigen::Map<const Eigen::VectorXcd>(lines.data(), static_cast<Eigen::Index>(lines.size()));
}

double largest(const Eigen::VectorXcd& lines) { return lines.cwiseAbs().maxCoeff(); }

void expect_modes_near(const std::vector<identify::Mode>& found, const std::vector<identify::Pole>& truth) {
  ASSERT_EQ(found.size(), truth.size());
  for (std::size_t m = 0; m < truth.size(); ++m) {
    EXPECT_LE(std::abs(found[m].pole.freq_Hz - truth[m].freq_Hz), kModeDeviations * found[m].freq_std_Hz) << m;
    EXPECT_LE(std::abs(found[m].pole.damping_ratio - truth[m].damping_ratio), kModeDeviations * found[m].damping_std)
        << m;
  }
}

synth::SynthSpec bat_spec(std::vector<synth::SynthMode> modes, double duration_s) {
  synth::SynthSpec spec;
  spec.fs_Hz = 8192;
  spec.samples = static_cast<std::size_t>(duration_s * spec.fs_Hz);
  spec.band_high_Hz = 2400;
  spec.modes = std::move(modes);
  spec.points = {{.angle_rad = 0.35}};
  spec.pretrigger_s = 0.02;
  spec.hits = 3;
  return spec;
}

synth::SynthSpec bending_and_hoop_spec(double duration_s) {
  synth::SynthSpec spec = bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                                    {.freq_Hz = 1900,
                                     .damping_ratio = 0.01,
                                     .type = synth::SynthModeType::hoop,
                                     .order = 1,
                                     .amplitude_per_sqrt_kg = 2.4}},
                                   duration_s);
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

synth::SynthSpec truncated_bat_spec() {
  return bat_spec({{.freq_Hz = 120, .damping_ratio = 0.004, .residue_per_kg = {1.1, -0.4}},
                   {.freq_Hz = 640, .damping_ratio = 0.006, .residue_per_kg = {0.5, 0.9}},
                   {.freq_Hz = 1500, .damping_ratio = 0.02, .residue_per_kg = {-0.7, 0.2}}},
                  0.35);
}

synth::SynthSpec roving_beam_spec(double first_in, double step_in, int points) {
  synth::SynthSpec spec;
  spec.fs_Hz = 4096;
  spec.samples = 4096;
  spec.band_high_Hz = 1000;
  spec.sensors = {{}};
  spec.hits = 1;
  spec.pulse.width_s = 0.001;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  spec.points.clear();
  spec.modes = {{.freq_Hz = 200, .damping_ratio = 0.01}};
  for (int i = 0; i < points; ++i) {
    const double position_in = first_in + step_in * i;
    spec.points.push_back({.position_m = position_in * kInch_m});
    spec.modes[0].residue_per_kg.push_back(7.5 - position_in);
    spec.structure.rigid_line_per_kg.push_back(1.1);
  }
  return spec;
}

}  // namespace percuss::test
