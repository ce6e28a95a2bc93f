#pragma once
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

namespace percuss::test {

// Of a mode at 200 Hz with 1 % damping, from a record of 0.5 s without noise.
inline constexpr double kFrequencyTolerance_Hz = 0.1;

/// Files of small_record() in a folder, and the commands that read them.
class InputFiles : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return folder_.file(name); }
  ProcessOutcome analyze(std::vector<std::string> words, const std::string& input = "") const {
    words.insert(words.begin(), {"analyze", "--band", "60:1000", "--effort", "quick"});
    return run_percuss(words, {.input = input, .folder = folder_.path()});
  }
  // Runs the command that the message suggests, in the folder of the files.
  ProcessOutcome run_suggestion(const std::string& message) const {
    const std::string mark = "the samples suggest: percuss ";
    std::istringstream words(message.substr(message.find(mark) + mark.size()));
    std::vector<std::string> command;
    for (std::string word; words >> word;) command.push_back(word);
    return run_percuss(command, {.folder = folder_.path()});
  }
  static double first_mode_Hz(const ProcessOutcome& outcome) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return parse_json(outcome.out)["modes"].at(0)["frequency_hz"].get<double>();
  }

  ScratchFolder folder_;
  SmallRecord record_ = small_record();
};

}  // namespace percuss::test
