#include "pipeline/stages/stated_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "acquire/channels/stored_frfs.hpp"
#include "core/math/fft.hpp"
#include "core/math/significance.hpp"
#include "core/units.hpp"
#include "pipeline/analysis.hpp"

// FRFs with stated standard deviations: the ± follow from the weights that the fit used and from the stated noise.
namespace percuss::pipeline::stated_noise_test {

constexpr identify::Pole kPole{.freq_Hz = 150, .damping_ratio = 0.008};
constexpr std::size_t kSeeds = 40;
// The RMS of 40 normal numbers is known to 11 %; the limits are three times as far.
constexpr double kMinRms = 0.67, kMaxRms = 1.33;
constexpr double kStudentRms = 1.29;  // of Student's t of five degrees of freedom: means of six hits

Complex accelerance(double freq_Hz) {
  const Complex s(0, kTwoPi * freq_Hz);
  const double omega = kTwoPi * kPole.freq_Hz;
  return s * s / (s * s + 2 * kPole.damping_ratio * omega * s + omega * omega);
}

// Channels with noise whose standard deviation, `relative` |H| + floor_of[c], is stated.
acquire::FrfRecord record_of(std::uint64_t seed, double relative, const std::vector<double>& floor_of) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  acquire::FrfRecord record;
  std::vector<double> freq_Hz;
  for (int k = 1; k <= 800; ++k) freq_Hz.push_back(0.5 * k);
  record.lines = acquire::lines_from_frequencies(freq_Hz, "test");
  for (std::size_t c = 0; c < floor_of.size(); ++c) {
    record.accel.push_back({.name = "accel"});
    acquire::Frf frf;
    for (const double f : freq_Hz) {
      const Complex h = accelerance(f);
      frf.std.push_back(relative * std::abs(h) + floor_of[c]);
      frf.value.push_back(h + frf.std.back() / std::sqrt(2.0) * Complex(normal(random), normal(random)));
    }
    record.frfs.push_back({.point = 0, .channel = c, .frf = std::move(frf)});
  }
  return record;
}

constexpr std::size_t kHits = 6;

// How the hits of an average differ: relative standard deviations.
struct HitScatter {
  double gain = 0, freq = 0;
  double second_gain = 0;  // of a second mode at 140 Hz, beside `gain`
  double residue = 1;      // of all hits
};

// The mean FRF of six hits with a white noise of 0.02 each, and its standard deviation from the scatter of the hits.
acquire::FrfRecord average_of_hits(std::uint64_t seed, const HitScatter& scatter) {
  constexpr double kNoise = 0.02, kSecond = 140.0 / 150;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  acquire::FrfRecord record = record_of(seed, 0, {kNoise});
  acquire::Frf& mean = record.frfs.front().frf;
  std::vector<std::vector<Complex>> hits(kHits);
  for (std::vector<Complex>& hit : hits) {
    const double gain = scatter.residue * (1 + scatter.gain * normal(random)), freq = 1 + scatter.freq * normal(random);
    const double second = scatter.second_gain > 0 ? gain + scatter.second_gain * normal(random) : 0;
    for (std::size_t k = 0; k < record.lines.count; ++k) {
      const Complex noise = kNoise / std::sqrt(2.0) * Complex(normal(random), normal(random));
      const double freq_Hz = record.lines.freq_Hz(k) / freq;
      hit.push_back(gain * accelerance(freq_Hz) + second * accelerance(freq_Hz / kSecond) + noise);
    }
  }
  for (std::size_t k = 0; k < record.lines.count; ++k) {
    Complex sum;
    for (const std::vector<Complex>& hit : hits) sum += hit[k];
    mean.value[k] = sum / static_cast<double>(kHits);
    double squares = 0, powers = 0;
    for (const std::vector<Complex>& hit : hits) {
      squares += std::norm(hit[k] - mean.value[k]);
      powers += std::norm(hit[k]);
    }
    mean.coherence.push_back(std::norm(sum) / (static_cast<double>(kHits) * powers));  // of hits of one force
    mean.std[k] = std::sqrt(squares / static_cast<double>(kHits * (kHits - 1)));
  }
  return record;
}

