#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "support/files/minimised_corpus.hpp"
#include "support/scratch_folder.hpp"
#include "targets.hpp"

// Runs the corpora of the fuzz targets, with their former findings, and a few mutations.
namespace percuss::fuzz_corpus_test {

namespace fs = std::filesystem;
using test::bytes_of;

const std::string kCorpus = PERCUSS_SOURCE_DIR "/fuzz/corpus";

std::vector<std::string> inputs_of(const fuzz::Target& target) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(kCorpus + "/" + target.name)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Overwrites some bytes, removes, doubles or copies a part, or replaces the end by the end of another input.
std::string mutated(const std::string& bytes, const std::string& other, std::mt19937& random) {
  const auto below = [&](std::size_t limit) { return limit == 0 ? 0 : random() % limit; };
  std::string out = bytes;
  const std::size_t at = below(out.size()), length = 1 + below(std::min<std::size_t>(64, out.size() - at));
  switch (random() % 5) {
    case 0:
      for (std::size_t i = 0; i < 1 + random() % 4; ++i) out[below(out.size())] = static_cast<char>(random() & 0xFFU);
      break;
    case 1:
      out.erase(at, length);
      break;
    case 2:
      out.insert(at, out.substr(at, length));
      break;
    case 3:
      out.insert(below(out.size()), out.substr(at, length));
      break;
    default:
      out = out.substr(0, at) + other.substr(below(other.size()));
  }
  return out;
}

class FuzzCorpus : public testing::TestWithParam<fuzz::Target> {};

INSTANTIATE_TEST_SUITE_P(, FuzzCorpus, testing::ValuesIn(fuzz::targets().begin(), fuzz::targets().end()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(FuzzCorpus, IsReadOrRejected) {
  const auto inputs = inputs_of(GetParam());
  ASSERT_FALSE(inputs.empty());
  for (const std::string& path : inputs) {
    SCOPED_TRACE(path);
    GetParam().run(bytes_of(path));
  }
}

// The inputs that the fuzzers found, reduced to inputs that reach different code.
TEST_P(FuzzCorpus, IsReadOrRejectedWhenMinimised) {
  const test::ScratchFolder folder;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(test::extract_minimised(GetParam().name, folder.path()))) {
    SCOPED_TRACE(entry.path());
    GetParam().run(bytes_of(entry.path()));
    ++count;
  }
  EXPECT_GT(count, 0U);
}

TEST_P(FuzzCorpus, IsReadOrRejectedWhenMutated) {
  const auto inputs = inputs_of(GetParam());
  const std::size_t runs = std::string_view(GetParam().name) == "foreign" ? 40 : 400;  // a process for each
  std::mt19937 random(19);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string bytes = bytes_of(inputs[i]), other = bytes_of(inputs[(i + 1) % inputs.size()]);
    for (std::size_t run = 0; run < runs && !bytes.empty(); ++run) GetParam().run(mutated(bytes, other, random));
  }
}

TEST_P(FuzzCorpus, IsReadOrRejectedWithAnotherStructure) {
  if (GetParam().mutate == nullptr) return;  // texts without a structure of their own
  const std::size_t runs = std::string_view(GetParam().name) == "foreign" ? 20 : 200;
  std::mt19937 random(23);
  for (const std::string& path : inputs_of(GetParam())) {
    SCOPED_TRACE(path);
    const std::string original = bytes_of(path);
    std::string bytes = original;
    std::size_t changed = 0;
    for (std::size_t run = 0; run < runs; ++run) {
      if (run % 8 == 0) bytes = original;  // up to eight changes of one input
      const std::string before = bytes;
      GetParam().mutate(bytes, random);
      changed += bytes == before ? 0U : 1U;
      GetParam().run(bytes);
    }
    const bool has_structure = !path.ends_with(".wav") && !path.ends_with(".rf64") && !path.ends_with(".w64");
    EXPECT_EQ(changed > runs / 3, has_structure) << changed;
  }
}

TEST(FuzzTargets, HaveACorpusEach) {
  std::vector<std::string> names, folders;
  for (const fuzz::Target& target : fuzz::targets()) names.emplace_back(target.name);
  for (const auto& entry : fs::directory_iterator(kCorpus)) folders.push_back(entry.path().filename());
  EXPECT_THAT(folders, testing::UnorderedElementsAreArray(names));
}

}  // namespace percuss::fuzz_corpus_test
