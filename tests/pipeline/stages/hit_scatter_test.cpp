#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "pipeline/analysis.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::hit_scatter_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kFirst_Hz = 200, kSecond_Hz = 900;

struct Modes {
  double first_Hz = kFirst_Hz, second_Hz = kSecond_Hz, first_damping = 0.01, second_damping = 0.005;
};

synth::SynthSpec spec_of(const Modes& modes, std::size_t hits, std::uint64_t seed) {
  synth::SynthSpec spec = test::bat_spec(
      {{.freq_Hz = modes.first_Hz, .damping_ratio = modes.first_damping, .order = 1, .amplitude_per_sqrt_kg = 1.7},
       {.freq_Hz = modes.second_Hz, .damping_ratio = modes.second_damping, .order = 2, .amplitude_per_sqrt_kg = 1.4}},
      1);
  spec.hits = hits;
  spec.seed = seed;
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

// A test whose structure differs from hit to hit. The forces depend on the seed alone.
acquire::Record record_of(const std::function<Modes(std::size_t hit)>& modes, std::size_t hits, std::uint64_t seed) {
  std::vector<acquire::Record> records;
  for (std::size_t h = 0; h < hits; ++h) records.push_back(synth::synthesise(spec_of(modes(h), hits, seed)).record);
  acquire::Record record = records.front();
  record.read_accel_mps2 = [records](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    records[row].read_accel_mps2(row, channel, first, out);
  };
  return record;
}

AnalysisOptions band() { return {.band_Hz = std::pair{60.0, 1600.0}, .threads = 1}; }

// The frequency differs between the hits and follows neither the force nor the order; the ± of each hit's mode contains
// this scatter.
TEST(HitScatter, IsPartOfTheStandardDeviationsOfSingleHits) {
  constexpr std::array kOff{0.0, 1e-3, -1e-3, 2e-3, -2e-3};  // relative to the frequency; standard deviation 1.58e-3
  const auto modes = [&](std::size_t hit) { return Modes{.first_Hz = kFirst_Hz * (1 + kOff.at(hit))}; };
  const Analysis analysis(record_of(modes, kOff.size(), 1), band());
  ASSERT_THAT(analysis.modes_per_hit(), SizeIs(2 * kOff.size()));
  for (const HitMode& one : analysis.modes_per_hit()) {
    const HitStdParts& parts = one.freq_std_parts_Hz;
    EXPECT_EQ(parts.total(), std::hypot(parts.noise, parts.hits));
    if (one.mode == 0) {
      // Each fit follows its hit to a few standard deviations of the noise, here below 1e-5 of the frequency.
      EXPECT_NEAR(one.pole.freq_Hz, kFirst_Hz * (1 + kOff.at(one.hit)), 5 * parts.noise);
      // The estimate weights the hits by their noise, so it differs from the plain standard deviation.
      EXPECT_NEAR(parts.hits, 1.58e-3 * kFirst_Hz, 0.25 * 1.58e-3 * kFirst_Hz);
    } else {
      EXPECT_EQ(parts.hits, 0);
    }
  }
}

TEST(HitScatter, AddsNothingToEqualHits) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Analysis analysis(record_of([](std::size_t) { return Modes{}; }, 5, seed), band());
    ASSERT_THAT(analysis.modes(), SizeIs(2));
    for (const identify::Mode& mode : analysis.modes()) {
      EXPECT_EQ(mode.freq_std_parts_Hz.hits, 0) << seed;
      EXPECT_EQ(mode.freq_std_parts_Hz.misfit, 0) << seed;
      EXPECT_EQ(mode.freq_std_Hz, mode.freq_std_parts_Hz.noise) << seed;
      EXPECT_EQ(mode.damping_std, mode.damping_std_parts.noise) << seed;
      EXPECT_FALSE(mode.amplitude || mode.drift);
    }
    EXPECT_THAT(test::lines_of_messages(analysis.warnings()), IsEmpty());
  }
}

