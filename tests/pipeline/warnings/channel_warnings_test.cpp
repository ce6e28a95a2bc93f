#include "pipeline/warnings/channel_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::pipeline::channel_warnings_test {

using testing::StartsWith;

std::string dead_channel(const std::vector<bool>& dead) {
  acquire::Record record;
  record.accel = {{.name = "A"}};
  std::vector<AnalysedHit> hits;
  for (const bool constant : dead) hits.push_back({.hit = {}, .accepted = true, .responses = {{.dead = constant}}});
  const std::vector<Warning> warnings = channel_warnings(record, hits);
  return warnings.empty() ? "" : warnings.front().message;
}

TEST(ChannelWarnings, CountTheHitsOfADeadChannel) {
  EXPECT_EQ(dead_channel({false, false}), "");
  EXPECT_THAT(dead_channel({false, false, true}),
              StartsWith("A is constant in hit 3: this hit makes its FRFs and residues too small"));
  EXPECT_THAT(dead_channel({true, false, true}),
              StartsWith("A is constant in hits 1, 3: these hits make its FRFs and residues too small"));
  EXPECT_THAT(dead_channel({true, true}), StartsWith("A is constant in every accepted hit: it shows no modes"));
}

TEST(ChannelWarnings, NameEightDeadHitsAtMost) {
  std::vector<bool> dead(12, true);
  dead[1] = false;
  EXPECT_THAT(dead_channel(dead), StartsWith("A is constant in hits 1, 3, 4, 5, 6, 7, 8, 9 and 3 more: "));
}

}  // namespace percuss::pipeline::channel_warnings_test
