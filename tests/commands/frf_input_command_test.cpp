#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::frf_input_command_test {

using nlohmann::json;
using test::lines_of;
using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

// Relative tolerance of a frequency: FRFs end at the edges of the band, and their fit does not model the end of the
// record.
constexpr double kFreqTolerance = 1e-5;
constexpr std::size_t kHits = 3;  // of write_small_test()

class FrfInput : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    test::write_small_test(file("bat.h5"));
    for (const char* kind : {"accelerance", "mobility", "receptance"}) {
      for (const char* end : {".csv", ".h5"}) {
        const std::string name = std::string(kind) + end;
        run_percuss({"frf", file("bat.h5"), "--band", "60:1000", "--kind", kind, "-o", file(name)});
      }
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static json analysed(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "analyze");
    arguments.emplace_back("--json");
    const auto outcome = run_percuss(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? test::parse_json(outcome.out) : json{{"modes", json::array()}};
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

TEST_F(FrfInput, IsWrittenOverTheLinesThatItHas) {
  run_percuss({"frf", file("bat.h5"), "--band", "100:400", "-o", file("part.csv")});
  run_percuss({"frf", file("part.csv"), "--band", "50:300", "-o", file("within.csv")});
  run_percuss({"frf", file("bat.h5"), "--band", "100:300", "-o", file("expected.csv")});
  // Frequency and real part of the first FRF.
  const auto rows_of = [](const std::string& path) {
    std::vector<std::pair<double, double>> rows;
    for (const std::string& line : lines_of(test::bytes_of(path))) {
      std::pair<double, double> row;
      if (std::sscanf(line.c_str(), "%lf,%lf", &row.first, &row.second) == 2) rows.push_back(row);
    }
    return rows;
  };
  const auto expected = rows_of(file("expected.csv")), within = rows_of(file("within.csv"));
  ASSERT_EQ(expected.size(), 201U);
  ASSERT_EQ(within.size(), expected.size());
  constexpr double kRounding = 1e-9;  // of transforms of other lengths
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(within[k].first, expected[k].first);
    EXPECT_NEAR(within[k].second, expected[k].second, kRounding * std::abs(expected[k].second));
  }
}

TEST_F(FrfInput, TakesNoUnitOfAccelerationForAMobility) {
  const auto outcome = run_percuss({"info", file("mobility.csv"), "--unit", "g"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("does not apply to the responses of a mobility"));
}

TEST_F(FrfInput, FindsTheModesOfTheRecord) {
  const json record = analysed({file("bat.h5"), "--band", "60:1000"});
  ASSERT_EQ(record["modes"].size(), 2U);
  for (const char* name :
       {"accelerance.csv", "accelerance.h5", "mobility.csv", "mobility.h5", "receptance.csv", "receptance.h5"}) {
    const json frfs = analysed({file(name)});
    ASSERT_EQ(frfs["modes"].size(), 2U) << name;
    for (std::size_t m = 0; m < 2; ++m) {
      const json &a = record["modes"][m], &b = frfs["modes"][m];
      const double f = a["frequency_hz"], zeta = a["damping_ratio"];
      EXPECT_LE(std::abs(b["frequency_hz"].get<double>() / f - 1), kFreqTolerance) << name;
      EXPECT_LE(std::abs(b["damping_ratio"].get<double>() / zeta - 1), 100 * kFreqTolerance) << name;
      EXPECT_EQ(b["family"], a["family"]) << name << ": the files of FRFs hold the angles";
      EXPECT_NEAR(b["residues"][0]["re"].get<double>(), a["residues"][0]["re"].get<double>(), 1e-3);
    }
  }
}

TEST_F(FrfInput, PrintsADocumentWithoutHitsThatFitsItsSchema) {
  for (const char* name : {"accelerance.csv", "mobility.h5"}) {
    const json document = analysed({file(name)});
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
    EXPECT_EQ(document["hits"], json::array());
    EXPECT_TRUE(document["fs_hz"].is_null());
    ASSERT_EQ(document["warnings"].size(), 1U) << "the only assumption is a force without noise";
    EXPECT_EQ(document["warnings"][0]["code"], "force_noise_unknown");
    EXPECT_GT(document["coherence"][0]["mean"], 0.9);
  }
}

TEST_F(FrfInput, CorrectsForTheWindowOfTheFrfs) {
  for (const char* name : {"windowed.csv", "windowed.h5"}) {
    run_percuss({"frf", file("bat.h5"), "--band", "60:1000", "--exponential", "0.01", "-o", file(name)});
    const json document = analysed({file(name)});
    ASSERT_EQ(document["modes"].size(), 2U) << name;
    EXPECT_NEAR(document["modes"][0]["damping_ratio"].get<double>(), 0.01, 1e-5) << name;
    EXPECT_GT(document["modes"][0]["damping_ratio_raw"].get<double>(), 0.013) << name;
  }
}

// percuss frf states the window. Without its comment, the table is that of a program which does not.
TEST_F(FrfInput, TakesTheWindowThatTheUserStates) {
  for (const char* kind : {"accelerance", "mobility", "receptance"}) {
    ASSERT_EQ(run_percuss({"frf", file("bat.h5"), "--band", "60:1000", "--exponential", "0.01", "--kind", kind, "-o",
                           file("stated.csv"), "--force"})
                  .code,
              0);
    const json stated = analysed({file("stated.csv")});
    const std::string text = test::bytes_of(file("stated.csv"));
    test::write_bytes(file("unstated.csv"), text.substr(text.find('\n') + 1));
    const std::vector<std::string> words{file("unstated.csv"), "--frf-kind", kind, "--angle", "0,90"};
    EXPECT_GT(analysed(words)["modes"][0]["damping_ratio"].get<double>(), 0.013) << "the window's damping is in it";
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--exponential", "0.01"});
    const json document = analysed(with);
    ASSERT_EQ(document["modes"].size(), 2U) << kind;
    for (std::size_t m = 0; m < 2; ++m) {
      const json &a = stated["modes"][m], &b = document["modes"][m];
      for (const char* key : {"frequency_hz", "damping_ratio", "damping_ratio_raw"}) {
        EXPECT_NEAR(b[key].get<double>() / a[key].get<double>(), 1, 1e-6) << kind << key;
      }
    }
    EXPECT_NEAR(document["modes"][0]["damping_ratio"].get<double>(), 0.01, 1e-5) << kind;
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
  }
  EXPECT_EQ(run_percuss({"analyze", file("stated.csv"), "--exponential", "0.01"}).code, 0) << "as the file states";
  const auto contradicted = run_percuss({"analyze", file("stated.csv"), "--exponential", "0.1"});
  EXPECT_EQ(contradicted.code, 3);
  EXPECT_THAT(contradicted.err, AllOf(HasSubstr("contradicts the FRFs"), HasSubstr("(--exponential)")));
}

TEST_F(FrfInput, TakesTheAveragesThatTheUserStates) {
  const std::string text = test::bytes_of(file("accelerance.csv"));
  ASSERT_THAT(lines_of(text).at(0), HasSubstr("averages "));
  // Neither the comment with the averages nor the standard deviations: columns 4 and 8 of 9.
  std::string bare = "# (m/s^2)/N\n";
  for (const std::string& line : lines_of(text.substr(text.find('\n') + 1))) {
    std::string out, cell;
    std::istringstream cells(line);
    for (int c = 0; std::getline(cells, cell, ','); ++c) {
      if (c != 3 && c != 7) out += (c == 0 ? "" : ",") + cell;
    }
    bare += out + "\n";
  }
  test::write_bytes(file("no-averages.csv"), bare);
  const std::vector<std::string> words{"analyze", file("no-averages.csv"), "--angle", "0,90"};
  const auto unstated = run_percuss(words);
  ASSERT_EQ(unstated.code, 0) << unstated.err;
  EXPECT_THAT(unstated.out, AllOf(HasSubstr("averages: not stated"), HasSubstr("(--averages)")));
  std::vector<std::string> with = words;
  with.insert(with.end(), {"--averages", std::to_string(kHits)});
  const auto stated = run_percuss(with);
  ASSERT_EQ(stated.code, 0) << stated.err;
  EXPECT_THAT(stated.out,
              AllOf(HasSubstr("averages: " + std::to_string(kHits)), testing::Not(HasSubstr("--averages"))));
  // The file of percuss holds the same standard deviations.
  const json own = analysed({file("accelerance.csv")});
  with.emplace_back("--json");
  const json document = test::parse_json(run_percuss(with).out);
  for (std::size_t m = 0; m < 2; ++m) {
    for (const char* key : {"frequency_std_hz", "damping_ratio_std"})
      EXPECT_NEAR(document["modes"][m][key].get<double>() / own["modes"][m][key].get<double>(), 1, 1e-3) << key;
  }
}

TEST_F(FrfInput, TakesFilesAsPointsAndSignsFromASetup) {
  test::write_bytes(file("setup.json"), R"([{"name": "1", "direction": "-x"}])");
  test::write_bytes(file("again.csv"), test::bytes_of(file("accelerance.csv")));
  const json document =
      analysed({file("accelerance.csv"), file("again.csv"), "--setup", file("setup.json"), "--angle", "0,90"});
  ASSERT_EQ(document["modes"].size(), 2U);
  const json residues = document["modes"][0]["residues"];
  ASSERT_EQ(residues.size(), 4U);
  EXPECT_EQ(residues[2]["point"], 1);
  EXPECT_NEAR(residues[0]["re"].get<double>(), -0.9, 1e-3);
  EXPECT_NEAR(residues[1]["re"].get<double>(), 0.3, 1e-3);
}

TEST_F(FrfInput, WarnsOfAssumptions) {
  std::string text = test::bytes_of(file("accelerance.csv"));
  test::write_bytes(file("bare.csv"), text.substr(text.find('\n') + 1));
  const json document = analysed({file("bare.csv")});
  EXPECT_THAT(document["warnings"].dump(), AllOf(HasSubstr("taken as accelerance"), HasSubstr("0° and 90° on a tube")));
  const json stated = analysed({file("bare.csv"), "--frf-kind", "accelerance", "--angle", "0,90"});
  ASSERT_EQ(stated["warnings"].size(), 1U);
  EXPECT_EQ(stated["warnings"][0]["code"], "force_noise_unknown");
  EXPECT_EQ(stated["modes"], document["modes"]);
}

TEST_F(FrfInput, IsDescribedInTheText) {
  const auto outcome = run_percuss({"analyze", file("mobility.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("FRFs (mobility)"), HasSubstr("1 point × 2 accelerometers"),
                                 HasSubstr("bending 1"), testing::Not(HasSubstr("verdict"))));
}

TEST_F(FrfInput, IsDescribedByInfo) {
  const auto outcome = run_percuss({"info", file("mobility.csv"), file("accelerance.h5"), "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("info")), IsEmpty());
  EXPECT_EQ(document["files"][0]["frf_kind"], "mobility");
  EXPECT_EQ(document["files"][0]["lines"], 941);
  EXPECT_EQ(document["files"][1]["kind"], "FRF HDF5");
  EXPECT_EQ(document["files"][1]["coherence"], true);
  EXPECT_THAT(run_percuss({"info", file("mobility.csv")}).out, HasSubstr("941 lines of 1 Hz from 60 to 1000 Hz"));
}

TEST_F(FrfInput, IsConvertedByFrf) {
  const auto outcome = run_percuss({"frf", file("receptance.h5"), "--kind", "mobility"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(lines_of(outcome.out).at(0), HasSubstr("mobility"));
  EXPECT_EQ(lines_of(outcome.out).size(), 943U);
}

TEST_F(FrfInput, RejectsOptionsThatDoNotApplyToTheInput) {
  const std::string frfs = file("accelerance.csv");
  const std::vector<std::pair<std::vector<std::string>, int>> cases{
      {{frfs, "--fs", "100"}, 3},
      {{frfs, "--averages", "7"}, 3},
      {{frfs, "--estimator", "h2"}, 3},
      {{frfs, "--reject-hit", "1"}, 3},
      {{frfs, "--band", "60:2000"}, 3},
      {{frfs, "--frf-kind", "impedance"}, 2},
      {{frfs, file("bat.h5")}, 3},
      {{frfs, file("mobility.h5"), "--files", "hits"}, 2},
      {{frfs, "--accel-channel", "7"}, 3},
      {{file("bat.h5"), "--frf-kind", "mobility"}, 2},
      {{frfs, "--averages", "0"}, 2},
      {{frfs, "--averages", "2.5"}, 2},
      {{file("bat.h5"), "--averages", "5"}, 2},
  };
  for (auto [arguments, code] : cases) {
    arguments.insert(arguments.begin(), "analyze");
    const auto outcome = run_percuss(arguments);
    EXPECT_EQ(outcome.code, code) << arguments.back() << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments.back();
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST_F(FrfInput, AcceptsFrfsOfZeros) {
  std::string text = "# accelerance (m/s^2)/N\nfrequency,re,im\n";
  for (int k = 0; k < 200; ++k) text += std::to_string(k) + ",0,0\n";
  test::write_bytes(file("silent.csv"), text);
  const json document = analysed({file("silent.csv")});
  EXPECT_EQ(document["modes"], json::array());
}

// Many FRFs are fitted by a separate method, which adds the decays that a record cut off. FRFs from a file do not state
// where their records ended.
TEST_F(FrfInput, FindsTheModesOfTheRecordFromManyPoints) {
  ASSERT_EQ(run_percuss({"synth", "roving-barrel", "-o", file("barrel.h5")}).code, 0);
  ASSERT_EQ(run_percuss({"frf", file("barrel.h5"), "-o", file("frfs.h5")}).code, 0);
  const auto outcome = run_percuss({"analyze", file("frfs.h5"), "--band", "60:3200", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.signal;
  const json modes = json::parse(outcome.out)["modes"];
  const std::vector<double> truth{205, 690, 1390, 2100, 2880};
  ASSERT_EQ(modes.size(), truth.size());
  for (std::size_t m = 0; m < truth.size(); ++m) {
    EXPECT_NEAR(modes.at(m).at("frequency_hz").get<double>(), truth[m], 1e-3)
        << "the record ends when the first mode has decayed to 0.6 %, which FRFs do not state";
  }
}

TEST_F(FrfInput, IsRejectedWhereARecordOrASoundIsRequired) {
  ASSERT_EQ(run_percuss({"convert", file("accelerance.csv"), file("frfs.uff")}).code, 0);
  const auto record = run_percuss({"deflect", file("frfs.uff")});
  EXPECT_EQ(record.code, 3);
  EXPECT_THAT(record.err, HasSubstr("the file holds FRFs, not a time record"));
  const auto sound = run_percuss({"convert", file("accelerance.csv"), file("frfs.wav")});
  EXPECT_EQ(sound.code, 2);
  EXPECT_THAT(sound.err, HasSubstr("cannot hold FRFs"));
}

}  // namespace percuss::frf_input_command_test