// The responses of each hit are multiplied by the hit's own factor, as for hits beside the point. The average of the
// hits scatters as the ± states: for 5 hits, Student's factor makes the mean square of error over ± about 1. The limits
// are wide because a square of Student's t with 4 degrees of freedom has no finite variance.
TEST(HitScatter, IsPartOfTheStandardDeviationsOfResidues) {
  constexpr std::size_t kSeeds = 24, kHits = 5;
  const auto equal = [](std::size_t) { return Modes{}; };
  double squares = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(1, 0.03);
    std::vector<double> gain(kHits);
    for (double& one : gain) one = gauss(random);
    acquire::Record record = record_of(equal, kHits, seed);
    record.read_accel_mps2 = [read = record.read_accel_mps2, gain](std::size_t row, std::size_t channel,
                                                                   std::size_t first, std::span<double> out) {
      read(row, channel, first, out);
      for (double& x : out) x *= gain[row];
    };
    const Analysis analysis(std::move(record), band()), clean(record_of(equal, kHits, seed), band());
    ASSERT_THAT(analysis.modes(), SizeIs(2));
    ASSERT_THAT(clean.modes(), SizeIs(2));
    const identify::Residue &found = analysis.modes()[0].residues[0], &truth = clean.modes()[0].residues[0];
    EXPECT_GT(found.relative_std, 0.003) << seed;
    EXPECT_LT(truth.relative_std, 1e-3) << seed;
    squares += std::pow((found.value / truth.value - 1.0).real() / found.relative_std, 2);
  }
  EXPECT_GT(squares / kSeeds, 0.4);
  EXPECT_LT(squares / kSeeds, 2.5);
}

// Each channel of each hit is multiplied by its own factor, as for hits on a tube in other directions.
TEST(HitScatter, IsPartOfTheStandardDeviationsOfEachChannel) {
  constexpr std::size_t kSeeds = 24, kHits = 5;
  const auto bat = [](std::uint64_t seed) {
    synth::SynthSpec spec = spec_of({}, kHits, seed);
    for (synth::SynthMode& mode : spec.modes) mode.angle_rad = 0.6;  // both sensors see it
    return synth::synthesise(spec).record;
  };
  std::array<double, 2> squares{};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> gauss(1, 0.03);
    std::array<std::array<double, 2>, kHits> gain{};
    for (auto& of_hit : gain) of_hit = {gauss(random), gauss(random)};
    acquire::Record record = bat(seed);
    record.read_accel_mps2 = [read = record.read_accel_mps2, gain](std::size_t row, std::size_t channel,
                                                                   std::size_t first, std::span<double> out) {
      read(row, channel, first, out);
      for (double& x : out) x *= gain.at(row).at(channel);
    };
    const Analysis analysis(std::move(record), band()), clean(bat(seed), band());
    ASSERT_THAT(analysis.modes(), SizeIs(2));
    ASSERT_THAT(clean.modes(), SizeIs(2));
    for (std::size_t c = 0; c < 2; ++c) {
      const identify::Residue &found = analysis.modes()[0].residues[c], &truth = clean.modes()[0].residues[c];
      EXPECT_GT(found.std, 5 * truth.std) << seed;
      const double std = std::hypot(found.std, found.relative_std * std::abs(found.value));
      squares.at(c) += std::norm(found.value - truth.value) / (std * std) / kSeeds;
    }
  }
  for (const double square : squares) {
    EXPECT_GT(square, 0.3);
    EXPECT_LT(square, 2.5);
  }
}

TEST(HitScatter, NamesADriftAndIncludesIt) {
  const auto drifting = [](std::size_t hit) {
    const double factor = 1 - 5e-4 * (static_cast<double>(hit) - 2);
    return Modes{.first_Hz = kFirst_Hz * factor, .second_Hz = kSecond_Hz * factor};
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Analysis analysis(record_of(drifting, 5, seed), band());
    ASSERT_THAT(analysis.modes(), SizeIs(2)) << seed;
    const identify::Mode& mode = analysis.modes().back();
    ASSERT_TRUE(mode.drift) << seed;
    EXPECT_NEAR(mode.drift->freq_change_per_hit, -5e-4, 2e-5);
    EXPECT_NEAR(mode.pole.freq_Hz, kSecond_Hz, 3 * mode.freq_std_Hz);
    EXPECT_GT(mode.freq_std_parts_Hz.hits, 3 * mode.freq_std_parts_Hz.noise);
    EXPECT_NEAR(mode.pole.damping_ratio, 0.005, 4 * mode.damping_std) << "not broadened by the drift";
    EXPECT_NEAR(std::hypot(mode.freq_std_parts_Hz.noise, mode.freq_std_parts_Hz.hits, mode.freq_std_parts_Hz.misfit),
                mode.freq_std_Hz, 1e-12);
    EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
                Contains(HasSubstr("drifting: frequencies drift from hit to hit")));
  }
}

