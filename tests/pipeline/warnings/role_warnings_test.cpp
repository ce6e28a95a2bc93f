#include "pipeline/warnings/role_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "pipeline/analysis.hpp"
#include "support/force_row.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::role_warnings_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Signals = std::vector<std::vector<double>>;  // [rows][samples]

/// The samples of a preset: its force and its first accelerometer.
struct HammerTest {
  double fs_Hz = 0;
  Signals force, accel;
};

HammerTest samples_of(const std::string& preset) {
  const acquire::Record record = synth::synthesise(synth::synth_preset(preset)).record;
  HammerTest out{.fs_Hz = record.fs_Hz, .force = {}, .accel = {}};
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    out.force.push_back(test::force_N(record, row));
    out.accel.push_back(test::accel_mps2(record, 0, row));
  }
  return out;
}

acquire::Record record_of(double fs_Hz, const Signals& force, const std::vector<Signals>& channels) {
  std::vector<std::vector<std::vector<double>>> accel(force.size());
  for (std::size_t row = 0; row < force.size(); ++row) {
    for (const Signals& channel : channels) accel[row].push_back(channel[row]);
  }
  return acquire::record_in_memory(fs_Hz, force, std::move(accel));
}

std::vector<std::string> messages_of(acquire::Record record, const AnalysisOptions& options = {}) {
  Analysis analysis(std::move(record), options);
  analysis.force_hits();
  return test::lines_of_messages(analysis.warnings());
}

void add_noise_to(Signals& rows, double deviation) {
  for (std::size_t row = 0; row < rows.size(); ++row) test::add_noise(rows[row], deviation, row + 1);
}

const auto kSwapped = Contains(StartsWith("swapped_channels: accel "));
const auto kDead = Contains(StartsWith("no_pulse: force shows no hammer pulse at any of"));

class Roles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(RoleWarnings, Roles,
                         testing::Values("aluminium-bat", "composite-bat", "wood-bat", "plate", "truncated",
                                         "long-continuous", "bat-scan", "double-hit", "clipped"));

TEST_P(Roles, OfExchangedChannelsAreNamed) {
  for (const double noise : {0.0, 0.01}) {  // of the largest force
    HammerTest test = samples_of(GetParam());
    add_noise_to(test.force, noise * 300);
    add_noise_to(test.accel, noise * 10);
    EXPECT_THAT(messages_of(record_of(test.fs_Hz, test.accel, {test.force})), kSwapped) << noise;
    Signals other = test.accel;
    add_noise_to(other, 1);
    const auto second = messages_of(record_of(test.fs_Hz, test.accel, {other, test.force}));
    EXPECT_THAT(second, Contains(StartsWith("swapped_channels: accel 2 looks like the hammer and force"))) << noise;
  }
}

// Exchanged plugs also exchange the sensitivities that the recorder used: no unit makes up for that.
TEST(RoleWarnings, AskForTheScalesOfExchangedPlugs) {
  const HammerTest test = samples_of("aluminium-bat");
  acquire::Record record = record_of(test.fs_Hz, test.accel, {test.force});
  record.force.unit_assumed = record.accel[0].unit_assumed = true;
  EXPECT_THAT(messages_of(record), AllOf(kSwapped, Not(Contains(HasSubstr("sensitivity of the other sensor")))));
  record.force.unit_assumed = record.accel[0].unit_assumed = false;
  EXPECT_THAT(messages_of(record), Contains(AllOf(StartsWith("swapped_channels: accel 1 looks like the hammer"),
                                                  HasSubstr("scaled each signal with the sensitivity of the other "),
                                                  HasSubstr("state the scales"))));
}

// A loose cable: the accelerometer shows ordinary ringing, which is no pulse.
TEST_P(Roles, OfADeadHammerAreNotExchanged) {
  const HammerTest test = samples_of(GetParam());
  Signals noise = test.force, zeros = test.force, hum = test.force;
  for (std::size_t row = 0; row < test.force.size(); ++row) {
    for (std::size_t n = 0; n < test.force[row].size(); ++n) {
      noise[row][n] = zeros[row][n] = 0;
      hum[row][n] = 0.5 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(n) / test.fs_Hz);
    }
  }
  add_noise_to(noise, 0.05);
  add_noise_to(hum, 0.02);
  for (const Signals& dead : {noise, zeros, hum}) {
    const auto messages = messages_of(record_of(test.fs_Hz, dead, {test.accel}));
    EXPECT_THAT(messages, Not(kSwapped));
    EXPECT_THAT(messages, test.force.size() > 1
                              ? kDead
                              : Contains(StartsWith("no_pulse: force shows no hammer pulse at the only hit")));
    EXPECT_THAT(messages, Contains(HasSubstr("accel 1 responds")));
  }
}

// The accelerometer of a free mass moves as the force does. Without its cable, the force shows nothing.
TEST(RoleWarnings, DoNotTakeAFreeMassForTheHammer) {
  const HammerTest test = samples_of("aluminium-bat");
  Signals dead(test.force.size(), std::vector<double>(test.force.front().size()));
  add_noise_to(dead, 0.05);
  const auto messages = messages_of(record_of(test.fs_Hz, dead, {test.force}));
  EXPECT_THAT(messages, AllOf(Not(kSwapped), kDead));
}

TEST(RoleWarnings, LeaveAStatedTriggerToTheFindings) {
  const HammerTest test = samples_of("aluminium-bat");
  AnalysisOptions options;
  options.hits.trigger_N = 1e4;
  const auto messages = messages_of(record_of(test.fs_Hz, test.force, {test.accel}), options);
  EXPECT_THAT(messages, Not(Contains(StartsWith("no_pulse"))));
  EXPECT_THAT(messages, Contains(StartsWith("rejected_hits: 5 of 5")));
}

TEST(RoleWarnings, AreNoneForOneMissedHit) {
  const HammerTest test = samples_of("no-pulse");
  EXPECT_THAT(messages_of(record_of(test.fs_Hz, test.force, {test.accel})),
              Not(Contains(testing::AnyOf(StartsWith("no_pulse"), StartsWith("swapped_channels")))));
}

}  // namespace percuss::pipeline::role_warnings_test
