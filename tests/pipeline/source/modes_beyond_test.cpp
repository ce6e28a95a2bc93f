#include "pipeline/source/modes_beyond.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "pipeline/analysis.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::modes_beyond_test {

using testing::Contains;
using testing::Not;

constexpr std::pair<double, double> kBand_Hz{60, 1500};
constexpr double kEnd_Hz = 1716;  // the band and 15 % of its width
const acquire::LineRange kLines{.fs_Hz = 25600, .samples = 25600, .first = 60, .count = 2000};

struct OneMode {
  double freq_Hz = 0, damping_ratio = 0.004, amplitude = 1;
};

std::vector<double> power_of(const std::vector<OneMode>& modes) {
  std::vector<double> power(kLines.count);
  for (std::size_t k = 0; k < power.size(); ++k) {
    const double f = kLines.freq_Hz(k);
    std::complex<double> sum = 0;
    for (const OneMode& m : modes)
      sum += m.amplitude * f * f /
             std::complex<double>(m.freq_Hz * m.freq_Hz - f * f, 2 * m.damping_ratio * m.freq_Hz * f);
    power[k] = std::norm(sum);
  }
  return power;
}

double end_with(const std::vector<OneMode>& beyond) {
  std::vector<OneMode> all{{.freq_Hz = 174}, {.freq_Hz = 604}, {.freq_Hz = 1266}};
  all.insert(all.end(), beyond.begin(), beyond.end());
  return end_past_modes(kEnd_Hz, kBand_Hz, kLines, power_of(all));
}

TEST(EndPastModes, StaysWithoutAStrongModeBeyondTheEnd) {
  EXPECT_EQ(end_with({}), kEnd_Hz);
  EXPECT_EQ(end_with({{.freq_Hz = 1740, .amplitude = 0.1}}), kEnd_Hz) << "weak";
  EXPECT_EQ(end_with({{.freq_Hz = 1900}}), kEnd_Hz) << "further than a tenth of the band's width";
  EXPECT_EQ(end_with({{.freq_Hz = 1690}}), kEnd_Hz) << "within the lines";
  EXPECT_EQ(end_past_modes(kEnd_Hz, kBand_Hz, kLines, std::vector<double>(kLines.count)), kEnd_Hz) << "no response";
  EXPECT_EQ(end_past_modes(kEnd_Hz, kBand_Hz, kLines, {}), kEnd_Hz) << "no lines";
}

TEST(EndPastModes, PassesAStrongMode) {
  for (const double freq_Hz : {1710.0, 1716.0, 1740.0, 1800.0, 1850.0}) {
    const double end_Hz = end_with({{.freq_Hz = freq_Hz}});
    EXPECT_GE(end_Hz, freq_Hz + 3 * 0.008 * freq_Hz) << "several bandwidths beyond";
    EXPECT_LE(end_Hz, freq_Hz + 7 * 0.008 * freq_Hz);
  }
  EXPECT_GE(end_with({{.freq_Hz = 1740}, {.freq_Hz = 1860}}), 1880) << "the second follows the first";
  EXPECT_EQ(end_with({{.freq_Hz = 1740}, {.freq_Hz = 1990}}), end_with({{.freq_Hz = 1740}})) << "too far away";
}

synth::SynthSpec with_hoop_at(double freq_Hz) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 174, .damping_ratio = 0.006, .order = 1, .amplitude_per_sqrt_kg = 1.0},
                      {.freq_Hz = 604, .damping_ratio = 0.005, .order = 2, .amplitude_per_sqrt_kg = 1.0},
                      {.freq_Hz = 1266, .damping_ratio = 0.0045, .order = 3, .amplitude_per_sqrt_kg = 1.0},
                      {.freq_Hz = freq_Hz,
                       .damping_ratio = 0.0035,
                       .type = synth::SynthModeType::hoop,
                       .order = 1,
                       .amplitude_per_sqrt_kg = 2.4}},
                     1.5);
  spec.noise = {.force = 1e-5, .accel = 1e-5};
  return spec;
}

AnalysisOptions options() { return {.band_Hz = kBand_Hz, .threads = 1}; }

void expect_true_modes(const Analysis& analysis) {
  test::expect_modes_near(analysis.modes(), {{174, 0.006}, {604, 0.005}, {1266, 0.0045}});
  EXPECT_THAT(test::codes_of(analysis.warnings()), Not(Contains("local_fits")));
  EXPECT_THAT(test::codes_of(analysis.warnings()), Not(Contains("model_misfit")));
}

TEST(ModesBeyondTheBand, OfARecordAreFittedWhereTheyAreClose) {
  const Analysis near(synth::synthesise(with_hoop_at(1740)).record, options());
  EXPECT_GT(near.lines().freq_Hz(near.lines().count - 1), 1750);
  expect_true_modes(near);
  const Analysis far(synth::synthesise(with_hoop_at(2400)).record, options());
  EXPECT_EQ(std::floor(far.lines().freq_Hz(far.lines().count - 1)), kEnd_Hz);
}

TEST(ModesBeyondTheBand, OfFrfsAreFittedWhereTheyAreClose) {
  const Analysis whole(synth::synthesise(with_hoop_at(1740)).record,
                       {.band_Hz = std::pair{60.0, 2300.0}, .threads = 1});
  acquire::FrfRecord frfs;
  frfs.lines = whole.lines();
  frfs.accel = whole.record().accel;
  frfs.frfs = whole.frfs();
  const Analysis near(std::move(frfs), options());
  EXPECT_GT(near.lines().freq_Hz(near.lines().count - 1), 1750);
  expect_true_modes(near);
}

}  // namespace percuss::pipeline::modes_beyond_test
