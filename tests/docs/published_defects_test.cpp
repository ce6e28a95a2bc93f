// Checks that percuss does not have the errors that were found in published tools.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "acquire/write_record.hpp"
#include "core/units.hpp"
#include "frf/windows.hpp"
#include "identify/start/lscf.hpp"
#include "pipeline/analysis.hpp"
#include "report/frf_files.hpp"
#include "report/json/analysis_json.hpp"
#include "support/json.hpp"
#include "support/modal_frfs.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::published_defects_test {

constexpr double kWindowEnd = 0.01;  // the exponential window ends at 1 %

// One second at 12.8 kHz: lines 1 Hz apart.
synth::SynthSpec test_of_one_second(std::vector<synth::SynthMode> modes, double noise = 0) {
  synth::SynthSpec spec;
  spec.fs_Hz = 12800;
  spec.samples = 12800;
  spec.modes = std::move(modes);
  for (synth::SynthMode& mode : spec.modes) mode.residue_per_kg = {0.9, 0.5};
  spec.noise = {.force = 0.1 * noise, .accel = noise};
  return spec;
}

pipeline::Analysis analysis_of(const synth::SynthSpec& spec, pipeline::AnalysisOptions options = {}) {
  if (!options.band_Hz) options.band_Hz = {60, 3200};
  options.threads = 1;
  return {synth::synthesise(spec).record, std::move(options)};
}

TEST(PublishedDefects, AnExponentialWindowDoesNotScaleTheFrf) {
  // A factor N/Σw would make the FRF 4.65 times too large. The mode has decayed after a second, so the windowed FRF is
  // the exact FRF at jω + decay, except for the force outside the gate.
  constexpr double kGate = 1e-4;
  const synth::SynthSpec spec = test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.02}});
  const synth::Truth truth = synth::synthesise(spec).truth;
  const pipeline::Analysis analysis = analysis_of(spec, {.exponential_end = kWindowEnd});
  ASSERT_EQ(analysis.frfs().size(), 2U);
  ASSERT_GE(analysis.lines().count, 3141U);  // 60 to 3200 Hz
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    for (std::size_t k = 0; k < analysis.lines().count; k += 10) {
      const Complex s(analysis.window_decay_per_s(), kTwoPi * analysis.lines().freq_Hz(k));
      ASSERT_LE(std::abs(frf.frf.value[k] / test::exact_at(truth, s, frf.channel) - 1.0), kGate) << k;
    }
  }
}

TEST(PublishedDefects, DampingIsCorrectedForTheExponentialWindowExactly) {
  constexpr double kRounding = 1e-8;  // of fits to noise-free lines
  const pipeline::Analysis analysis =
      analysis_of(test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.01}}), {.exponential_end = kWindowEnd});
  ASSERT_EQ(analysis.modes().size(), 1U);
  EXPECT_LE(std::abs(analysis.modes()[0].pole.damping_ratio / 0.01 - 1), kRounding);
  EXPECT_LE(std::abs(analysis.modes()[0].pole.freq_Hz / 200 - 1), kRounding);
  // damping_ratio_raw is the value that a tool without correction reports.
  const auto document = test::parse_json(report::analysis_json(analysis));
  EXPECT_NEAR(document["modes"][0]["damping_ratio_raw"].get<double>(), 0.0137, 5e-5);
}

TEST(PublishedDefects, TheBandsBeginningEntersTheImaginaryPartOnly) {
  // If the band's lower limit of 90 Hz were added to |pole|, a mode of 5 % at 100 Hz would read 101.07 Hz.
  constexpr double kExact = 1e-6;  // relative
  identify::FrfDataset set = test::empty_set(4096, 16384, 90, 400, 1);
  test::add_mode(set, 0, {100, 0.05}, 0.8);
  const auto orders = identify::lscf_poles(set, {.max_order = 12});
  ASSERT_FALSE(orders.empty());
  double nearest = 1e9;
  for (const identify::Pole& pole : orders.back().poles) nearest = std::min(nearest, std::abs(pole.freq_Hz - 100));
  EXPECT_LE(nearest, 100 * kExact);
  const auto modes = identify::identify_modes(set);
  ASSERT_EQ(modes.size(), 1U);
  EXPECT_LE(std::abs(modes[0].pole.freq_Hz / 100 - 1), kExact);
  EXPECT_LE(std::abs(modes[0].pole.damping_ratio / 0.05 - 1), kExact);
}