TEST(HitScatter, NamesSofteningWithItsSlope) {
  constexpr double kSlope = -1e-3;  // Hz/N
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Analysis equal(record_of([](std::size_t) { return Modes{}; }, 6, seed), band());
    const auto softening = [&](std::size_t hit) {
      return Modes{.first_Hz = kFirst_Hz, .second_Hz = kSecond_Hz + kSlope * equal.force_hits()[hit].hit.peak_N};
    };
    const Analysis analysis(record_of(softening, 6, seed), band());
    ASSERT_THAT(analysis.modes(), SizeIs(2)) << seed;
    EXPECT_FALSE(analysis.modes().front().amplitude);
    const auto& trend = analysis.modes().back().amplitude;
    ASSERT_TRUE(trend) << seed;
    EXPECT_NEAR(trend->freq_slope_Hz_per_N, kSlope, 5 * trend->freq_slope_std);
    EXPECT_NEAR(trend->freq_slope_Hz_per_N, kSlope, 0.05 * std::abs(kSlope));
    EXPECT_NEAR(trend->freq_at_zero_Hz, kSecond_Hz, 0.02);
    EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
                Contains(AllOf(HasSubstr("nonlinear: "), HasSubstr("softening"))));
  }
}

// Two modes 0.1 half-power bandwidths apart, in noise of 1 %. The poles of the single hits are far less certain than
// those of all hits together; with this seed, they seem to scatter. The damping ratio becomes the mean of the
// hits' damping ratios, and its ± includes the uncertainty of this mean. Without this part, the damping ratio was 7.5
// standard deviations off.
TEST(HitScatter, IncludesTheUncertaintyOfTheMeanDampingOfTheHits) {
  constexpr double kDamping = 0.002;
  synth::SynthSpec spec;
  spec.fs_Hz = 8192;
  spec.samples = 8192;
  spec.band_low_Hz = 60;
  spec.band_high_Hz = 3000;
  spec.modes = {{.freq_Hz = 1000, .damping_ratio = kDamping, .residue_per_kg = {1, 0.5}},
                {.freq_Hz = 1000.4, .damping_ratio = kDamping, .residue_per_kg = {0.8, 0.4}}};
  spec.structure.rigid_line_per_kg = {1.2, 0.4};
  spec.pretrigger_s = 0.02;
  spec.noise.accel = 0.01;
  spec.seed = 4382488055363955;
  const Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{60.0, 3000.0}, .threads = 1});
  ASSERT_THAT(analysis.modes(), SizeIs(2));
  const identify::Mode& second = analysis.modes().back();
  EXPECT_GT(second.freq_std_parts_Hz.hits, 0);
  EXPECT_GT(second.damping_std_parts.hits, 0);
  for (const identify::Mode& mode : analysis.modes()) {
    EXPECT_EQ(mode.damping_std, mode.damping_std_parts.total());
    EXPECT_LT(std::abs(mode.pole.damping_ratio - kDamping), 3 * mode.damping_std);
  }
}

TEST(HitScatter, IsIncludedWhereNothingExplainsIt) {
  const std::vector<double> ppm{300, -300, 200, -350, 150};
  const auto random = [&](std::size_t hit) { return Modes{.second_Hz = kSecond_Hz * (1 + 1e-6 * ppm[hit])}; };
  const Analysis analysis(record_of(random, 5, 1), band());
  ASSERT_THAT(analysis.modes(), SizeIs(2));
  EXPECT_NEAR(analysis.modes().back().hit_scatter_Hz, 0.27, 0.05);  // 302 ppm of 900 Hz
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()), Contains(HasSubstr("hits_differ: ")));
}

}  // namespace percuss::pipeline::hit_scatter_test
