#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::calibrate_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kMass_kg = 1.25;
constexpr double kScale = 0.0084;  // N per unit of the force column

class CalibrateCommand : public testing::Test {
 protected:
  // A free mass: the acceleration is force / mass, with a little noise on both.
  CalibrateCommand() {
    std::string text = "t_s,hammer_V,acc_m_s2\n";
    unsigned state = 1;
    const auto noise = [&state] {
      return static_cast<double>((state = state * 1664525U + 1013904223U) >> 16U) / 65536 - 0.5;
    };
    for (int i = 0; i < 6000; ++i) {
      double force_N = 0;
      for (const auto& [start, peak_N] : {std::pair{800, 40.0}, std::pair{2800, 25.0}, std::pair{4800, 60.0}}) {
        if (i >= start && i < start + 20) force_N = peak_N * std::sin(std::numbers::pi * (i - start) / 20);
      }
      text += fmt::format("{:.4f},{:.6f},{:.6f}\n", i / 2000.0, force_N / kScale + noise(),
                          force_N / kMass_kg + 0.01 * noise());
    }
    test::write_bytes(path_, text);
  }
  test::ProcessOutcome calibrate(std::vector<std::string> options) const {
    options.insert(options.begin(), {"calibrate", path_, "--force-channel", "hammer_V", "--force-unit", "N"});
    return run_percuss(options);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("mass.csv");
};

TEST_F(CalibrateCommand, FindsTheForceScale) {
  const auto outcome = calibrate({"--mass", "1.25", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("calibration")), testing::IsEmpty());
  EXPECT_EQ(document["mass_kg"], 1.25);
  EXPECT_NEAR(document["force_scale"], kScale, 0.01 * kScale);
  EXPECT_LT(document["force_scale_std"], 0.01 * kScale);
  ASSERT_EQ(document["hits"].size(), 3U);
  EXPECT_NEAR(document["hits"][1]["time_s"], 1.4, 0.005);
}

TEST_F(CalibrateCommand, PrintsTheOptionToUse) {
  const auto outcome = calibrate({"--mass", "1.25"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("1.25 kg"), HasSubstr("--force-scale 0.008"), HasSubstr(" ± ")));
}

TEST_F(CalibrateCommand, WritesTheDocument) {
  const std::string out = folder_.file("scale.json");
  ASSERT_EQ(calibrate({"--mass", "1.25", "-o", out}).code, 0);
  EXPECT_NEAR(test::parse_json(test::bytes_of(out))["force_scale"], kScale, 0.01 * kScale);
  const auto refused = calibrate({"--mass", "1.25", "-o", out});
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, AllOf(HasSubstr(out), HasSubstr("--force")));
  EXPECT_EQ(calibrate({"--mass", "1.25", "-o", out, "--force"}).code, 0);
}

TEST_F(CalibrateCommand, ReportsErrorsInOneLine) {
  const auto rejection_of = [this](const std::vector<std::string>& options, int code) {
    const auto outcome = calibrate(options);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(rejection_of({}, 2), HasSubstr("--mass"));
  EXPECT_THAT(rejection_of({"--mass", "0"}, 2), HasSubstr("--mass"));
  EXPECT_THAT(rejection_of({"--mass", "-1"}, 2), HasSubstr("--mass"));
  EXPECT_THAT(rejection_of({"--mass", "nan"}, 2), HasSubstr("--mass"));
  EXPECT_THAT(rejection_of({"--mass", "1.25", "-o", "scale.txt"}, 2), HasSubstr(".json"));
}

TEST_F(CalibrateCommand, FailsWithoutAHit) {
  const auto outcome = calibrate({"--mass", "1.25", "--trigger", "1e6"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(test::lines_of(outcome.err).size(), 1U) << outcome.err;
}

TEST_F(CalibrateCommand, RefusesARecordInNewtons) {
  const std::string path = folder_.file("done.csv");
  std::string text = "t (s),force (N),acc (m/s^2)\n";
  for (int i = 0; i < 3000; ++i) {
    const double force_N = i >= 800 && i < 820 ? 40 * std::sin(std::numbers::pi * (i - 800) / 20) : 0;
    text += fmt::format("{:.4f},{:.6f},{:.6f}\n", i / 2000.0, force_N, force_N / kMass_kg);
  }
  test::write_bytes(path, text);
  const auto outcome = run_percuss({"calibrate", path, "--mass", "1.25"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("is in N already"), HasSubstr("(--force-unit)")));
}

// The scale is per unit of the stored numbers, V or mV. With it, analyze finds the true peak.
TEST_F(CalibrateCommand, StatesTheScalePerUnitOfTheStoredNumbers) {
  constexpr double kNewtonPerVolt = 432.9, kPeak_N = 40;
  for (const auto& [unit, volts] : {std::pair{"V", 1.0}, std::pair{"mV", 1e-3}}) {
    std::string text = fmt::format("t (s),hammer ({}),acc (m/s^2)\n", unit);
    for (int i = 0; i < 3000; ++i) {
      const double force_N = i >= 800 && i < 820 ? kPeak_N * std::sin(std::numbers::pi * (i - 800) / 20) : 0;
      text += fmt::format("{:.4f},{:.9f},{:.6f}\n", i / 2000.0, force_N / kNewtonPerVolt / volts, force_N / kMass_kg);
    }
    const std::string path = folder_.file(fmt::format("in_{}.csv", unit));
    test::write_bytes(path, text);
    const auto shown = run_percuss({"calibrate", path, "--mass", "1.25"});
    EXPECT_THAT(shown.out, AllOf(HasSubstr(fmt::format("N per {}", unit)), HasSubstr(fmt::format("\n1 {} of", unit))));
    const auto document = test::parse_json(run_percuss({"calibrate", path, "--mass", "1.25", "--json"}).out);
    const double scale = document["force_scale"];
    EXPECT_NEAR(scale, kNewtonPerVolt * volts, 1e-4 * kNewtonPerVolt * volts) << unit;
    EXPECT_NEAR(document["hits"][0]["peak_force"], kPeak_N / scale, 0.01 * kPeak_N / scale) << unit;
    const auto analysed = test::parse_json(
        run_percuss({"analyze", path, "--force-scale", fmt::format("{}", scale), "--only", "hits", "--json"}).out);
    EXPECT_NEAR(analysed["hits"][0]["peak_force_n"], kPeak_N, 0.01 * kPeak_N) << unit;
  }
}

}  // namespace percuss::calibrate_command_test
