#include "report/svg/response_spectra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "acquire/record/record.hpp"
#include "support/ping_file.hpp"

namespace percuss::report::response_spectra_test {

constexpr double kFs_Hz = 44100;

pipeline::ResponseTest test_of(std::vector<std::vector<double>> channels) {
  std::vector<std::vector<double>> force{std::vector<double>(channels.front().size())};
  acquire::Record record = acquire::record_in_memory(kFs_Hz, std::move(force), {std::move(channels)});
  record.has_force = false;
  record.continuous = true;
  for (acquire::SignalInfo& signal : record.accel) signal.name.clear();
  return pipeline::analyse_responses(std::move(record), {});
}

// Without noise the modes explain every line within 60 dB of the largest.
TEST(ResponseSpectra, ShowTheFitOnTheMeasurement) {
  constexpr double kShown_dB = -60, kAgreement_dB = 0.02;
  std::vector<double> half = test::ping(0);
  for (double& x : half) x *= 0.5;
  const auto charts = response_spectra(test_of({test::ping(0), half}));
  ASSERT_EQ(charts.size(), 2U);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    ASSERT_EQ(charts[c].curves.size(), 2U);
    const auto &measured = charts[c].curves[0], &fit = charts[c].curves[1];
    EXPECT_EQ(charts[c].title, c == 0 ? "Free decays of channel 1" : "Free decays of channel 2");
    EXPECT_EQ(*std::max_element(measured.y.begin(), measured.y.end()), 0);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < measured.y.size(); ++i) {
      if (measured.y[i] < kShown_dB) continue;
      ++compared;
      EXPECT_NEAR(fit.y[i], measured.y[i], kAgreement_dB) << measured.x[i];
    }
    EXPECT_GT(compared, 300U);
  }
}

TEST(ResponseSpectra, AreAbsentWithoutModes) {
  EXPECT_THAT(response_spectra(test_of({std::vector<double>(8192, 0.0)})), testing::IsEmpty());
}

}  // namespace percuss::report::response_spectra_test
