#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::synth_command_test {

namespace fs = std::filesystem;
using test::bytes_of;
using test::ProcessOutcome;
using test::write_bytes;
using testing::AllOf;
using testing::HasSubstr;

ProcessOutcome synth(std::vector<std::string> arguments, const std::string& input = "") {
  arguments.insert(arguments.begin(), "synth");
  return test::run_percuss(arguments, {.input = input});
}

class SynthCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }
  test::ScratchFolder folder_;
};

TEST_F(SynthCommand, WritesTheRecordAndItsTruth) {
  const ProcessOutcome outcome = synth({"truncated", "-o", path("a.h5"), "-o", path("a.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(path("a.h5")));
  EXPECT_THAT(bytes_of(path("a.csv")), HasSubstr("hit,t_s,force_N"));
  EXPECT_EQ(test::parse_json(bytes_of(path("a.truth.json")))["name"], "truncated");
}

TEST_F(SynthCommand, WritesEqualBytesForEqualSeedsOnAnyNumberOfThreads) {
  synth({"truncated", "--threads", "1", "-o", path("a.h5")});
  synth({"truncated", "--threads", "3", "-o", path("b.h5")});
  synth({"truncated", "--seed", "77", "-o", path("c.h5")});
  EXPECT_FALSE(bytes_of(path("a.h5")).empty());
  EXPECT_TRUE(bytes_of(path("a.h5")) == bytes_of(path("b.h5")));
  EXPECT_TRUE(bytes_of(path("a.truth.json")) == bytes_of(path("b.truth.json")));
  EXPECT_FALSE(bytes_of(path("a.h5")) == bytes_of(path("c.h5")));
  EXPECT_EQ(test::parse_json(bytes_of(path("c.truth.json")))["seed"], 77);
}

TEST_F(SynthCommand, OverwritesOnlyWhenForced) {
  synth({"truncated", "-o", path("a.h5")});
  const std::string before = bytes_of(path("a.h5"));
  const ProcessOutcome refused = synth({"truncated", "--seed", "2", "-o", path("a.h5")});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_TRUE(before == bytes_of(path("a.h5")));
  EXPECT_EQ(synth({"truncated", "--seed", "2", "--force", "-o", path("a.h5")}).code, 0);
  EXPECT_FALSE(before == bytes_of(path("a.h5")));
}

TEST_F(SynthCommand, ChecksThePathsOfRecordAndTruthFirst) {
  fs::create_directory(path("folder.h5"));
  fs::create_directory(path("b.truth.json"));
  ASSERT_EQ(::mkfifo(path("pipe.csv").c_str(), 0600), 0);
  fs::create_symlink("none.h5", path("link.h5"));
  write_bytes(path("bad.json"), "{");  // the paths are refused before the spec is read
  const auto refusal = [&](const std::string& name) {
    const ProcessOutcome outcome = synth({path("bad.json"), "-o", path(name)});
    EXPECT_EQ(outcome.code, 3) << name;
    return outcome.err;
  };
  EXPECT_THAT(refusal("folder.h5"), HasSubstr("is a folder (" + path("folder.h5") + "); name a file"));
  EXPECT_THAT(refusal("b.csv"), HasSubstr("is a folder (" + path("b.truth.json") + "); name a file"));
  EXPECT_THAT(refusal("pipe.csv"), HasSubstr("is not a regular file (" + path("pipe.csv") + "); name a file"));
  EXPECT_THAT(refusal("link.h5"), HasSubstr("is a link to a file that does not exist (" + path("link.h5") + ")"));
  EXPECT_THAT(synth({path("bad.json"), "--force", "-o", path("folder.h5")}).err, HasSubstr("is a folder"));
}

TEST_F(SynthCommand, PrintsAnExampleThatItAccepts) {
  write_bytes(path("spec.json"), synth({"--example"}).out);
  const ProcessOutcome outcome = synth({path("spec.json"), "--quiet", "-o", path("a.h5")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("truth in")) << "--quiet silences no result";
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(synth({path("spec.json"), "-o", path("X.H5")}).code, 0) << "the letter case of the extension is free";
}

TEST_F(SynthCommand, ReadsStandardInputAndPrintsTheTruth) {
  const std::string spec = R"({"fs_hz": 1000, "samples": 1000, "band_hz": [10, 400], "pulse": {"width_s": 0.002},
                               "modes": [{"frequency_hz": 100, "damping_ratio": 0.02}]})";
  write_bytes(path("spec.json"), spec);
  const ProcessOutcome outcome = synth({"-", "--json"}, path("spec.json"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(test::parse_json(outcome.out)["f_hz"][0], 100);
}

TEST_F(SynthCommand, ListsItsPresets) {
  EXPECT_THAT(synth({"--list"}).out,
              AllOf(HasSubstr("wood-bat"), HasSubstr("roving-barrel"), HasSubstr("bat-scan"), HasSubstr("plate")));
  const auto list = test::parse_json(synth({"--list", "--json"}).out);
  EXPECT_EQ(list["schema"], "percuss/synth-presets/1");
  EXPECT_GE(list["presets"].size(), 11U);
}

TEST_F(SynthCommand, ExitsWithTheCodeOfTheError) {
  EXPECT_EQ(synth({}).code, 2);
  EXPECT_EQ(synth({"wood-bat"}).code, 2);
  EXPECT_EQ(synth({"wood-bat", "-o", path("a.txt")}).code, 2);
  EXPECT_EQ(synth({"steel-bat", "-o", path("a.h5")}).code, 3);
  EXPECT_EQ(synth({path(""), "-o", path("a.h5")}).code, 3);
  write_bytes(path("spec.json"), R"({"fs_hz": 1e300, "samples": 1e12, "modes": []})");
  const ProcessOutcome outcome = synth({path("spec.json"), "-o", path("a.h5")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("fs_hz"), HasSubstr("spec.json")));
  EXPECT_EQ(test::lines_of(outcome.err).size(), 1U);
  EXPECT_FALSE(fs::exists(path("a.h5")));
}

}  // namespace percuss::synth_command_test
