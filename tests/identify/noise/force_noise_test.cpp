#include "identify/noise/force_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::force_noise_test {

constexpr double kNoise_N = 0.02;

FrfDataset gated_hit() {
  FrfDataset set = test::empty_set(8192, 16384, 40, 2400, 1);
  test::set_gated_pulse(set, kNoise_N);
  return set;
}

std::vector<std::size_t> all_lines(const FrfDataset& set) {
  std::vector<std::size_t> lines(set.lines.count);
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  return lines;
}

TEST(GainErrors, HaveTheCovarianceOfTheNoiseInTheGate) {
  const FrfDataset set = gated_hit();
  const Eigen::MatrixXcd errors = gain_errors(set, 0, all_lines(set));
  // Independent reference: noise on every sample of the gate, transformed, over the force's spectrum.
  const frf::ForceBlock& block = set.points[0].blocks[0];
  const auto force = frf::force_spectrum(block, set.lines);
  constexpr int kTrials = 2000;
  const std::vector<Eigen::Index> lines{10, 400, 1500, 4000};
  Eigen::Matrix4cd measured = Eigen::Matrix4cd::Zero();
  // The pseudo-covariance E εεᵀ: real noise is not circular at low frequencies.
  Eigen::Matrix4cd pseudo = Eigen::Matrix4cd::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    frf::ForceBlock noise{
        .offset = block.offset, .force_N = std::vector<double>(block.force_N.size()), .ungated_N = {}};
    synth::RandomStream({7, static_cast<std::uint64_t>(trial)}).add_normal(kNoise_N, noise.force_N);
    const auto spectrum = frf::force_spectrum(noise, set.lines);
    Eigen::Vector4cd error;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const auto k = static_cast<std::size_t>(lines[static_cast<std::size_t>(i)]);
      error(i) = spectrum[k] / force[k];
    }
    measured += error * error.adjoint() / kTrials;
    pseudo += error * error.transpose() / kTrials;
  }
  Eigen::MatrixXcd picked(4, errors.cols());
  for (Eigen::Index i = 0; i < 4; ++i) picked.row(i) = errors.row(lines[static_cast<std::size_t>(i)]);
  const Eigen::Matrix4cd expected = picked * picked.adjoint();
  const Eigen::Matrix4cd expected_pseudo = picked * picked.transpose();
  // The tolerance of a covariance: 2000 trials scatter it by 2.2 %. The ringing that the gate cuts off is not in the
  // trials, and adds up to 4.4 % to the expected values.
  constexpr double kTolerance = 0.12;
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      const double size = std::sqrt(std::abs(expected(i, i) * expected(j, j)));
      EXPECT_LE(std::abs(measured(i, j) - expected(i, j)), kTolerance * size) << i << ' ' << j;
      EXPECT_LE(std::abs(pseudo(i, j) - expected_pseudo(i, j)), kTolerance * size) << i << ' ' << j;
    }
  }
}

TEST(GainErrors, AgreeWithTheStandardDeviationOfOneLine) {
  const FrfDataset set = gated_hit();
  const Eigen::MatrixXcd errors = gain_errors(set, 0, all_lines(set));
  const double variance = errors.row(4000).squaredNorm();  // of the complex error
  const double std = gain_std(set, 0, set.lines.freq_Hz(4000));
  EXPECT_LE(std::abs(variance / (2 * std * std) - 1), 1e-9);
}

// gated_hit() with a short gate: from four samples before the pulse to four samples after it.
FrfDataset briefly_gated_hit() {
  FrfDataset set = gated_hit();
  frf::ForceBlock block = set.points[0].blocks[0];
  block.offset += 36;
  block.force_N = {block.force_N.begin() + 36, block.force_N.begin() + 53};
  const frf::Spectrum spectrum = test::make_spectrum(frf::force_spectrum(block, set.lines));
  set.points[0] = point_force({block}, {spectrum}, set.lines, kNoise_N);
  return set;
}

// Root mean square of the real part of the error at lines, from noise on every sample of the gate.
std::vector<double> real_errors(const FrfDataset& set, const std::vector<std::size_t>& lines) {
  const frf::ForceBlock& block = set.points[0].blocks[0];
  const auto force = frf::force_spectrum(block, set.lines);
  constexpr int kTrials = 4000;
  std::vector<double> power(lines.size());
  for (int trial = 0; trial < kTrials; ++trial) {
    frf::ForceBlock noise{
        .offset = block.offset, .force_N = std::vector<double>(block.force_N.size()), .ungated_N = {}};
    synth::RandomStream({8, static_cast<std::uint64_t>(trial)}).add_normal(kNoise_N, noise.force_N);
    const auto spectrum = frf::force_spectrum(noise, set.lines);
    for (std::size_t i = 0; i < lines.size(); ++i)
      power[i] += std::pow((spectrum[lines[i]] / force[lines[i]]).real(), 2) / kTrials;
  }
  for (double& one : power) one = std::sqrt(one);
  return power;
}

TEST(GainAmplitude, HasTheStandardDeviationOfTheRealPart) {
  const std::vector<std::size_t> lines{10, 300, 1500, 4000};
  for (const FrfDataset& set : {gated_hit(), briefly_gated_hit()}) {
    const std::vector<double> measured = real_errors(set, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double freq_Hz = set.lines.freq_Hz(lines[i]);
      const double std = gain_amplitude_std(set, 0, freq_Hz);
      // 4000 trials scatter the standard deviation by 1.1 %. The ringing that the gate cuts off, which is not in the
      // trials, adds 2.2 % (90 samples) and 11 % (17 samples) to the expected value, and more near half the sampling
      // rate.
      EXPECT_GT(std, 0.965 * measured[i]) << freq_Hz;
      EXPECT_LT(std, (1.04 + 2.3 / static_cast<double>(set.points[0].blocks[0].force_N.size())) * measured[i])
          << freq_Hz;
    }
  }
}