// The average as a file states it that holds a coherence, but no standard deviation; read with the number of hits.
acquire::FrfRecord read_average(std::uint64_t seed, const HitScatter& scatter, std::optional<std::size_t> averages) {
  acquire::StoredFrfs stored;
  stored.record = average_of_hits(seed, scatter);
  stored.kind = acquire::FrfKind::accelerance;
  for (acquire::PointFrf& one : stored.record.frfs)
    stored.frfs.push_back({.value = std::move(one.frf.value), .coherence = std::move(one.frf.coherence)});
  stored.record.frfs.clear();
  return acquire::to_accelerances(std::move(stored), {.averages = averages});
}

// FRFs whose force and response carried an exponential window that fell to `end` over the record of 2 s. The window
// also weighs the white noise of the response, whose spectral lines are then no longer independent.
acquire::FrfRecord windowed_record(std::uint64_t seed, double end) {
  constexpr double kNoise = 0.02;
  constexpr std::size_t kSamples = 1600;  // at 800 Hz
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  acquire::FrfRecord record = record_of(seed, 0, {kNoise});
  const double decay_per_s = -std::log(end) * record.lines.df_Hz(), omega = kTwoPi * kPole.freq_Hz;
  std::vector<double> noise(kSamples);
  for (std::size_t n = 0; n < kSamples; ++n)
    noise[n] = kNoise / std::sqrt(kSamples) * std::pow(end, static_cast<double>(n) / kSamples) * normal(random);
  const std::vector<Complex> noise_lines = real_dft(noise);
  for (std::size_t k = 0; k < record.lines.count; ++k) {
    const Complex s(decay_per_s, kTwoPi * record.lines.freq_Hz(k));
    record.frfs.front().frf.value[k] =
        s * s / (s * s + 2 * kPole.damping_ratio * omega * s + omega * omega) + noise_lines.at(record.lines.first + k);
  }
  record.frfs.front().frf.std.clear();
  return record;
}

struct Rms {
  double freq = 0, damping = 0, residue = 0;
};

template <typename RecordOfSeed>
Rms rms_over_seeds(const RecordOfSeed& record_of_seed, std::size_t modes = 1, double exponential_end = 0) {
  Rms rms;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Analysis analysis(record_of_seed(seed),
                            {.band_Hz = std::pair(100.0, 200.0), .exponential_end = exponential_end});
    EXPECT_EQ(analysis.modes().size(), modes) << seed;
    if (analysis.modes().empty()) continue;
    const identify::Mode& mode = analysis.modes().back();  // at kPole
    rms.freq += std::pow((mode.pole.freq_Hz - kPole.freq_Hz) / mode.freq_std_Hz, 2) / kSeeds;
    rms.damping += std::pow((mode.pole.damping_ratio - kPole.damping_ratio) / mode.damping_std, 2) / kSeeds;
    const identify::Residue& residue = mode.residues.front();
    const double residue_std = std::hypot(residue.std, residue.relative_std * std::abs(residue.value));
    rms.residue += std::pow((residue.value.real() - 1) / residue_std, 2) / kSeeds;
  }
  return {.freq = std::sqrt(rms.freq), .damping = std::sqrt(rms.damping), .residue = std::sqrt(rms.residue)};
}

double residue_of_point(int point) { return std::cos(1 + 0.2 * point); }

// FRFs of 10 points, some of them near a node.
acquire::FrfRecord survey_of_averages(std::uint64_t seed, double gain) {
  constexpr int kPoints = 10;
  acquire::FrfRecord record;
  for (int p = 0; p < kPoints; ++p) {
    const HitScatter scatter{.gain = gain, .residue = residue_of_point(p)};
    acquire::FrfRecord one = average_of_hits(1000 * seed + static_cast<std::uint64_t>(p), scatter);
    one.frfs.front().point = p;
    if (p == 0)
      record = std::move(one);
    else
      record.frfs.push_back(std::move(one.frfs.front()));
  }
  return record;
}

