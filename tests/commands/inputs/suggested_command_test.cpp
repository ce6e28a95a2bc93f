#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <utility>

#include "commands/inputs/input_files.hpp"
#include "support/files/uff_text.hpp"

// The command that a message suggests for files that do not name their channels.
namespace percuss::suggested_command_test {

using test::run_percuss;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class SuggestedCommand : public test::InputFiles {
 protected:
  std::string suggestion(const std::vector<std::string>& words) const {
    const auto outcome = run_percuss(words, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U);
    return outcome.err;
  }
};

TEST_F(SuggestedCommand, LeavesOutNumbersOfHitsAndPoints) {
  const std::vector<double> zeros(record_.time_s.size(), 0.0);
  test::write_columns(file("x.csv"), "time_s,point,hit,run,CH1,CH2",
                      {record_.time_s, zeros, zeros, zeros, record_.accel_mps2, record_.force_N});
  EXPECT_THAT(suggestion({"analyze", "x.csv"}), EndsWith(" --force-channel CH2 --accel-channel CH1\n"));
}

TEST_F(SuggestedCommand, KeepsTheForceThatIsKnown) {
  test::write_columns(file("x.csv"), "time_s,CH1,CH2", {record_.time_s, record_.accel_mps2, record_.force_N});
  EXPECT_THAT(suggestion({"analyze", "x.csv", "--force-channel", "CH1"}),
              EndsWith(" --force-channel CH1 --accel-channel CH2\n"));
  test::write_columns(file("load.csv"), "time_s,CH1,load_N,CH2",
                      {record_.time_s, record_.force_N, record_.accel_mps2, record_.accel_mps2});
  EXPECT_THAT(suggestion({"analyze", "load.csv"}), EndsWith(" --force-channel load_N --accel-channel CH1,CH2\n"));
}

TEST_F(SuggestedCommand, KeepsTheAccelerationsThatAreTyped) {
  test::write_columns(file("x.csv"), "time_s,CH1,CH2,CH3",
                      {record_.time_s, record_.force_N, record_.force_N, record_.accel_mps2});
  EXPECT_THAT(suggestion({"frf", "x.csv", "--accel-channel", "ch1"}),
              EndsWith(" --force-channel CH2 --accel-channel ch1\n"));
}

TEST_F(SuggestedCommand, FollowsTheRolesOfASetUp) {
  test::write_columns(file("x.csv"), "time_s,CH1,CH2,CH3",
                      {record_.time_s, record_.force_N, record_.accel_mps2, record_.force_N});
  test::write_bytes(file("setup.json"), R"([{"name": "CH1", "role": "ignore"}])");
  EXPECT_THAT(suggestion({"analyze", "x.csv", "--setup", "setup.json"}),
              EndsWith(" --force-channel CH3 --accel-channel CH2\n"));
}

TEST_F(SuggestedCommand, AsksForTheSensitivityOfVolts) {
  test::write_columns(file("x.csv"), "time_s,CH1 (V),CH2 (V)", {record_.time_s, record_.force_N, record_.accel_mps2});
  EXPECT_THAT(suggestion({"analyze", "x.csv"}),
              EndsWith(" --force-channel 2 --accel-channel 3 --force-sensitivity NUMBERmV/N --accel-sensitivity "
                       "NUMBERmV/g\n"));
  EXPECT_THAT(suggestion({"analyze", "x.csv", "--accel-sensitivity", "100"}),
              EndsWith(" --accel-sensitivity 100 --force-channel 2 --accel-channel 3 --force-sensitivity "
                       "NUMBERmV/N\n"));
  EXPECT_THAT(suggestion({"analyze", "x.csv", "--force-sensitivity", "2.2mV/N"}),
              EndsWith(" --force-channel 2 --accel-channel 3 --accel-sensitivity NUMBERmV/g\n"));
  test::write_bytes(file("setup.json"), R"([{"name": "CH1", "sensitivity": 2.2, "sensitivity_unit": "mV/N"}])");
  EXPECT_THAT(suggestion({"analyze", "x.csv", "--setup", "setup.json"}),
              EndsWith(" --force-channel 2 --accel-channel 3 --accel-sensitivity NUMBERmV/g\n"));
}

// No option turns velocities into accelerations.
TEST_F(SuggestedCommand, IsNotGivenForVelocities) {
  test::write_columns(file("x.csv"), "time_s,force_N,laser (mm/s)",
                      {record_.time_s, record_.force_N, record_.accel_mps2});
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"analyze", "x.csv"}, {"analyze", "x.csv", "--accel-channel", "3"}})
    EXPECT_THAT(suggestion(words), AllOf(HasSubstr("velocity"), HasSubstr("mobility"), Not(HasSubstr("suggest"))));
}

