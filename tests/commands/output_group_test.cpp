#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/files/synthetic_files.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// A command with several outputs writes all or none.
namespace percuss::output_group_test {

namespace fs = std::filesystem;
using test::run_percuss;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class OutputGroups : public testing::Test {
 protected:
  OutputGroups() {
    test::write_small_test(record_);
    std::ofstream(bats_) << run_percuss({"study", "--example"}).out;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) names.push_back(entry.path().filename());
    return names;
  }

  test::ScratchFolder inputs_, folder_;
  std::string record_ = inputs_.file("bat.h5"), bats_ = inputs_.file("bats.csv");
  std::string long_name_ = std::string(300, 'z');
  std::string failing_ = folder_.file(long_name_ + ".json");  // its name is too long for a file system
};

// The last output of each command fails.
TEST_F(OutputGroups, AreAbsentWhenOneFails) {
  const std::vector<std::vector<std::string>> commands{
      {"analyze", record_, "-o", folder_.file("a.html"), "-o", folder_.file("a.h5"), "-o", failing_},
      {"analyze", record_, "--frf", folder_.file("a.mat"), "--modes-file", folder_.file("m.csv"), "-o", failing_},
      {"analyze", record_, "--frf", folder_.file("a.mat"), "--frf", folder_.file(long_name_ + ".csv")},
      {"frf", record_, "-o", folder_.file("f.csv"), "-o", folder_.file("f.mat"), "-o", failing_},
      {"survey", record_, "-o", folder_.file("s.uff"), "-o", folder_.file("s.h5"), "-o", failing_},
      {"deflect", record_, "-o", folder_.file("d.csv"), "-o", folder_.file("d.h5"), "-o", failing_},
      {"info", record_, "-o", folder_.file("i.json"), "-o", failing_},
      {"model", "beam", "-o", folder_.file("b.csv"), "-o", folder_.file("b.svg"), "-o", failing_},
      {"study", bats_, "--table", folder_.file("t.csv"), "--blind", folder_.file("k.csv"), "-o", failing_},
      {"synth", "wood-bat", "-o", folder_.file("y.h5"), "-o", folder_.file(long_name_ + ".csv")}};
  for (const auto& command : commands) {
    const auto outcome = run_percuss(command);
    EXPECT_EQ(outcome.code, 3) << testing::PrintToString(command) << outcome.err;
    EXPECT_THAT(files(), IsEmpty()) << testing::PrintToString(command);
  }
}

TEST_F(OutputGroups, NeedAFolder) {
  const std::string missing = folder_.file("missing/z.json");
  for (const auto& command : std::vector<std::vector<std::string>>{
           {"analyze", "no-such-record.h5", "-o", missing},
           {"survey", "no-such-record.h5", "-o", missing},
           {"synth", "wood-bat", "-o", folder_.file("missing/y.csv")},
           {"record", "--device", "sim:wood-bat", "-o", folder_.file("t.h5"), "--report",
            folder_.file("missing/r.html")},
           {"record", "--device", "sim:wood-bat", "-o", folder_.file("missing/t.h5")}}) {
    const auto outcome = run_percuss(command);
    EXPECT_EQ(outcome.code, 3) << testing::PrintToString(command);
    EXPECT_THAT(outcome.err, testing::HasSubstr("cannot write: No such file or directory ("));
    EXPECT_THAT(outcome.err, testing::HasSubstr("create the folder first"));
    EXPECT_THAT(files(), IsEmpty()) << testing::PrintToString(command);
  }
}

TEST_F(OutputGroups, AppearTogether) {
  const auto outcome = run_percuss({"analyze", record_, "--quiet", "-o", folder_.file("a.json"), "-o",
                                    folder_.file("a.h5"), "-o", folder_.file("a.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(files(), UnorderedElementsAre("a.json", "a.h5", "a.csv"));
}

// The column names of a table show whether it holds modes or FRFs.
TEST_F(OutputGroups, HoldModesOrFrfsByNameOrOption) {
  const auto outcome = run_percuss({"analyze", record_, "--quiet", "--frf", folder_.file("a.csv"), "--modes-file",
                                    folder_.file("b.csv"), "-o", folder_.file("frf.csv"), "-o",
                                    folder_.file("modes.csv"), "-o", folder_.file("bat.modes.csv")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = [&](const std::string& name) {
    std::ifstream file(folder_.file(name));
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  };
  for (const char* frf : {"a.csv", "frf.csv"})
    EXPECT_THAT(lines(frf).at(1), testing::StartsWith("frequency_hz,")) << frf;
  const auto modes = lines("b.csv");
  EXPECT_THAT(modes.front(), testing::StartsWith("mode,frequency_hz,"));
  EXPECT_EQ(modes.size(), 1U + 2 * 2) << "two modes at one point and two channels";
  EXPECT_EQ(lines("modes.csv"), modes);
  EXPECT_EQ(lines("bat.modes.csv"), modes);
}

TEST_F(OutputGroups, HoldFrfsAndModesInSeveralFormats) {
  const auto outcome =
      run_percuss({"analyze", record_, "--quiet", "--frf", folder_.file("a.csv"), "--frf", folder_.file("a.h5"),
                   "--modes-file", folder_.file("m.csv"), "--modes-file", folder_.file("m.json"), "--modes-file",
                   folder_.file("m.uff"), "-o", folder_.file("same.csv"), "-o", folder_.file("same.json")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(files(), UnorderedElementsAre("a.csv", "a.h5", "m.csv", "m.json", "m.uff", "same.csv", "same.json"));
  EXPECT_EQ(test::bytes_of(folder_.file("a.csv")), test::bytes_of(folder_.file("same.csv")));
  EXPECT_EQ(test::bytes_of(folder_.file("m.json")), test::bytes_of(folder_.file("same.json")));
  EXPECT_THAT(test::bytes_of(folder_.file("m.csv")), testing::StartsWith("mode,frequency_hz,"));
}

TEST_F(OutputGroups, RefuseOneNameOfFrfsTwice) {
  const auto outcome =
      run_percuss({"analyze", record_, "--frf", folder_.file("a.csv"), "--frf", folder_.file("a.csv")});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("is to be written twice"));
  const auto kind =
      run_percuss({"analyze", record_, "--modes-file", folder_.file("m.csv"), "--modes-file", folder_.file("m.h5")});
  EXPECT_EQ(kind.code, 2);
  EXPECT_THAT(files(), IsEmpty());
}

// The numbers of tests alone do not tell which file a mode is of.
TEST_F(OutputGroups, NameTheFileOfEachTest) {
  const std::string copy = folder_.file("copy.h5");
  test::write_bytes(copy, test::bytes_of(record_));
  const std::string table = folder_.file("two.modes.csv");
  const auto outcome = run_percuss({"analyze", record_, copy, "--files", "tests", "--quiet", "-o", table});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = test::lines_of(test::bytes_of(table));
  ASSERT_EQ(lines.size(), 1U + 2 * 2 * 2) << "two modes at two channels, of two tests";
  EXPECT_TRUE(lines[0].starts_with("test,mode,") && lines[0].ends_with(",residue_std,file")) << lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i)
    EXPECT_TRUE(lines[i].ends_with("," + (i <= 4 ? record_ : copy))) << lines[i];
}

TEST_F(OutputGroups, RefuseOneFileTwice) {
  const auto outcome = run_percuss({"analyze", record_, "--frf", folder_.file("a.csv"), "-o", folder_.file("a.csv")});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("is to be written twice"));
}

}  // namespace percuss::output_group_test