TEST(PublishedDefects, TheBasisIsMappedToTheBandSoThatTwoModesTwoHertzApartAt170HzAreTwo) {
  constexpr double kExact = 1e-6;  // relative
  identify::FrfDataset set = test::empty_set(25600, 65536, 60, 400, 2);
  for (const double freq_Hz : {170.0, 172.0}) {
    test::add_mode(set, 0, {freq_Hz, 0.002}, 0.8);
    test::add_mode(set, 1, {freq_Hz, 0.002}, freq_Hz < 171 ? 0.5 : -0.5);
  }
  const auto poles = identify::lscf_poles(set).back().poles;
  for (const double freq_Hz : {170.0, 172.0}) {
    const auto close = [&](const identify::Pole& pole) { return std::abs(pole.freq_Hz / freq_Hz - 1) <= kExact; };
    EXPECT_EQ(std::count_if(poles.begin(), poles.end(), close), 1) << freq_Hz;
  }
}

TEST(PublishedDefects, TheFrfIsNotConjugated) {
  // With exp(+jωt), the receptance of a positive residue lags by 90° at resonance. Its accelerance is then at +90°.
  constexpr double kGate = 1e-4;
  const synth::SynthSpec spec = test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.02}});
  const synth::Truth truth = synth::synthesise(spec).truth;
  for (const frf::Estimator estimator : {frf::Estimator::h1, frf::Estimator::h2, frf::Estimator::hv}) {
    const pipeline::Analysis analysis = analysis_of(spec, {.estimator = estimator});
    const std::size_t peak = 200 - analysis.lines().first;
    for (const acquire::PointFrf& frf : analysis.frfs()) {
      EXPECT_GT(frf.frf.value[peak].imag(), 5 * std::abs(frf.frf.value[peak].real()));
      const Complex exact = test::exact_at(truth, {0, kTwoPi * 200}, frf.channel);
      EXPECT_LE(std::abs(frf.frf.value[peak] / exact - 1.0), kGate) << name_of(estimator);
    }
  }
}

TEST(PublishedDefects, StoredDataAreNotChangedByAConversion) {
  // A conversion in place would divide the stored values again, and the second receptance would differ.
  const test::ScratchFolder folder;
  const std::string path = folder.file("frf.csv");
  const pipeline::Analysis first = analysis_of(test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.02}}, 1e-3));
  acquire::write_frfs(path, report::frf_record_of(first), acquire::FrfKind::accelerance, false);
  const std::string stored = test::bytes_of(path);
  auto opened = acquire::open_measurement(path);
  ASSERT_TRUE(std::holds_alternative<acquire::FrfRecord>(opened));
  const pipeline::Analysis analysis(std::get<acquire::FrfRecord>(std::move(opened)), {.threads = 1});
  const std::string receptance = report::frf_csv(analysis, acquire::FrfKind::receptance);
  EXPECT_NE(report::frf_csv(analysis, acquire::FrfKind::mobility), receptance);
  EXPECT_EQ(report::frf_csv(analysis, acquire::FrfKind::receptance), receptance);
  EXPECT_EQ(test::bytes_of(path), stored);
}

TEST(PublishedDefects, AnImpactKeepsItsMeanAndGetsNoHannWindow) {
  // Line 0 of a pulse is its impulse, and a pulse at the record's beginning, where a Hann window is 0, keeps its size.
  acquire::Hit hit{.first = 0, .samples = 64, .peak = 1, .gate_first = 0};
  hit.gated_N = {1, 4, 2};
  const acquire::LineRange lines{.fs_Hz = 1000, .samples = 64, .first = 0, .count = 33};
  EXPECT_EQ(frf::force_spectrum(frf::force_block(hit, 1000, 0), lines)[0], 7.0);
  std::vector<double> accel(64);
  for (std::size_t n = 0; n < 64; ++n) accel[n] = 3 + std::cos(0.4 * static_cast<double>(n));
  EXPECT_EQ(frf::accel_spectrum(hit, accel, lines, 0), real_dft(accel));
}

