#include "pipeline/hits/file_agreement.hpp"

#include <gtest/gtest.h>

#include "pipeline/analysis.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::file_agreement_test {

acquire::Record file_of(const char* preset, std::size_t hits, std::uint64_t seed) {
  synth::SynthSpec spec = synth::synth_preset(preset);
  spec.hits = hits;
  spec.seed = seed;
  return synth::synthesise(spec).record;
}

std::optional<FileDisagreement> disagreement(std::vector<acquire::Record> files) {
  const acquire::Record joined = acquire::join_records(std::move(files), acquire::FileGrouping::automatic);
  return Analysis(joined, {.band_Hz = std::pair{60.0, 3200.0}}).file_disagreement();
}

TEST(FileAgreement, HoldsForFilesOfOneStructure) {
  EXPECT_FALSE(disagreement({file_of("wood-bat", 2, 1), file_of("wood-bat", 3, 2), file_of("wood-bat", 1, 3)}));
  EXPECT_FALSE(disagreement({file_of("wood-bat", 3, 1)}));
}

TEST(FileAgreement, FailsForFilesOfTwoStructures) {
  for (const std::size_t hits : {1U, 2U, 5U}) {
    const auto found = disagreement({file_of("wood-bat", hits, 1), file_of("aluminium-bat", hits, 2)});
    ASSERT_TRUE(found) << hits;
    EXPECT_LT(found->explained, 0.5);
  }
}

}  // namespace percuss::pipeline::file_agreement_test
