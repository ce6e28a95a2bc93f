#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <filesystem>

#include "commands/inputs/input_files.hpp"
#include "support/files/mat_builder.hpp"

// MAT files as users have them.
namespace percuss::matlab_inputs_test {

using test::kFrequencyTolerance_Hz;
using test::run_percuss;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

class MatlabInputs : public test::InputFiles {};

TEST_F(MatlabInputs, MayHoldTheTimeBesideTheSignal) {
  const std::size_t n = record_.time_s.size();
  const auto beside = [&](std::vector<double> x) {
    std::vector<double> out = record_.time_s;
    out.insert(out.end(), x.begin(), x.end());
    return out;
  };
  test::MatBuilder(file("tx.mat"), test::MatLevel::v5)
      .numbers("force", {n, 2}, beside(record_.force_N))
      .numbers("accel", {n, 2}, beside(record_.accel_mps2));
  EXPECT_NEAR(first_mode_Hz(analyze({"tx.mat", "--json"})), 200, kFrequencyTolerance_Hz);
  std::vector<double> all = beside(record_.force_N);
  all.insert(all.end(), record_.accel_mps2.begin(), record_.accel_mps2.end());
  test::MatBuilder(file("all.mat"), test::MatLevel::v5).numbers("data", {n, 3}, all);
  for (const auto& outcome : {analyze({"all.mat"}), run_percuss({"info", file("all.mat")})})
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("--force-channel 'data(:,2)' --accel-channel 'data(:,3)'\n"));
  EXPECT_NEAR(
      first_mode_Hz(analyze({"all.mat", "--force-channel", "data(:,2)", "--accel-channel", "data(:,3)", "--json"})),
      200, kFrequencyTolerance_Hz);
}

// As an analyser saves them: spectra beside the signals, and names that do not show which signal is the force.
TEST_F(MatlabInputs, WithoutRolesGetTheCommandThatWorks) {
  const std::size_t n = record_.force_N.size();
  test::MatBuilder(file("all.mat"), test::MatLevel::v5)
      .numbers("Time_domain", {n, 1}, record_.time_s)
      .numbers("Time_chan_1", {n, 1}, record_.accel_mps2)
      .numbers("Time_chan_2", {n, 1}, record_.force_N)
      .numbers("PSD_chan_1", {3, 1}, {1, 2, 3})
      .numbers("Auto_Correlation_1", {2 * n, 1}, std::vector<double>(2 * n, 1.0));
  const auto outcome = analyze({"all.mat", "--fs", "4096", "--json"});
  EXPECT_THAT(outcome.err, EndsWith("--force-channel Time_chan_2 --accel-channel Time_chan_1\n"));
  EXPECT_NEAR(first_mode_Hz(run_suggestion(outcome.err)), 200, kFrequencyTolerance_Hz);
}

// A struct array is a matrix for each field, and its rate is stated once per element.
TEST_F(MatlabInputs, OfStructArraysWithoutRolesGetTheCommandThatWorks) {
  const std::vector<double> fs_Hz{1 / (record_.time_s[1] - record_.time_s[0])};
  test::MatBuilder(file("array.mat"), test::MatLevel::v5)
      .structure("data", {"x", "y", "fs"},
                 {{record_.accel_mps2, record_.force_N, fs_Hz}, {record_.accel_mps2, record_.force_N, fs_Hz}});
  const auto outcome = analyze({"array.mat", "--json"});
  EXPECT_THAT(outcome.err, EndsWith("--force-channel data.y --accel-channel data.x\n"));
  EXPECT_NEAR(first_mode_Hz(run_suggestion(outcome.err)), 200, kFrequencyTolerance_Hz);
}

TEST_F(MatlabInputs, MayStateUnitsAndCoherence) {
  const std::size_t n = record_.force_N.size();
  for (const char* unit : {"accel_unit", "accelUnit", "unit_accel"}) {
    test::MatBuilder(file("u.mat"), test::MatLevel::v5)
        .numbers("force", {1, n}, record_.force_N)
        .numbers("accel", {1, n}, record_.accel_mps2)
        .numbers("fs", {1, 1}, {4096})
        .text(unit, "g");
    const auto document = test::parse_json(run_percuss({"info", file("u.mat"), "--json"}).out);
    EXPECT_EQ(document["files"][0]["channels"][1]["unit"], "g") << unit;
    std::filesystem::remove(file("u.mat"));
  }
  std::vector<std::complex<double>> frf, beside;
  std::vector<double> freq_Hz, coherence(400, 0.9);
  for (int k = 0; k < 400; ++k) {
    freq_Hz.push_back(k + 1);
    beside.emplace_back(k + 1, 0);
    frf.push_back(1.0 / std::complex<double>(1 - std::pow(freq_Hz.back() / 200, 2), 0.02 * freq_Hz.back() / 200));
  }
  beside.insert(beside.end(), frf.begin(), frf.end());
  test::MatBuilder(file("h.mat"), test::MatLevel::v5)
      .complex("H", {400, 2}, beside)
      .numbers("Cxy", {400, 1}, coherence);
  const auto outcome = run_percuss({"info", file("h.mat")});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("400 lines of 1 Hz from 1 to 400 Hz"), HasSubstr("with coherence")))
      << outcome.err;
}

}  // namespace percuss::matlab_inputs_test
