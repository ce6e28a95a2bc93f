#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "support/help_pages.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/text_parts.hpp"

// The completion scripts. The tests run the script for bash; .ci/shells tests the scripts for zsh and fish.
namespace percuss::completion_command_test {

namespace fs = std::filesystem;
using test::quoted;
using test::run_percuss;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;

std::string script_for(const std::string& shell) {
  const auto outcome = run_percuss({"completion", shell});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

/// The lines that a shell prints when it runs `program` in `folder`.
std::vector<std::string> lines_from(const std::string& shell, const std::string& program, const std::string& folder) {
  const test::ScratchFolder aside;
  test::write_bytes(aside.file("program"), program);
  const std::string command = "cd " + quoted(folder) + " && " + shell + " " + quoted(aside.file("program")) + " >" +
                              quoted(aside.file("out")) + " 2>" + quoted(aside.file("err"));
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << shell << ": " << program;
  EXPECT_EQ(test::bytes_of(aside.file("err")), "");
  return test::lines_of(test::bytes_of(aside.file("out")));
}

/// A folder with a script and files to complete.
class CompletionCommand : public testing::Test {
 protected:
  CompletionCommand() {
    test::write_bytes(folder_.file("bat.h5"), "");
    test::write_bytes(folder_.file("my hits.csv"), "");
    fs::create_directory(folder_.file("figures"));
  }

  /// The completions of bash for the last of `words`; bash treats "=" as a word.
  std::vector<std::string> in_bash(const std::vector<std::string>& words) {
    test::write_bytes(folder_.file(".script"), script_for("bash"));
    std::string line;
    for (const std::string& word : words) line += " " + quoted(word);
    return lines_from("bash",
                      "set -u\n. ./.script\nCOMP_WORDS=(percuss" + line +
                          ")\nCOMP_CWORD=" + std::to_string(words.size()) +
                          "\n_percuss\n((${#COMPREPLY[@]})) && printf '%s\\n' \"${COMPREPLY[@]}\"\ntrue\n",
                      folder_.path());
  }

  test::ScratchFolder folder_;
};

TEST_F(CompletionCommand, CompletesCommands) {
  EXPECT_THAT(in_bash({"anal"}), ElementsAre("analyze"));
  EXPECT_THAT(in_bash({""}), IsSupersetOf({"analyze", "model", "synth", "completion", "man"}));
  EXPECT_THAT(in_bash({"model", ""}), ElementsAre("beam", "impact", "rigid", "trampoline", "bat", "shell"));
  EXPECT_THAT(in_bash({"model", "b"}), ElementsAre("beam", "bat"));
  EXPECT_THAT(in_bash({"fly", "t"}), IsEmpty());
}

TEST_F(CompletionCommand, CompletesTheCommandWhoseHelpIsAskedFor) {
  EXPECT_THAT(in_bash({"help", "anal"}), ElementsAre("analyze"));
  EXPECT_THAT(in_bash({"help", "model", ""}), ElementsAre("beam", "impact", "rigid", "trampoline", "bat", "shell"));
  EXPECT_THAT(in_bash({"help", "batch", "su"}), ElementsAre("submit"));
  EXPECT_THAT(in_bash({"help", "analyze", ""}), IsEmpty());
  EXPECT_THAT(in_bash({"help", "analyze", "--ba"}), IsEmpty());
}

TEST_F(CompletionCommand, CompletesOptionsOfTheCommand) {
  EXPECT_THAT(in_bash({"analyze", "--ba"}), UnorderedElementsAre("--band", "--bat", "--bat-id"));
  EXPECT_THAT(in_bash({"analyze", "bat.h5", "--json", "--es"}), ElementsAre("--estimator"));
  EXPECT_THAT(in_bash({"model", "beam", "--gy"}), ElementsAre("--gyration"));
  EXPECT_THAT(in_bash({"model", "rigid", "--gy"}), IsEmpty());
  EXPECT_THAT(in_bash({"--v"}), ElementsAre("--version"));
}

TEST_F(CompletionCommand, CompletesValues) {
  EXPECT_THAT(in_bash({"analyze", "--effort", ""}), ElementsAre("quick", "standard", "best"));
  EXPECT_THAT(in_bash({"analyze", "--effort", "=", "q"}), ElementsAre("quick"));
  EXPECT_THAT(in_bash({"analyze", "--effort", "="}), ElementsAre("quick", "standard", "best"));
  EXPECT_THAT(in_bash({"model", "beam", "--support", "t"}), ElementsAre("torsion"));
  EXPECT_THAT(in_bash({"analyze", "--only", "hits,m"}), ElementsAre("hits,modes"));
  EXPECT_THAT(in_bash({"completion", ""}), ElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(in_bash({"analyze", "--band", ""}), IsEmpty()) << "--band has no fixed values";
  EXPECT_THAT(in_bash({"synth", "wood"}), ElementsAre("wood-bat"));
}

TEST_F(CompletionCommand, CompletesFilesAndFolders) {
  EXPECT_THAT(in_bash({"analyze", "b"}), ElementsAre("bat.h5"));
  EXPECT_THAT(in_bash({"analyze", "my"}), ElementsAre("my hits.csv"));
  EXPECT_THAT(in_bash({"analyze", "bat.h5", "-o", "b"}), ElementsAre("bat.h5"));
  EXPECT_THAT(in_bash({"analyze", "--setup", "b"}), ElementsAre("bat.h5"));
  EXPECT_THAT(in_bash({"study", "--figures", ""}), ElementsAre("figures"));
  EXPECT_THAT(in_bash({"synth", "bat."}), ElementsAre("bat.h5")) << "a spec is a file too";
  EXPECT_THAT(in_bash({"model", "beam", "b"}), IsEmpty()) << "model beam takes no file";
}

TEST_F(CompletionCommand, KnowsEveryOptionOfEveryCommand) {
  for (auto words : test::commands()) {
    const auto names = test::option_names(words);
    words.emplace_back("--");
    EXPECT_THAT(in_bash(words), testing::UnorderedElementsAreArray(names));
  }
}

TEST_F(CompletionCommand, IsReproducible) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string script = script_for(shell);
    EXPECT_THAT(test::lines_of(script), Not(IsEmpty()));
    EXPECT_EQ(script, script_for(shell));
  }
  EXPECT_THAT(lines_from("bash -n", script_for("bash"), folder_.path()), IsEmpty());
}

}  // namespace percuss::completion_command_test
