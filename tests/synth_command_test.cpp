#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

struct Outcome {
  int code = -1;
  std::string text;  // stdout and stderr
};

Outcome synth(const std::string& arguments) {
  const std::string command = "\"" PERCUSS_EXECUTABLE "\" synth " + arguments + " 2>&1";
  Outcome out;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return out;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) out.text.append(part.data(), n);
  const int status = pclose(pipe);
  out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

class SynthCommand : public testing::Test {
 protected:
  SynthCommand() {
    std::string name = (fs::temp_directory_path() / "percuss-synth-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~SynthCommand() override { fs::remove_all(folder); }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  static std::string bytes(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
  fs::path folder;
};

TEST_F(SynthCommand, WritesTheRecordAndItsTruth) {
  const Outcome outcome = synth("truncated -o " + path("a.h5") + " -o " + path("a.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_TRUE(fs::exists(path("a.h5")));
  EXPECT_THAT(bytes(path("a.csv")), HasSubstr("hit,t_s,force_N"));
  EXPECT_EQ(nlohmann::json::parse(bytes(path("a.truth.json")))["name"], "truncated");
}

TEST_F(SynthCommand, GivesEqualBytesForEqualSeedsOnAnyNumberOfThreads) {
  synth("truncated --threads 1 -o " + path("a.h5"));
  synth("truncated --threads 3 -o " + path("b.h5"));
  synth("truncated --seed 77 -o " + path("c.h5"));
  EXPECT_FALSE(bytes(path("a.h5")).empty());
  EXPECT_TRUE(bytes(path("a.h5")) == bytes(path("b.h5")));
  EXPECT_TRUE(bytes(path("a.truth.json")) == bytes(path("b.truth.json")));
  EXPECT_FALSE(bytes(path("a.h5")) == bytes(path("c.h5")));
  EXPECT_EQ(nlohmann::json::parse(bytes(path("c.truth.json")))["seed"], 77);
}

TEST_F(SynthCommand, OverwritesOnlyWhenForced) {
  synth("truncated -o " + path("a.h5"));
  const std::string before = bytes(path("a.h5"));
  const Outcome refused = synth("truncated --seed 2 -o " + path("a.h5"));
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.text, HasSubstr("--force"));
  EXPECT_TRUE(before == bytes(path("a.h5")));
  EXPECT_EQ(synth("truncated --seed 2 --force -o " + path("a.h5")).code, 0);
  EXPECT_FALSE(before == bytes(path("a.h5")));
}

TEST_F(SynthCommand, PrintsAnExampleThatItAccepts) {
  EXPECT_EQ(synth("--example > " + path("spec.json")).code, 0);
  const Outcome outcome = synth(path("spec.json") + " --quiet -o " + path("a.h5"));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(outcome.text, "");
}

TEST_F(SynthCommand, ReadsStandardInputAndPrintsTheTruth) {
  const std::string spec = R"({"fs_hz": 1000, "samples": 1000, "band_hz": [10, 400], "pulse": {"width_s": 0.002},
                               "modes": [{"frequency_hz": 100, "damping_ratio": 0.02}]})";
  std::ofstream(path("spec.json")) << spec;
  const Outcome outcome = synth("- --json < " + path("spec.json"));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(nlohmann::json::parse(outcome.text)["f_hz"][0], 100);
}

TEST_F(SynthCommand, ListsItsPresets) {
  EXPECT_THAT(synth("--list").text, AllOf(HasSubstr("wood-bat"), HasSubstr("roving-barrel")));
  const auto list = nlohmann::json::parse(synth("--list --json").text);
  EXPECT_EQ(list["schema"], "percuss/synth-presets/1");
  EXPECT_GE(list["presets"].size(), 11U);
}

TEST_F(SynthCommand, EndsWithTheCodeOfTheMistake) {
  EXPECT_EQ(synth("").code, 2);
  EXPECT_EQ(synth("wood-bat").code, 2);
  EXPECT_EQ(synth("wood-bat -o " + path("a.txt")).code, 2);
  EXPECT_EQ(synth("steel-bat -o " + path("a.h5")).code, 3);
  EXPECT_EQ(synth(path("") + " -o " + path("a.h5")).code, 3);
  std::ofstream(path("spec.json")) << R"({"fs_hz": 1e300, "samples": 1e12, "modes": []})";
  const Outcome outcome = synth(path("spec.json") + " -o " + path("a.h5"));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.text, AllOf(HasSubstr("fs_hz"), HasSubstr("spec.json")));
  EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(path("a.h5")));
}

}  // namespace
}  // namespace percuss