TEST(PublishedDefects, AFrequencyIsNotQuantisedToASpectralLineAndHasItsStandardDeviation) {
  for (const double part : {0.11, 0.37, 0.5, 0.82}) {  // of the 1 Hz between two lines
    const pipeline::Analysis analysis =
        analysis_of(test_of_one_second({{.freq_Hz = 300 + part, .damping_ratio = 0.01}}, 1e-4));
    ASSERT_EQ(analysis.modes().size(), 1U) << part;
    const identify::Mode& mode = analysis.modes()[0];
    EXPECT_LE(std::abs(mode.pole.freq_Hz - (300 + part)), 0.01) << part;  // 1 % of the line spacing
    EXPECT_GT(mode.freq_std_Hz, 0);
    EXPECT_LE(mode.freq_std_Hz, 0.01);
    EXPECT_GT(mode.damping_std, 0);
    for (const identify::Residue& residue : mode.residues) EXPECT_GT(residue.std, 0);
  }
}

TEST(PublishedDefects, ACoherenceAbove1IsNotClipped) {
  // The coherence of percuss exceeds 1 only by rounding, because numerator and denominator come from the same sums. The
  // coherence of a file may exceed 1 and is kept unchanged.
  constexpr double kRounding = 1e-15;
  using Spectra = std::array<std::vector<Complex>, 2>;
  const Spectra f{{{{0.3, 0.7}, {1, -2}}, {{0.9, 0.1}, {1e-3, 4}}}};
  const Spectra a{{{{3, 1}, {-5, 2}}, {{0.2, 0.7}, {-4e-3, -17}}}};
  const std::vector<std::span<const Complex>> force(f.begin(), f.end()), accel(a.begin(), a.end());
  for (const auto* response : {&accel, &force}) {
    const frf::CrossSpectra sums = frf::cross_spectra(force, *response);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_LE(std::norm(sums.fa[k]) / (sums.ff[k] * sums.aa[k]) - 1, kRounding) << k;
  }
  test::ScratchFolder folder;
  const std::string path = folder.file("frf.csv");
  test::write_bytes(path, "frequency_hz,p0_c0_re,p0_c0_im,p0_c0_coherence\n1,1,0,0.9\n2,1,0,1.25\n3,1,0,1\n");
  const auto opened = acquire::open_measurement(path);
  ASSERT_TRUE(std::holds_alternative<acquire::FrfRecord>(opened));
  EXPECT_THAT(std::get<acquire::FrfRecord>(opened).frfs.at(0).frf.coherence, testing::Contains(1.25));
}

TEST(PublishedDefects, OnePoleSetServesAllPointsAndChannels) {
  synth::SynthSpec spec =
      test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.01}, {.freq_Hz = 640, .damping_ratio = 0.006}}, 1e-3);
  for (synth::SynthMode& mode : spec.modes) mode.residue_per_kg = {0.9, 0.5, 0.4, -0.2, 0.7, 0.6};
  spec.points = {{.position_m = 0.1}, {.position_m = 0.2}, {.position_m = 0.3}};
  spec.hits = 2;
  const pipeline::Analysis analysis = analysis_of(spec);
  ASSERT_EQ(analysis.modes().size(), 2U);  // not two for each of three points
  for (const identify::Mode& mode : analysis.modes()) EXPECT_EQ(mode.residues.size(), 6U);
}

TEST(PublishedDefects, EstimatesDoNotDependOnTheExactPick) {
  constexpr double kSettled = 0.01;  // standard deviations
  const synth::SynthSpec spec =
      test_of_one_second({{.freq_Hz = 200, .damping_ratio = 0.01}, {.freq_Hz = 640, .damping_ratio = 0.006}}, 1e-3);
  const pipeline::Analysis first = analysis_of(spec);
  ASSERT_EQ(first.modes().size(), 2U);
  for (const double aside_Hz : {-0.6, 0.0, 0.7}) {
    const std::vector<double> picks{first.modes()[0].pole.freq_Hz + aside_Hz, first.modes()[1].pole.freq_Hz - aside_Hz};
    const pipeline::Analysis picked = analysis_of(spec, {.modes = {.start_Hz = picks}});
    ASSERT_EQ(picked.modes().size(), 2U);
    for (std::size_t m = 0; m < 2; ++m) {
      const identify::Mode& mode = first.modes()[m];
      EXPECT_LE(std::abs(picked.modes()[m].pole.freq_Hz - mode.pole.freq_Hz), kSettled * mode.freq_std_Hz);
      EXPECT_LE(std::abs(picked.modes()[m].pole.damping_ratio - mode.pole.damping_ratio), kSettled * mode.damping_std);
    }
  }
}

}  // namespace percuss::published_defects_test
