#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "percuss/analysis.hpp"
#include "percuss/batch.hpp"
#include "percuss/deflection.hpp"
#include "percuss/survey.hpp"
#include "percuss/synth.hpp"
#include "percuss/write.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The public interface and the command line give equal documents. The structures hold the same numbers.
namespace percuss::api_results_test {

const Band kBand{.low_Hz = 60, .high_Hz = 3200};

std::string output_of(const std::vector<std::string>& arguments) {
  const test::ProcessOutcome outcome = test::run_percuss(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

class PublicResults : public testing::Test {
 protected:
  /// Writes the test of a preset to a file. Returns its path.
  std::string file_of(const std::string& preset) {
    const std::string path = folder_.file(preset + ".h5");
    write(path, synthesise_preset(preset).record);
    return path;
  }
  test::ScratchFolder folder_;
};

TEST_F(PublicResults, AnalysisDocumentEqualsThatOfAnalyze) {
  const std::string path = file_of("composite-bat");
  const Analysis analysis(open_record(path), {.band_Hz = kBand});
  EXPECT_EQ(analysis.json(), output_of({"analyze", path, "--band", "60:3200", "--json"}));
}

TEST_F(PublicResults, OptionsActAsTheFlagsOfAnalyze) {
  const std::string path = file_of("wood-bat");
  const AnalysisOptions options{.band_Hz = kBand,
                                .effort = Effort::quick,
                                .estimator = Estimator::hv,
                                .hits = {.reject_hit = {1}},
                                .modes = 2,
                                .exponential = 0.01,
                                .overlay_dB = 2,
                                .threads = 1};
  const ReadOptions read{.fs_Hz = 25000, .accel_channel = {"2", "1"}, .unit = "g", .angle_rad = {0, 1}};
  EXPECT_EQ(Analysis(open_record(path, read), options).json({.per_hit = true, .stabilisation = true}),
            output_of({"analyze",
                       path,
                       "--band",
                       "60:3200",
                       "--effort",
                       "quick",
                       "--estimator",
                       "hv",
                       "--reject-hit",
                       "2",
                       "--modes",
                       "2",
                       "--exponential",
                       "0.01",
                       "--overlay-db",
                       "2",
                       "--fs",
                       "25000",
                       "--accel-channel",
                       "2,1",
                       "--unit",
                       "g",
                       "--angle",
                       "0,57.29577951308232",
                       "--per-hit",
                       "--stabilisation",
                       "--json"}));
}

TEST_F(PublicResults, StructuresHoldTheNumbersOfTheDocument) {
  const Analysis analysis(open_record(file_of("composite-bat")), {.band_Hz = kBand});
  const auto document = test::parse_json(analysis.json());
  const std::vector<Mode> modes = analysis.modes();
  const std::vector<ModeClassification> types = analysis.classifications();
  ASSERT_EQ(modes.size(), document["modes"].size());
  for (const Mode& mode : modes) {
    const auto& stated = document["modes"][mode.index];
    EXPECT_EQ(mode.freq_Hz, stated["frequency_hz"]);
    EXPECT_EQ(mode.freq_std_Hz, stated["frequency_std_hz"]);
    EXPECT_EQ(mode.damping_ratio, stated["damping_ratio"]);
    EXPECT_EQ(mode.damping_ratio_std, stated["damping_ratio_std"]);
    EXPECT_EQ(name_of(types[mode.index].type), stated["family"]);
    EXPECT_EQ(types[mode.index].confidence, stated["confidence"]);
    ASSERT_EQ(mode.residues.size(), stated["residues"].size());
    for (std::size_t r = 0; r < mode.residues.size(); ++r) {
      EXPECT_EQ(mode.residues[r].value_per_kg.real(), stated["residues"][r]["re"]);
      EXPECT_EQ(mode.residues[r].std_per_kg, stated["residues"][r]["std"]);
    }
  }
  const std::vector<Hit> hits = analysis.hits();
  ASSERT_EQ(hits.size(), document["hits"].size());
  for (const Hit& hit : hits) {
    EXPECT_EQ(hit.peak_force_N, document["hits"][hit.index]["peak_force_n"]);
    EXPECT_EQ(hit.accepted, document["hits"][hit.index]["accepted"]);
    EXPECT_EQ(hit.findings.size(), document["hits"][hit.index]["findings"].size());
  }
  EXPECT_EQ(analysis.warnings().size(), document["warnings"].size());
  EXPECT_EQ(analysis.band_Hz().high_Hz, document["band_hz"][1]);
}

TEST_F(PublicResults, SurveyDocumentEqualsThatOfTheCommand) {
  const std::string path = file_of("roving-barrel");
  const Survey survey(open_record(path), {.analysis = {.band_Hz = kBand, .effort = Effort::quick}});
  const std::string document = output_of({"survey", path, "--band", "60:3200", "--effort", "quick", "--json"});
  EXPECT_EQ(survey.json(), document);
  const auto stated = test::parse_json(document);
  EXPECT_EQ(survey.macs().at(0).at(1).value, survey.macs().at(1).at(0).value);
  EXPECT_EQ(survey.shapes().size(), stated["modes"].size());
  ASSERT_TRUE(survey.geometry());
  EXPECT_TRUE(survey.geometry()->tube);
}

// A tube along z, with two lines and a face.
TEST_F(PublicResults, GeometriesKeepTheirAxisLinesAndFaces) {
  const std::string path = folder_.file("tube.csv");
  std::string text = "point,x_m,y_m,z_m\n";
  for (int ring = 0; ring < 3; ++ring) {
    for (int i = 0; i < 8; ++i) {
      const double angle_rad = i * std::numbers::pi / 4;
      text += fmt::format("{},{:.17g},{:.17g},{}\n", 8 * ring + i, 0.03 * std::cos(angle_rad),
                          0.03 * std::sin(angle_rad), 0.1 * ring);
    }
  }
  test::write_bytes(path, text + "line,0,1,9\nface,2,3,11,10\n");
  const Geometry geometry = read_geometry(path);
  EXPECT_TRUE(geometry.tube);
  EXPECT_EQ(geometry.axis, 2U);
  EXPECT_EQ(geometry.lines, (std::vector<std::array<int, 2>>{{0, 1}, {1, 9}}));
  EXPECT_EQ(geometry.faces, (std::vector<std::vector<int>>{{2, 3, 11, 10}}));

  const std::string record = file_of("roving-barrel");
  const Survey survey(open_record(record),
                      {.analysis = {.band_Hz = kBand, .effort = Effort::quick}, .geometry = geometry});
  EXPECT_EQ(survey.geometry()->axis, 2U);
  EXPECT_EQ(survey.geometry()->lines, geometry.lines);
  EXPECT_EQ(survey.geometry()->faces, geometry.faces);
  write(folder_.file("ours.svg"), survey);
  output_of({"survey", record, "--band", "60:3200", "--effort", "quick", "--geometry", path, "--quiet", "-o",
             folder_.file("theirs.svg")});
  EXPECT_EQ(test::bytes_of(folder_.file("ours.svg")), test::bytes_of(folder_.file("theirs.svg")));
}

TEST_F(PublicResults, DeflectionDocumentEqualsThatOfDeflect) {
  const std::string path = file_of("wood-bat");
  const DeflectionOptions options{.method = DeflectionMethod::drift_free, .free_body = true};
  const Deflections deflections(open_record(path), options);
  EXPECT_EQ(deflections.json(), output_of({"deflect", path, "--method", "drift-free", "--free-body", "--json"}));
  EXPECT_EQ(deflections.hits().at(0).peak_m, test::parse_json(deflections.json())["hits"][0]["peak_m"]);
}

TEST_F(PublicResults, FrfFileEqualsThatOfTheCommand) {
  const std::string path = file_of("wood-bat");
  const FrfSet frfs = estimate_frfs(open_record(path), {.band_Hz = kBand, .estimator = Estimator::h2});
  const std::string ours = folder_.file("ours.csv"), theirs = folder_.file("theirs.csv");
  write(ours, frfs, {.kind = FrfKind::mobility});
  output_of({"frf", path, "--band", "60:3200", "--estimator", "h2", "--kind", "mobility", "-o", theirs});
  EXPECT_EQ(test::bytes_of(ours), test::bytes_of(theirs));
}

TEST_F(PublicResults, FilesEqualThoseOfAnalyze) {
  const std::string path = file_of("wood-bat");
  const Analysis analysis(open_record(path), {.band_Hz = kBand, .effort = Effort::quick});
  for (const char* const kind : {".json", ".svg", ".csv", ".uff", ".h5", ".hdf5", ".mat"}) {
    const std::string ours = folder_.file("ours") + kind, theirs = folder_.file("theirs") + kind;
    write(ours, analysis);
    output_of({"analyze", path, "--band", "60:3200", "--effort", "quick", "--quiet", "-o", theirs});
    EXPECT_EQ(test::bytes_of(ours), test::bytes_of(theirs)) << kind;
  }
}

TEST_F(PublicResults, ArraysGiveTheModesOfTheirRecord) {
  const Record made = synthesise_preset("wood-bat").record;
  RecordArrays arrays{.fs_Hz = made.fs_Hz(), .angle_rad = {0, std::numbers::pi / 2}};
  for (std::size_t row = 0; row < made.rows(); ++row) {
    arrays.force_N.push_back(made.force_N(row));
    arrays.accel_mps2.push_back({made.accel_mps2(row, 0), made.accel_mps2(row, 1)});
  }
  const AnalysisOptions options{.band_Hz = kBand, .effort = Effort::quick};
  const std::vector<Mode> modes = Analysis(made, options).modes();
  const std::vector<Mode> again = Analysis(record_from_arrays(arrays), options).modes();
  ASSERT_EQ(again.size(), modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) EXPECT_EQ(again[m].freq_Hz, modes[m].freq_Hz);
}

TEST_F(PublicResults, FrfsGivenAsArraysGiveTheModesOfTheirFile) {
  const FrfSet frfs = estimate_frfs(synthesise_preset("wood-bat").record, {.band_Hz = kBand});
  const std::string path = folder_.file("frfs.h5");
  write(path, frfs);
  const FrfSet given = frfs_from_arrays({.freq_Hz = frfs.freq_Hz(), .frfs = frfs.frfs(), .kind = frfs.kind()});
  const std::vector<Mode> modes = Analysis(given, {.effort = Effort::quick}).modes();
  const std::vector<Mode> of_file = Analysis(open_frfs(path), {.effort = Effort::quick}).modes();
  ASSERT_EQ(modes.size(), of_file.size());
  for (std::size_t m = 0; m < modes.size(); ++m) EXPECT_EQ(modes[m].freq_Hz, of_file[m].freq_Hz);
}

TEST_F(PublicResults, TakeStatedAveragesAndTheWindowOfFrfs) {
  FrfSet frfs = estimate_frfs(synthesise_preset("wood-bat").record, {.band_Hz = kBand, .exponential = 0.01});
  std::vector<Frf> bare = frfs.frfs();
  for (Frf& one : bare) {
    one.std.clear();
    one.averages = 0;
  }
  const FrfSet given = frfs_from_arrays({.freq_Hz = frfs.freq_Hz(), .frfs = bare, .kind = frfs.kind()});
  const std::string path = folder_.file("bare.h5");
  write(path, given);
  EXPECT_TRUE(open_frfs(path).frfs()[0].std.empty());
  const FrfSet stated = open_frfs(path, {.averages = frfs.frfs()[0].averages});
  ASSERT_EQ(stated.frfs()[0].std.size(), frfs.freq_Hz().size());
  for (std::size_t k = 0; k < frfs.freq_Hz().size(); k += 100)
    EXPECT_NEAR(stated.frfs()[0].std[k] / frfs.frfs()[0].std[k], 1, 1e-6);
  const std::vector<Mode> modes = Analysis(frfs, {.effort = Effort::quick}).modes();
  const std::vector<Mode> again = Analysis(given, {.effort = Effort::quick, .exponential = 0.01}).modes();
  ASSERT_EQ(again.size(), modes.size());
  for (std::size_t m = 0; m < modes.size(); ++m) EXPECT_NEAR(again[m].damping_ratio / modes[m].damping_ratio, 1, 1e-6);
}

TEST_F(PublicResults, FrfsComeBackFromMobility) {
  constexpr double kRounding = 1e-13;  // two complex products
  const FrfSet frfs = estimate_frfs(synthesise_preset("wood-bat").record, {.band_Hz = Band{60, 600}});
  const FrfSet mobility = frfs.converted(FrfKind::mobility);
  const FrfSet back = frfs_from_arrays({mobility.freq_Hz(), mobility.frfs(), mobility.kind()}).converted(frfs.kind());
  for (std::size_t k = 0; k < frfs.freq_Hz().size(); ++k) {
    const std::complex<double> value = frfs.frfs()[0].value[k];
    EXPECT_NEAR(std::abs(back.frfs()[0].value[k] - value), 0, kRounding * std::abs(value));
  }
}

TEST_F(PublicResults, BatchGivesTheModesOfEachAnalysis) {
  const std::string path = file_of("wood-bat");
  const std::vector<std::string> paths{path, folder_.file("missing.h5"), path};
  std::atomic<int> called = 0;
  const std::vector<BatchResult> results =
      analyze_batch(paths, {.analysis = {.band_Hz = kBand, .effort = Effort::quick},
                            .threads = 2,
                            .on_result = [&](const BatchResult&) { ++called; }});
  ASSERT_EQ(results.size(), paths.size());
  EXPECT_EQ(called, 3);
  ASSERT_TRUE(results[1].error);
  EXPECT_EQ(results[1].error->where(), paths[1]);
  const std::vector<Mode> modes = Analysis(open_record(path), {.band_Hz = kBand, .effort = Effort::quick}).modes();
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(results[i].index, i);
    ASSERT_EQ(results[i].modes.size(), modes.size());
    EXPECT_EQ(results[i].modes[0].freq_Hz, modes[0].freq_Hz);
    EXPECT_EQ(results[i].classifications.size(), modes.size());
  }
}

TEST_F(PublicResults, SpecsGiveTheTestTheyDescribe) {
  const SynthTest test =
      synthesise({.modes = {{.freq_Hz = 200, .damping_ratio = 0.01}}, .hits = 2, .accel_noise = 1e-3, .seed = 7});
  EXPECT_EQ(test.record.rows(), 2U);
  const std::vector<Mode> modes = Analysis(test.record, {.band_Hz = Band{60, 1000}, .effort = Effort::quick}).modes();
  ASSERT_EQ(modes.size(), 1U);
  EXPECT_NEAR(modes[0].freq_Hz, test.modes.at(0).freq_Hz, 6 * modes[0].freq_std_Hz);
}

TEST_F(PublicResults, PagesStateTheTimeOfSourceDateEpoch) {
  const Analysis analysis(synthesise_preset("wood-bat").record, {.band_Hz = kBand});
  ASSERT_EQ(::setenv("SOURCE_DATE_EPOCH", "86400", 1), 0);
  write(folder_.file("a.html"), analysis);
  ASSERT_EQ(::unsetenv("SOURCE_DATE_EPOCH"), 0);
  EXPECT_THAT(test::bytes_of(folder_.file("a.html")), testing::HasSubstr("1970-01-02 00:00 UTC"));
}

TEST_F(PublicResults, PagesStateTheTitle) {
  const Analysis analysis(synthesise_preset("wood-bat").record, {.band_Hz = kBand});
  test::write_bytes(folder_.file("logo.svg"), R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"/>)");
  WriteOptions options{
      .title = {.title = "Bat 7", .customer = "A & B", .note = "Cold.", .logo = folder_.file("logo.svg")}};
  write(folder_.file("a.html"), analysis, options);
  for (const char* expected : {"Bat 7</h1>", "A &amp; B", "Cold.", "data:image/svg+xml;base64,"})
    EXPECT_THAT(test::bytes_of(folder_.file("a.html")), testing::HasSubstr(expected));
  options.title.logo = folder_.file("a.html");
  EXPECT_THROW(write(folder_.file("b.html"), analysis, options), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("b.html")));
}

}  // namespace percuss::api_results_test