TEST_F(SuggestedCommand, ReadsTablesOfFrfs) {
  std::vector<double> freq_Hz, re, im;
  for (int k = 10; k < 500; ++k) {
    const double r = k / 200.0;
    const std::complex<double> h = -r * r / std::complex<double>(1 - r * r, 0.02 * r);
    freq_Hz.push_back(k);
    re.push_back(h.real());
    im.push_back(h.imag());
  }
  test::write_columns(file("x.csv"), "X,real,imag", {freq_Hz, re, im});
  const std::string message = suggestion({"analyze", "x.csv", "--json"});
  EXPECT_THAT(message, EndsWith(" --frf-kind accelerance\n"));
  EXPECT_NEAR(first_mode_Hz(run_suggestion(message)), 200, test::kFrequencyTolerance_Hz);
  test::write_columns(file("f.csv"), "f,Re,Im", {freq_Hz, re, im});
  EXPECT_NEAR(first_mode_Hz(run_percuss({"analyze", file("f.csv"), "--json"})), 200, test::kFrequencyTolerance_Hz);
}

TEST_F(SuggestedCommand, NamesTheSignalsOfOneHitOfAUniversalFile) {
  std::string text;
  for (int hit = 0; hit < 2; ++hit) {
    for (const auto& [node, samples] : {std::pair{1, &record_.force_N}, std::pair{2, &record_.accel_mps2}}) {
      std::string numbers;
      for (std::size_t i = 0; i < samples->size(); ++i)  // four to a line
        numbers += fmt::format("{:20.12E}{}", (*samples)[i], i % 4 == 3 || i + 1 == samples->size() ? "\n" : "");
      text += test::UffText{.response_node = node,
                            .ordinate_type = 4,
                            .values = samples->size(),
                            .dx = fmt::format("{:13.5E}", record_.time_s[1] - record_.time_s[0]),
                            .ordinate = 0}
                  .text(numbers);
    }
  }
  test::write_bytes(file("x.uff"), text);
  const std::string message = suggestion({"analyze", "x.uff", "--json"});
  EXPECT_THAT(message, EndsWith(" --force-channel 1 --accel-channel 2\n"));
  EXPECT_NEAR(first_mode_Hz(run_suggestion(message)), 200, test::kFrequencyTolerance_Hz);
}

TEST_F(SuggestedCommand, NeedsNoRateWhereTimesOfDayGiveIt) {
  std::string text = "Timestamp,CH1,CH2\n";
  for (std::size_t i = 0; i < record_.time_s.size(); ++i) {
    text += fmt::format("07:08:{:09.6f},{},{}\n", 9.0 + record_.time_s[i], record_.force_N[i], record_.accel_mps2[i]);
  }
  test::write_bytes(file("stamp.csv"), text);
  EXPECT_THAT(suggestion({"analyze", "stamp.csv"}), EndsWith(" --force-channel CH1 --accel-channel CH2\n"));
}

// The steps of 0.244 may be milliseconds or Hz. A short pulse beside a long decay is no FRF.
TEST_F(SuggestedCommand, TakesTimesOfATestWithoutNamesAsMilliseconds) {
  std::vector<double> time_ms = record_.time_s;
  for (double& t : time_ms) t *= 1000;
  test::write_columns(file("x.csv"), "", {time_ms, record_.force_N, record_.accel_mps2});
  const double fs_Hz = 1 / (record_.time_s[1] - record_.time_s[0]);
  const std::string message = suggestion({"analyze", "x.csv", "--json"});
  EXPECT_THAT(message, EndsWith(fmt::format(" --force-channel 2 --accel-channel 3 --fs {:.6g}\n", fs_Hz)));
  EXPECT_NEAR(first_mode_Hz(run_suggestion(message)), 200, test::kFrequencyTolerance_Hz);
}