// Of the residues of all points of surveys.
double rms_of_survey_residues(double gain) {
  constexpr std::uint64_t kSurveys = 6;
  double sum = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= kSurveys; ++seed) {
    const Analysis analysis(survey_of_averages(seed, gain), {.band_Hz = std::pair(100.0, 200.0)});
    EXPECT_EQ(analysis.modes().size(), 1U) << seed;
    for (const identify::Residue& one : analysis.modes().front().residues) {
      const double std = std::hypot(one.std, one.relative_std * std::abs(one.value));
      sum += std::pow((one.value.real() - residue_of_point(static_cast<int>(one.point))) / std, 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

Rms rms_of_deviations(double relative, const std::vector<double>& floor_of) {
  return rms_over_seeds([&](std::uint64_t seed) { return record_of(seed, relative, floor_of); });
}

Rms rms_of_averages(const HitScatter& scatter) {
  return rms_over_seeds([&](std::uint64_t seed) { return average_of_hits(seed, scatter); },
                        scatter.second_gain > 0 ? 2 : 1);
}

void expect_true(const Rms& rms) {
  EXPECT_GT(rms.freq, kMinRms);
  EXPECT_LT(rms.freq, kMaxRms);
  EXPECT_GT(rms.damping, kMinRms);
  EXPECT_LT(rms.damping, kMaxRms);
}

TEST(StatedNoise, GivesTrueStandardDeviationsForEvenNoise) { expect_true(rms_of_deviations(0, {0.05})); }

// The lines of the resonance, which move the pole, are the noisy ones.
TEST(StatedNoise, GivesTrueStandardDeviationsForNoiseInProportionToTheFrf) {
  expect_true(rms_of_deviations(0.05, {0.002}));
}

// The fit weighs a channel by its residual, which shows the noise as well as the stated numbers do.
TEST(StatedNoise, GivesTrueStandardDeviationsForChannelsOfDifferentNoise) {
  expect_true(rms_of_deviations(0, {0.01, 0.5}));
}

TEST(StatedNoise, GivesTrueStandardDeviationsForAveragesOfEqualHits) { expect_true(rms_of_averages({})); }

// The same gain at all lines moves no pole. The residue has its error.
TEST(StatedNoise, CountsTheGainOfTheHitsForTheResidueAlone) {
  const Rms rms = rms_of_averages({.gain = 0.05});
  expect_true(rms);
  EXPECT_GT(rms.residue, kMinRms * kStudentRms);
  EXPECT_LT(rms.residue, kMaxRms * kStudentRms);
}

// A gain scatters the residue by 0.02. The lines of the average do not show it; its coherence does.
TEST(StatedNoise, TakesTheScatterOfTheHitsFromCoherenceAndStatedAverages) {
  const HitScatter scatter{.gain = 0.05};
  const Rms stated = rms_over_seeds([&](std::uint64_t seed) { return read_average(seed, scatter, kHits); });
  expect_true(stated);
  // The number of hits is known, so that the ± includes Student's factor.
  const double expected = kStudentRms / student_factor(kHits - 1);
  EXPECT_GT(stated.residue, kMinRms * expected);
  EXPECT_LT(stated.residue, kMaxRms * expected);
  const Rms unstated = rms_over_seeds([&](std::uint64_t seed) { return read_average(seed, scatter, {}); });
  EXPECT_GT(unstated.residue, 3 * kMaxRms);
}

TEST(StatedNoise, GivesTrueDampingUnderAStatedExponentialWindow) {
  constexpr double kEnd = 0.05;
  const auto record = [](std::uint64_t seed) { return windowed_record(seed, kEnd); };
  expect_true(rms_over_seeds(record, 1, kEnd));
  EXPECT_GT(rms_over_seeds(record).damping, 10) << "the window's damping";
}

// As by the place and direction of the hits.
TEST(StatedNoise, CountsModesThatScatterByTheirOwnGainsForTheResiduesAlone) {
  expect_true(rms_of_averages({.gain = 0.03, .second_gain = 0.03}));
}

// Each point has its own hits.
TEST(StatedNoise, CountsTheGainsOfASurveyForItsResiduesAlone) {
  expect_true(rms_over_seeds([](std::uint64_t seed) { return survey_of_averages(seed, 0.03); }));
}

// A gain of 0.1 % is three times the noise at the peak: an FRF alone seldom tells it from noise of its lines. All
// together do. Judged one by one, the errors are 2.5 times the ±.
TEST(StatedNoise, CountsGainsThatOnlyTheWholeSurveyShows) {
  const double rms = rms_of_survey_residues(1e-3);
  EXPECT_GT(rms, kMinRms * kStudentRms);
  EXPECT_LT(rms, kMaxRms * kStudentRms);
}

// Frequencies that differ by 1/40 of the half-power bandwidth from hit to hit: the error is that of their mean.
TEST(StatedNoise, SeesFrequenciesThatDifferBetweenTheHits) {
  const Rms rms = rms_of_averages({.gain = 0.01, .freq = 4e-4});
  EXPECT_GT(rms.freq, kMinRms * kStudentRms);
  EXPECT_LT(rms.freq, 1.97);  // squares of Student's t have a mean of 5/3, known from 40 to 0.74; three times as far
}

}  // namespace percuss::pipeline::stated_noise_test
