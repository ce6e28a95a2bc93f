#include <gtest/gtest.h>

#include <filesystem>

#include "acquire/open_measurement.hpp"
#include "support/files/minimised_corpus.hpp"
#include "support/scratch_folder.hpp"
#include "targets.hpp"

// Reads the inputs of the fuzz target "foreign" in this process, because a sandboxed process cannot write its coverage.
namespace percuss::corpus_without_sandbox {

namespace fs = std::filesystem;

// Returns the number of inputs read.
std::size_t read_folder(const std::string& folder) {
  std::size_t inputs = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path());
    const std::string path = entry.path();
    if (path.ends_with("/slow_structure.mat")) continue;  // takes minutes; a sandbox would end it
    fuzz::accepted(
        [&] { fuzz::read_all(acquire::open_measurement(path, {.read = {.sandboxed = false}, .kind = {}})); });
    ++inputs;
  }
  return inputs;
}

TEST(CorpusWithoutSandbox, IsReadOrRejected) {
  constexpr std::size_t kMinInputs = 28;  // inputs are added, not removed
  EXPECT_GE(read_folder(PERCUSS_SOURCE_DIR "/fuzz/corpus/foreign"), kMinInputs);
}

TEST(CorpusWithoutSandbox, IsReadOrRejectedWhenMinimised) {
  const test::ScratchFolder folder;
  EXPECT_GE(read_folder(test::extract_minimised("foreign", folder.path())), 1U);  // a new minimisation may keep fewer
}

}  // namespace percuss::corpus_without_sandbox