TEST_F(SuggestedCommand, AsksForTheRateWhereTheFirstColumnCountsSamples) {
  std::vector<double> count;
  for (std::size_t i = 0; i < record_.time_s.size(); ++i) count.push_back(static_cast<double>(i));
  test::write_columns(file("x.csv"), "n,CH1,CH2", {count, record_.force_N, record_.accel_mps2});
  EXPECT_THAT(suggestion({"analyze", "x.csv"}), EndsWith(" --fs HZ\n"));
}

// The guess of the roles reads a column that holds the text "lost". The message is still about the roles.
TEST_F(SuggestedCommand, IsGivenThoughAColumnHoldsAText) {
  std::string text;
  for (std::size_t i = 0; i < record_.time_s.size(); ++i) {
    const std::string last = i == 1000 ? "lost" : fmt::format("{}", record_.accel_mps2[i]);
    text += fmt::format("{},{},{}\n", 1000 * record_.time_s[i], record_.force_N[i], last);
  }
  test::write_bytes(file("x.csv"), text);
  EXPECT_THAT(suggestion({"analyze", "x.csv"}), HasSubstr("name the force and the accelerations"));
}

// A long command would hide the options. They are never cut.
TEST_F(SuggestedCommand, IsOnlyItsOptionsWhereItWouldBeLong) {
  std::vector<std::vector<double>> columns{record_.time_s, record_.force_N};
  std::string header = "time_s,hammer_channel_of_the_left_amplifier", accel;
  for (int i = 1; i <= 20; ++i) {
    accel += fmt::format("{}left_amplifier_signal_{}", i > 1 ? "," : "", i);
    columns.push_back(record_.accel_mps2);
  }
  test::write_columns(file("x.csv"), header + "," + accel, columns);
  ASSERT_GT(accel.size(), 400U);
  const std::string message = suggestion({"analyze", "x.csv"});
  EXPECT_THAT(message,
              EndsWith("--force-channel hammer_channel_of_the_left_amplifier --accel-channel " + accel + "\n"));
  std::vector<std::string> words{"analyze"};
  for (int i = 0; i < 8; ++i) {
    words.push_back(fmt::format("the_left_side_of_the_frame_struck_at_point_{}.csv", i));
    test::write_columns(file(words.back()), "", {record_.time_s, record_.force_N, record_.accel_mps2});
  }
  EXPECT_THAT(suggestion(words), AllOf(EndsWith("; the samples suggest: --force-channel 2 --accel-channel 3\n"),
                                       Not(HasSubstr("analyze"))));
}

TEST_F(SuggestedCommand, QuotesWhatAShellMayTakeForAPattern) {
  test::write_columns(file("m^2.csv"), "", {record_.time_s, record_.force_N, record_.accel_mps2});
  EXPECT_THAT(suggestion({"analyze", "m^2.csv"}),
              HasSubstr("; the samples suggest: percuss analyze 'm^2.csv' --force"));
}

// info describes a file that analyze accepts. If one of its columns may be the force, info lists the columns instead.
TEST_F(SuggestedCommand, IsReplacedByTheColumnsInInfoWhereAForceMayBeMissed) {
  const std::vector<double> zeros(record_.time_s.size(), 0.0);
  std::vector<double> count(record_.time_s.size());
  for (std::size_t i = 0; i < count.size(); ++i) count[i] = static_cast<double>(i);
  test::write_columns(file("hits.csv"), "time_s,hit,point,accel_g", {record_.time_s, zeros, zeros, record_.accel_mps2});
  test::write_columns(file("index.csv"), "CH0,index,time_s,accel_g",
                      {record_.force_N, count, record_.time_s, record_.accel_mps2});
  test::write_columns(file("first.csv"), "CH1,accel_g", {record_.force_N, record_.accel_mps2});
  const auto described = [&](const std::vector<std::string>& words) {
    std::vector<std::string> command{"info", "--json"};
    command.insert(command.end(), words.begin(), words.end());
    const auto outcome = run_percuss(command, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return test::parse_json(outcome.out)["files"].at(0);
  };
  const auto hits = described({"hits.csv"});
  ASSERT_TRUE(hits.contains("channels")) << hits;
  EXPECT_EQ(hits["channels"].size(), 1U);
  EXPECT_TRUE(described({"first.csv", "--fs", "4096"}).contains("columns"));
  EXPECT_TRUE(described({"index.csv"}).contains("columns"));
}

}  // namespace percuss::suggested_command_test
