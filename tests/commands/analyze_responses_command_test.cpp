#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// percuss analyze of a microphone or of accelerometers alone.
namespace percuss::analyze_responses_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::HasSubstr;
using testing::IsEmpty;

struct Tone {
  double freq_Hz, damping, amplitude;
};
const std::vector<Tone> kPing{{1732.5, 0.002, 0.3}, {2141, 0.003, 0.2}, {4310, 0.004, 0.1}};
constexpr std::uint32_t kRate_Hz = 44100;
constexpr double kBlow_s = 0.21;

// A ping from kBlow_s on, with 1 ms of rise.
std::vector<double> ping(double noise) {
  std::mt19937 random(2);
  std::normal_distribution<double> gauss;
  std::vector<double> x(kRate_Hz);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kRate_Hz - kBlow_s;
    for (const Tone& one : kPing) {
      const double omega = kTwoPi * one.freq_Hz;
      if (t > 0)
        x[n] += one.amplitude * std::min(1.0, t / 1e-3) * std::exp(-one.damping * omega * t) * std::sin(omega * t);
    }
    x[n] += noise * gauss(random);
  }
  return x;
}

void append(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

// A WAV file of 16 bits and one channel, as recorders write it.
std::string wav(const std::vector<double>& x) {
  std::string bytes = "RIFF";
  const auto size = static_cast<std::uint32_t>(2 * x.size());
  append(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  append(bytes, 16, 4);
  append(bytes, 1, 2);
  append(bytes, 1, 2);
  append(bytes, kRate_Hz, 4);
  append(bytes, 2 * kRate_Hz, 4);
  append(bytes, 2, 2);
  append(bytes, 16, 2);
  bytes += "data";
  append(bytes, size, 4);
  for (const double value : x)
    append(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(32767 * value))), 2);
  return bytes;
}

class AnalyzeResponses : public testing::Test {
 protected:
  AnalyzeResponses() { test::write_bytes(folder_.file("ping.wav"), wav(ping(1e-3))); }
  test::ScratchFolder folder_;
};

TEST_F(AnalyzeResponses, FindsTheModesOfAPing) {
  const auto outcome = run_percuss({"analyze", folder_.file("ping.wav"), "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
  EXPECT_EQ(document["input"], "response");
  EXPECT_EQ(document["excitation"], "unknown");
  ASSERT_EQ(document["hits"].size(), 1U);
  EXPECT_NEAR(document["hits"][0]["time_s"].get<double>(), kBlow_s, 1e-3);
  ASSERT_EQ(document["modes"].size(), kPing.size());
  for (std::size_t m = 0; m < kPing.size(); ++m) {
    const json& mode = document["modes"][m];
    EXPECT_GT(mode["frequency_std_hz"].get<double>(), 0);
    // The pole's frequency is the undamped one.
    const double true_Hz = kPing[m].freq_Hz * std::sqrt(1 + kPing[m].damping * kPing[m].damping);
    EXPECT_NEAR(mode["frequency_hz"].get<double>(), true_Hz, 4 * mode["frequency_std_hz"].get<double>()) << m;
    EXPECT_NEAR(mode["damping_ratio"].get<double>(), kPing[m].damping, 4 * mode["damping_ratio_std"].get<double>());
    EXPECT_LT(mode["frequency_std_hz"].get<double>(), 0.05);
  }
}

TEST_F(AnalyzeResponses, SaysWhatNeedsAForceAndWritesFiles) {
  const auto outcome =
      run_percuss({"analyze", "ping.wav", "-o", "m.csv", "-o", "m.html", "-o", "m.json"}, {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no force was recorded"));
  EXPECT_THAT(outcome.out, HasSubstr("±"));
  EXPECT_EQ(test::lines_of(test::bytes_of(folder_.file("m.csv"))).size(), 1 + kPing.size());
  EXPECT_THAT(test::bytes_of(folder_.file("m.html")), HasSubstr("1732"));
}

TEST_F(AnalyzeResponses, RefusesWhatNeedsAForce) {
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--estimator", "h2"}, {"--only", "frf"}, {"--per-hit"}, {"--delay", "auto"}, {"-o", "x.h5"}}) {
    std::vector<std::string> arguments{"analyze", folder_.file("ping.wav")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_percuss(arguments).code, 2) << more.front();
  }
}

TEST_F(AnalyzeResponses, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto one = run_percuss({"analyze", folder_.file("ping.wav"), "--json", "--threads", "1"});
  const auto two = run_percuss({"analyze", folder_.file("ping.wav"), "--json", "--threads", "2"});
  EXPECT_EQ(one.out, two.out);
}

}  // namespace percuss::analyze_responses_command_test
