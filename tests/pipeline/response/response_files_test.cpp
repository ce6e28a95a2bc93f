#include "pipeline/response/response_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "pipeline/hits/hit_grading.hpp"
#include "support/input_error.hpp"
#include "support/response_records.hpp"

namespace percuss::pipeline::response_files_test {

constexpr double kFs_Hz = 16384, kDamping = 0.002;
const std::vector<double> kFreqs_Hz{700, 1300, 2100, 3300};

// One blow on a part whose frequencies are `factor` times kFreqs_Hz. Each file has noise of its own.
acquire::Record file(double factor, int number) {
  std::mt19937 random(static_cast<unsigned>(number) + 1);
  std::normal_distribution<double> gauss;
  std::vector<double> x(16384);
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = 0.003 * gauss(random);
    for (std::size_t m = 0; n >= 1000 && m < kFreqs_Hz.size(); ++m) {
      const Complex s = identify::decay_rate_of({factor * kFreqs_Hz[m], kDamping}).rate_radps;
      x[n] += std::exp(s * (static_cast<double>(n - 1000) / kFs_Hz)).imag() / static_cast<double>(m + 1);
    }
  }
  acquire::Record record = test::response_record(kFs_Hz, {{std::move(x)}}, 0, true);
  record.files = {{.path = "part" + std::to_string(number) + ".wav"}};
  return record;
}

std::vector<acquire::Record> files(const std::vector<double>& factors) {
  std::vector<acquire::Record> out;
  for (const double factor : factors) out.push_back(file(factor, static_cast<int>(out.size())));
  return out;
}

bool warns(const ResponseTest& test, const std::string& code) {
  return std::any_of(test.warnings.begin(), test.warnings.end(), [&](const Warning& one) { return one.code == code; });
}

TEST(ResponseFiles, AreOneTestIfTheirModesAgree) {
  const auto tests = tests_of_files(files({1, 1, 1}), {});
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(tests[0].hits.size(), 3U);
  EXPECT_EQ(tests[0].found.modes.size(), kFreqs_Hz.size());
  EXPECT_FALSE(warns(tests[0], "files_disagree"));
  EXPECT_FALSE(warns(tests[0], "hits_differ"));
}

// The frequencies of the parts differ by one half-power bandwidth: one fit of all files would list the modes of each.
TEST(ResponseFiles, AreTestsOfTheirOwnIfTheirModesDiffer) {
  const std::vector<double> factors{1, 1 + 2 * kDamping, 1 - 2 * kDamping};
  const auto tests = tests_of_files(files(factors), {});
  ASSERT_EQ(tests.size(), factors.size());
  for (std::size_t t = 0; t < tests.size(); ++t) {
    ASSERT_EQ(tests[t].found.modes.size(), kFreqs_Hz.size()) << t;
    for (std::size_t m = 0; m < kFreqs_Hz.size(); ++m) {
      const identify::Mode& mode = tests[t].found.modes[m].mode;
      EXPECT_NEAR(mode.pole.freq_Hz, factors[t] * kFreqs_Hz[m], 5 * mode.freq_std_Hz) << t;
    }
    EXPECT_TRUE(warns(tests[t], "files_disagree")) << t;
  }
}

// One file of another part among files of one part.
TEST(ResponseFiles, AreTestsOfTheirOwnIfOneDiffers) {
  EXPECT_EQ(tests_of_files(files({1, 1, 1.01, 1}), {}).size(), 4U);
}

// A tenth of the bandwidth: temperature or unequal blows may be the cause.
TEST(ResponseFiles, AreOneTestWithAWarningIfTheirModesDifferLittle) {
  const auto tests = tests_of_files(files({1, 1 + 0.2 * kDamping}), {});
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_TRUE(warns(tests[0], "hits_differ"));
  EXPECT_FALSE(warns(tests[0], "files_disagree"));
}

TEST(ResponseFiles, AreOneTestIfOnlySomeShowAllModes) {
  AnalysisOptions low;
  low.band_Hz = {500, 1500};
  std::vector<ResponseTest> tests = tests_of_records(files({1}), low);
  ASSERT_EQ(tests.front().found.modes.size(), 2U);
  tests.push_back(tests_of_records(files({1}), {}).front());
  EXPECT_FALSE(differing_test(tests, 0.01).has_value());
  tests.push_back(tests_of_records(files({1.01}), {}).front());
  ASSERT_TRUE(differing_test(tests, 0.01).has_value());
  EXPECT_EQ(differing_test(tests, 0.01)->test, 2U);
  EXPECT_EQ(differing_test(tests, 0.01)->shared, 0);
}

TEST(ResponseFiles, WithoutModesSayNothing) {
  std::vector<acquire::Record> both = files({1});
  both.push_back(test::response_record(kFs_Hz, {{std::vector<double>(16384)}}, 0.1, true));
  const auto tests = tests_of_files(both, {});
  ASSERT_EQ(tests.size(), 1U);
  ASSERT_EQ(tests[0].hits.size(), 2U);
  EXPECT_FALSE(tests[0].hits[1].accepted);
}

// The numbers of hits are those of the test of all files.
TEST(ResponseFiles, TakeNumbersOfHitsOfOneTestOnly) {
  AnalysisOptions options;
  options.reject_hits = {2};
  const auto tests = tests_of_files(files({1, 1, 1}), options);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_FALSE(tests[0].hits[2].accepted);
  const std::string message = test::input_error_of([&] { tests_of_files(files({1, 1, 1.01}), options); });
  EXPECT_THAT(message, testing::HasSubstr("the files measured different structures"));
  options.reject_hits = {kEveryHit};
  EXPECT_EQ(tests_of_files(files({1, 1.01}), options).size(), 1U) << "no file has an accepted hit, so none has modes";
}

}  // namespace percuss::pipeline::response_files_test
