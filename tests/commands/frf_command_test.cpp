#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <sstream>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::frf_command_test {

using nlohmann::json;
using test::lines_of;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;

class FrfCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_small_test(file("bat.h5"));
    test::write_small_test(file("missing.h5"), R"("hits": 1, "faults": [{"hit": 0, "kind": "missing"}])");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static test::ProcessOutcome frf(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "frf");
    return run_percuss(arguments);
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
  return numbers;
}

/// The numbers of the line of `csv` at this frequency.
std::vector<double> line_at(const std::string& csv, double freq_Hz) {
  for (const auto& line : lines_of(csv)) {
    if (line.empty() || line[0] == '#' || line[0] == 'f') continue;
    auto numbers = numbers_of(line);
    if (std::abs(numbers[0] - freq_Hz) < 0.1) return numbers;
  }
  ADD_FAILURE() << "no line at " << freq_Hz << " Hz";
  return std::vector<double>(9);
}

double magnitude(const std::vector<double>& line) { return std::hypot(line.at(1), line.at(2)); }

TEST_F(FrfCommand, PrintsTheFrfsAsText) {
  const auto outcome = frf({file("bat.h5"), "--band", "60:1000"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto lines = lines_of(outcome.out);
  EXPECT_THAT(lines.at(0), AllOf(HasSubstr("accelerance"), HasSubstr("H1")));
  EXPECT_THAT(lines.at(1), testing::StartsWith("frequency_hz,"));
  EXPECT_EQ(lines.size(), 2U + 941U) << "1 Hz from 60 to 1000 Hz, both included";
  // At resonance the accelerance is A / 2ζ, 90 degrees ahead of the force.
  const auto peak = line_at(outcome.out, 200);
  EXPECT_NEAR(magnitude(peak), 0.9 / 0.02, 0.5);
  EXPECT_GT(peak[2], 0) << "−ω²A/(2jζω²) = +jA/2ζ";
}

TEST_F(FrfCommand, ConvertsToMobilityAndReceptance) {
  const double omega = 2 * std::numbers::pi * 200;
  const auto magnitude_of = [&](const char* kind) {
    return magnitude(line_at(frf({file("bat.h5"), "--kind", kind}).out, 200));
  };
  const double accelerance = magnitude_of("accelerance");
  EXPECT_NEAR(magnitude_of("mobility") / (accelerance / omega), 1, 1e-6);
  EXPECT_NEAR(magnitude_of("receptance") / (accelerance / omega / omega), 1, 1e-6);
}

TEST_F(FrfCommand, WritesTheRequestedFiles) {
  const auto outcome =
      frf({file("bat.h5"), "--estimator", "hv", "-o", file("frf.csv"), "-o", file("frf.h5"), "-o", file("frf.json")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(test::bytes_of(file("frf.csv")), frf({file("bat.h5"), "--estimator", "hv"}).out);
  const json summary = test::parse_json(test::bytes_of(file("frf.json")));
  EXPECT_THAT(test::schema_violations(summary, test::schema_named("analysis")), testing::IsEmpty());
  EXPECT_EQ(summary["frf"]["averages"][0]["averages"], 3);
  EXPECT_GT(summary["coherence"][0]["mean"], 0.9);
  EXPECT_EQ(test::bytes_of(file("frf.h5")).substr(1, 3), "HDF");
}

TEST_F(FrfCommand, WritesEqualFilesOfBothExtensionsOfHdf5) {
  ASSERT_EQ(frf({file("bat.h5"), "-o", file("both.h5"), "-o", file("both.hdf5")}).code, 0);
  EXPECT_EQ(test::bytes_of(file("both.hdf5")), test::bytes_of(file("both.h5")));
  ASSERT_EQ(run_percuss({"analyze", file("bat.h5"), "-o", file("modes.hdf5")}).code, 0);
  EXPECT_EQ(test::bytes_of(file("modes.hdf5")).substr(1, 3), "HDF");
}

TEST_F(FrfCommand, OverwritesOnlyWhenForced) {
  for (const char* name : {"kept.csv", "kept.h5", "kept.json"}) {
    test::write_bytes(file(name), "mine");
    const auto refused = frf({file("bat.h5"), "-o", file(name)});
    EXPECT_EQ(refused.code, 3);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, AllOf(HasSubstr(file(name)), HasSubstr("--force")));
    EXPECT_EQ(lines_of(refused.err).size(), 1U);
    EXPECT_EQ(test::bytes_of(file(name)), "mine");
    EXPECT_EQ(frf({file("bat.h5"), "-o", file(name), "--force"}).code, 0);
    EXPECT_NE(test::bytes_of(file(name)), "mine");
  }
}

TEST_F(FrfCommand, RejectsUnknownKindsOfFile) {
  for (const char* name : {"frf.txt", "frf", "frf.csv.gz"}) {
    const auto outcome = frf({file("bat.h5"), "-o", file(name)});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(file(name)), HasSubstr(".csv, .h5, .hdf5, .json")));
  }
  EXPECT_EQ(frf({file("bat.h5"), "--kind", "impedance"}).code, 2);
}

TEST_F(FrfCommand, WritesNothingWithoutAnFrf) {
  const auto outcome = frf({file("missing.h5"), "-o", file("none.csv"), "-o", file("none.h5"), "--json"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(test::parse_json(outcome.out)["hits"][0]["findings"][0]["code"], "no_pulse");
  EXPECT_FALSE(std::filesystem::exists(file("none.csv")));
  EXPECT_FALSE(std::filesystem::exists(file("none.h5")));
}

}  // namespace percuss::frf_command_test
