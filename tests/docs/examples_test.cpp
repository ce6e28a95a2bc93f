#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "core/units.hpp"
#include "support/help_pages.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/ping_file.hpp"
#include "support/scratch_folder.hpp"
#include "support/text_parts.hpp"
#include "synth/synthesise.hpp"

// Runs each example of --help in a shell, in a folder with the files that it reads.
namespace percuss::examples_test {

namespace fs = std::filesystem;
using test::quoted;
using test::run_percuss;

struct ShellOutcome {
  int code = -1;
  std::string err;
};

/// Runs a line with /bin/sh in `folder`, with percuss on the path. Stops at the first command that fails.
ShellOutcome run_in_shell(const std::string& line, const std::string& folder) {
  const test::ScratchFolder aside;
  test::write_bytes(aside.file("line"), line + "\n");
  const std::string programs = fs::path(PERCUSS_EXECUTABLE).parent_path();
  const std::string command = "cd " + quoted(folder) + " && PATH=" + quoted(programs) + ":$PATH /bin/sh -eu " +
                              quoted(aside.file("line")) + " >/dev/null 2>" + quoted(aside.file("err")) + " </dev/null";
  const int status = std::system(command.c_str());
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .err = test::bytes_of(aside.file("err"))};
}

// A hit on a mass of 1.25 kg. A force of 10 N accelerates it with 8 m/s²; the hammer's column CH8 then reads 1000.
std::string calibration_hits() {
  std::string hits = "t_s,CH8,acc_m_s2\n";
  for (int i = 0; i < 1000; ++i) {
    const bool hit = i >= 300 && i < 320;
    hits += std::to_string(i / 1000.0) + (hit ? ",1000,8\n" : i % 2 == 0 ? ",1,0\n" : ",-1,0\n");
  }
  return hits;
}

/// Prepares a folder with every file that the examples read and do not write themselves.
class Examples : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    prepared() = std::make_unique<test::ScratchFolder>();
    for (const std::string line : {
             "percuss synth composite-bat -o bat.h5",
             "percuss synth roving-barrel -o barrel.h5",
             "percuss convert bat.h5 bat.mat",
             "percuss frf bat.h5 --band 60:3200 -o frfs.h5",
             "percuss analyze bat.h5 --band 60:3200 --json > test.json",
             "percuss model beam --json > model.json",
             "rm bat.truth.json barrel.truth.json",
         }) {
      const auto outcome = run_in_shell(line, prepared()->path());
      ASSERT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    }
    acquire::write_hdf5(prepared()->file("scan.h5"), synth::synthesise(test::roving_beam_spec(3, 0.5, 13)).record,
                        false);
    test::write_bytes(prepared()->file("ping.wav"), test::wav_of(test::ping(1e-3)));
    test::write_bytes(prepared()->file("hits.csv"), calibration_hits());
    test::write_bytes(prepared()->file("profile.txt"), "2 50\n10 26\n45 28\n60 50\n84 66\n");
    test::write_bytes(prepared()->file("blade.csv"), "x,width,thickness\n0,100,25\n250,108,38\n550,108,30\n");
  }
  static void TearDownTestSuite() { prepared().reset(); }

  static std::unique_ptr<test::ScratchFolder>& prepared() {
    static std::unique_ptr<test::ScratchFolder> folder;
    return folder;
  }

  // Each example runs in a new folder of links to the prepared files, so that it finds no output of another example.
  static void expect_works(const std::string& line) {
    const test::ScratchFolder folder;
    for (const auto& entry : fs::directory_iterator(prepared()->path()))
      fs::create_symlink(entry.path(), folder.file(entry.path().filename()));
    const auto outcome = run_in_shell(line, folder.path());
    EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    // A note of what a format cannot keep is no fault of the example.
    EXPECT_EQ(std::regex_replace(outcome.err, std::regex("percuss: not kept: [^\n]*\n"), ""), "") << line;
  }
};

TEST_F(Examples, SucceedAsShown) {
  for (const auto& command : test::commands()) {
    for (const std::string& line : test::example_lines(command)) expect_works(line);
  }
}

TEST_F(Examples, AreShownForEveryCommandAndUseIt) {
  for (const auto& command : test::commands()) {
    const bool is_group = test::help_of(command).find("\nCommands:\n") != std::string::npos;
    const auto lines = test::example_lines(command);
    EXPECT_TRUE(is_group || !lines.empty()) << test::joined(command);
    for (const std::string& line : lines)
      EXPECT_THAT(line, testing::HasSubstr(test::joined({"percuss", test::joined(command)})));
  }
}

// The checks above would also pass if run_in_shell hid failures.
TEST_F(Examples, ReportFailures) {
  const test::ScratchFolder folder;
  EXPECT_EQ(run_in_shell("percuss analyze none.h5", folder.path()).code, 3);
  EXPECT_EQ(run_in_shell("percuss anaylze; true", folder.path()).code, 2);
  EXPECT_NE(run_in_shell("percuss analyze none.h5", folder.path()).err, "");
}

}  // namespace percuss::examples_test
