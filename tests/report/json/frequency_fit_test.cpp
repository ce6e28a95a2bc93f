#include "report/json/frequency_fit.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace percuss::report {
namespace {

// Three frequencies and one fitted parameter leave two degrees of freedom.
FrequencyFit fit_with(double measured_std_Hz) {
  return {
      .frequencies = {{1, 100, measured_std_Hz, 101}, {2, 200, measured_std_Hz, 198}, {3, 400, measured_std_Hz, 400}},
      .parameters = 1,
      .chi2 = 50};
}

TEST(FrequencyFit, ComparesEachFrequencyWithTheModel) {
  const nlohmann::ordered_json json = frequencies_json(fit_with(0));
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[1]["mode"], 2);
  EXPECT_EQ(json[1]["measured_hz"], 200);
  EXPECT_TRUE(json[1]["measured_std_hz"].is_null());
  EXPECT_DOUBLE_EQ(json[0]["difference_percent"].get<double>(), 100 * (101.0 / 100 - 1));
  EXPECT_EQ(frequencies_json(fit_with(0.5))[1]["measured_std_hz"], 0.5);
}

TEST(FrequencyFit, HasABirgeRatioOnlyWithStandardDeviations) {
  nlohmann::ordered_json without, with;
  add_birge_ratio(fit_with(0), without);
  add_birge_ratio(fit_with(0.5), with);
  add_birge_ratio({}, without);
  EXPECT_FALSE(without.contains("birge_ratio"));
  EXPECT_DOUBLE_EQ(with["birge_ratio"].get<double>(), 5);  // √(50/2)
  EXPECT_EQ(birge_text(fit_with(0)), "");
  EXPECT_NE(birge_text(fit_with(0.5)), "");
}

}  // namespace
}  // namespace percuss::report