TEST(GainAmplitude, HoldsNearlyAllOfTheErrorAtLowFrequencies) {
  const FrfDataset set = briefly_gated_hit();
  const double low_Hz = set.lines.freq_Hz(10);
  // gain_std() is √½ of the complex error. The factor would be √2 if the error were real.
  EXPECT_GT(gain_amplitude_std(set, 0, low_Hz), 1.38 * gain_std(set, 0, low_Hz));
}

// Four hits, of which the second has a gate in two parts: around the pulse, and around a second contact. The second
// part begins kLater = 420 samples after the first; its contact is 391 samples after the pulse. All samples within the
// parts carry noise, as measured ones do.
constexpr std::size_t kGate = 90, kLater = 420, kContact = 30;

std::vector<frf::ForceBlock> hits_with_second_contact() {
  const FrfDataset one = gated_hit();
  std::vector<frf::ForceBlock> blocks;
  for (const double peak_N : {1.0, 1.5, 0.7, 1.2}) {
    frf::ForceBlock block = one.points[0].blocks[0];
    for (double& force_N : block.force_N) force_N *= peak_N;
    synth::RandomStream({9, blocks.size()}).add_normal(1e-9, block.force_N);
    blocks.push_back(block);
  }
  std::vector<double>& twice = blocks[1].force_N;
  twice.resize(kLater);
  for (std::size_t n = 0; n < kContact; ++n) twice.push_back(0.02 * twice[29 + n]);
  return blocks;
}

// H1's relative error from noise in the gates of hits, at lines.
Eigen::VectorXcd h1_error(const FrfDataset& set, const std::vector<Eigen::Index>& lines, std::uint64_t trial) {
  const PointForce& force = set.points[0];
  Eigen::VectorXcd error = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(lines.size()));
  for (std::size_t h = 0; h < force.blocks.size(); ++h) {
    frf::ForceBlock noise = force.blocks[h];
    std::fill(noise.force_N.begin(), noise.force_N.end(), 0);
    synth::RandomStream({10, trial, h}).add_normal(kNoise_N, noise.force_N);
    if (noise.force_N.size() > kLater) std::fill_n(noise.force_N.begin() + kGate, kLater - kGate, 0);
    const auto spectrum = frf::force_spectrum(noise, set.lines);
    for (Eigen::Index i = 0; i < error.size(); ++i) {
      const auto k = static_cast<std::size_t>(lines[static_cast<std::size_t>(i)]);
      error(i) += std::conj(force.spectra[h].get()[k]) * spectrum[k] / force.ff[k];
    }
  }
  return error;
}

// The noise of a second contact gives H1 an error that varies over frequency the faster, the later the contact is, and
// whose size is the share of its hit.
TEST(GainErrors, HoldTheNoiseOfASecondContactAtItsDelay) {
  FrfDataset set = gated_hit();
  std::vector<frf::Spectrum> spectra;
  const auto blocks = hits_with_second_contact();
  spectra.reserve(blocks.size());
  for (const frf::ForceBlock& block : blocks)
    spectra.push_back(test::make_spectrum(frf::force_spectrum(block, set.lines)));
  set.points[0] = point_force(blocks, spectra, set.lines, kNoise_N);
  const std::vector<Eigen::Index> lines{400, 419, 438, 1500, 1519, 1538};
  constexpr int kTrials = 4000;
  Eigen::MatrixXcd measured = Eigen::MatrixXcd::Zero(6, 6);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::VectorXcd error = h1_error(set, lines, static_cast<std::uint64_t>(trial));
    measured += error * error.adjoint() / kTrials;
  }
  const Eigen::MatrixXcd errors = gain_errors(set, 0, all_lines(set), ForceErrors::noise);
  Eigen::MatrixXcd picked(6, errors.cols());
  for (Eigen::Index i = 0; i < 6; ++i) picked.row(i) = errors.row(lines[static_cast<std::size_t>(i)]);
  const Eigen::MatrixXcd expected = picked * picked.adjoint();
  // 4000 trials scatter the covariance by 1.6 %. The weights of the hits are those of the whole spectrum, and the
  // contact changes them by 2 % at single lines.
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      const double size = std::sqrt(std::abs(measured(i, i) * measured(j, j)));
      EXPECT_LE(std::abs(measured(i, j) - expected(i, j)), 0.07 * size) << i << ' ' << j;
    }
  }
  const Eigen::MatrixXcd all = gain_errors(set, 0, all_lines(set));
  const double std = gain_std(set, 0, set.lines.freq_Hz(4000));
  EXPECT_LE(std::abs(all.row(4000).squaredNorm() / (2 * std * std) - 1), 1e-9);
}

TEST(GainErrors, AreEmptyWithoutNoiseOrForce) {
  FrfDataset set = gated_hit();
  set.points[0].noise_N = 0;
  EXPECT_EQ(gain_errors(set, 0, {1, 2}).size(), 0);
  set.points[0].blocks.clear();
  EXPECT_EQ(gain_std(set, 0, 500), 0);
  EXPECT_EQ(gain_amplitude_std(set, 0, 500), 0);
  FrfDataset unknown = gated_hit();
  unknown.points[0].ff.clear();
  EXPECT_EQ(gain_errors(unknown, 0, {1, 2}).size(), 0);
  EXPECT_EQ(gain_std(unknown, 0, 500), 0);
}

}  // namespace percuss::identify::force_noise_test
