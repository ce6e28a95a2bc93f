#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "percuss/analysis.hpp"
#include "percuss/batch.hpp"
#include "percuss/deflection.hpp"
#include "percuss/error.hpp"
#include "percuss/metrics.hpp"
#include "percuss/models.hpp"
#include "percuss/survey.hpp"
#include "percuss/synth.hpp"
#include "percuss/write.hpp"
#include "support/help_pages.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::api_errors_test {

using test::input_error_of;
using testing::HasSubstr;

template <class Work>
std::string field_message(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.written(option_field);
  }
  return "no InputError";
}

TEST(OptionFields, AreTheIdentifierAndItsUnit) {
  const std::vector<std::pair<std::string, std::string>> expected{
      {"fs", "ReadOptions::fs_Hz"},
      {"accel_channel", "ReadOptions::accel_channel"},
      {"unit", "ReadOptions::unit"},
      {"averages", "ReadOptions::averages"},
      {"angle", "ReadOptions::angle_rad"},
      {"band", "AnalysisOptions::band_Hz"},
      {"overlay_db", "AnalysisOptions::overlay_dB"},
      {"from", "HitOptions::from_s"},
      {"driving_point", "SurveyOptions::driving_point"},
      {"force", "WriteOptions::overwrite"},
      {"force_sensitivity", "ReadOptions::force_sensitivity_VpN"},
      {"pressure_sensitivity", "ReadOptions::pressure_sensitivity_VpPa"},
      {"lowest", "DeflectionOptions::lowest_Hz"},
      {"survey.example", "survey.example"}};
  for (const auto& [id, field] : expected) EXPECT_EQ(option_field(id), field);
}

// Options that option_field() returns unchanged. They concern the terminal, the output files and their title block
// (PageTitle in C++), or documents that json() does not contain.
const std::set<std::string> kOfTheCommandLine{"bat",     "bat_id",     "beam",     "compare", "customer", "date",
                                              "example", "explain",    "frf",      "help",    "hits",     "json",
                                              "logo",    "modes_file", "note",     "only",    "operator", "output",
                                              "paper",   "quiet",      "specimen", "title",   "trace"};

TEST(OptionFields, ExistForTheOptionsOfTheCommandLine) {
  for (const char* const command : {"analyze", "frf", "survey", "deflect"}) {
    for (std::string id : test::option_names({command})) {
      id.erase(0, id.find_first_not_of('-'));
      std::replace(id.begin(), id.end(), '-', '_');
      EXPECT_EQ(option_field(id) == id, kOfTheCommandLine.contains(id)) << command << ' ' << id;
    }
  }
}

TEST(PublicErrors, NameTheFieldOfTheOption) {
  const Record record = synthesise_preset("wood-bat").record;
  EXPECT_THAT(field_message([&] { open_frfs("x.csv", {.averages = 0}); }), HasSubstr("(ReadOptions::averages)"));
  EXPECT_THAT(field_message([&] { Analysis(record, {.band_Hz = Band{.low_Hz = 10, .high_Hz = 5}}); }),
              HasSubstr("(AnalysisOptions::band_Hz)"));
  EXPECT_THAT(field_message([&] { find_hits(record, {.from_s = 2, .to_s = 1}); }),
              HasSubstr("(HitOptions::from_s, HitOptions::to_s)"));
  EXPECT_THAT(field_message([&] { Analysis(record, {.hits = {.accept_hit = {1}, .reject_hit = {1}}}); }),
              HasSubstr("HitOptions::accept_hit, HitOptions::reject_hit"));
  EXPECT_THAT(field_message([&] { find_hits(record, {.from_s = -0.1}); }), HasSubstr("(HitOptions::from_s)"));
  EXPECT_THAT(field_message([&] { find_hits(record, {.to_s = std::nan("")}); }),
              HasSubstr("(HitOptions::from_s, HitOptions::to_s)"));
  EXPECT_THAT(field_message([&] { find_hits(record, {.pretrigger_s = -1}); }), HasSubstr("(HitOptions::pretrigger_s)"));
}

TEST(PublicErrors, RefuseGeometriesThatDoNotFitTogether) {
  const Record record = synthesise_preset("wood-bat").record;
  const std::vector<GeometryPoint> one{{.xyz_m = std::array{0.0, 0.0, 0.0}}};
  const std::vector<std::pair<Geometry, std::string>> bad{
      {{.points = one, .lines = {{0, 7}}}, "point 7 is connected, but not listed"},
      {{.points = one, .faces = {{0, 0, 7}}}, "point 7 is connected, but not listed"},
      {{.points = one, .faces = {{0, 0}}}, "fewer than three corners"},
      {{.points = one, .axis = 3}, "no such axis"}};
  for (const auto& refused : bad)
    EXPECT_THAT(input_error_of([&] { Survey(record, {.geometry = refused.first}); }), HasSubstr(refused.second));
}

TEST(PublicErrors, RefuseArraysThatDoNotFitTogether) {
  const std::vector<double> four(4), three(3);
  const std::vector<RecordArrays> bad{{},
                                      {.fs_Hz = 100, .force_N = {four}, .accel_mps2 = {{three}}},
                                      {.fs_Hz = 100, .force_N = {four, four}, .accel_mps2 = {{four}}},
                                      {.fs_Hz = 100, .force_N = {four, four}, .accel_mps2 = {{four}, {four, four}}},
                                      {.fs_Hz = 0, .force_N = {four}, .accel_mps2 = {{four}}},
                                      {.fs_Hz = 100, .force_N = {{0, 0, std::nan(""), 0}}, .accel_mps2 = {{four}}},
                                      {.fs_Hz = 100, .force_N = {four}, .accel_mps2 = {{four}}, .point = {1, 2}},
                                      {.fs_Hz = 100, .force_N = {four}, .accel_mps2 = {{four}}, .point = {-5}},
                                      {.fs_Hz = 100, .force_N = {four}, .accel_mps2 = {{four}}, .angle_rad = {0, 1}}};
  for (const RecordArrays& arrays : bad) input_error_of([&] { record_from_arrays(arrays); });
}

TEST(PublicErrors, RefuseFrfsThatDoNotFitTogether) {
  const Frf two{.value = {1, 1}}, one{.value = {1}};
  const std::vector<FrfArrays> bad{{},
                                   {.freq_Hz = {1, 2}, .frfs = {one}},
                                   {.freq_Hz = {1, 2}, .frfs = {two, two}},
                                   {.freq_Hz = {1, 2.5}, .frfs = {two}},
                                   {.freq_Hz = {1, 2}, .frfs = {{.channel = 1, .value = {1, 1}}}},
                                   {.freq_Hz = {1, 2}, .frfs = {two}, .angle_rad = {0, 1}}};
  for (const FrfArrays& arrays : bad) input_error_of([&] { frfs_from_arrays(arrays); });
}

TEST(PublicErrors, RefuseRowsChannelsAndSamplesOutsideTheRecord) {
  const Record record = synthesise_preset("wood-bat").record;
  input_error_of([&] { record.force_N(5); });
  input_error_of([&] { record.accel_mps2(0, 2); });
  std::vector<double> out(2);
  input_error_of([&] { record.read_force_N(0, 25599, 2, out.data()); });
  constexpr std::size_t kLast = std::numeric_limits<std::size_t>::max();
  input_error_of([&] { record.read_force_N(0, kLast, 2, out.data()); });
}

TEST(PublicErrors, RefuseSeveralRunsInOneAnalysis) {
  const Record record =
      synthesise_json(R"({"schema": "percuss/synth/1", "name": "two", "fs_hz": 5000, "duration_s": 0.5,
    "modes": [{"frequency_hz": 200, "damping_ratio": 0.02, "family": "bending", "order": 1}], "hits": 2, "runs": 2})")
          .record;
  EXPECT_THAT(input_error_of([&] { Analysis analysis(record); }), HasSubstr("several runs"));
  EXPECT_THAT(input_error_of([&] { Survey survey(record); }), HasSubstr("several runs"));
  EXPECT_THAT(input_error_of([&] { find_hits(record); }), HasSubstr("several runs"));
  EXPECT_THAT(input_error_of([&] { estimate_frfs(record); }), HasSubstr("several runs"));
  EXPECT_THAT(input_error_of([&] { Deflections deflections(record); }), HasSubstr("several runs"));
  EXPECT_EQ(find_hits(record.runs()[0]).size(), 2U);
  ASSERT_EQ(record.runs().size(), 2U);
  EXPECT_EQ(Analysis(record.runs()[1]).hits().size(), 2U);
  EXPECT_EQ(analyze_batch(std::vector<Record>{record}).size(), 2U);
}

TEST(PublicErrors, KeepFilesThatExist) {
  const test::ScratchFolder folder;
  const Record record = synthesise_preset("wood-bat").record;
  test::write_bytes(folder.file("bat.h5"), "kept");
  EXPECT_THAT(field_message([&] { write(folder.file("bat.h5"), record); }), HasSubstr("(WriteOptions::overwrite)"));
  EXPECT_EQ(test::bytes_of(folder.file("bat.h5")), "kept");
  EXPECT_THAT(input_error_of([&] { write(folder.file("bat.xyz"), record); }), HasSubstr(".h5"));
}

TEST(PublicErrors, NameTheFieldOfAModel) {
  EXPECT_THAT(input_error_of([] { beam_modes({.ei_Nm2 = 0}); }), HasSubstr("Beam::ei_Nm2"));
  EXPECT_THAT(input_error_of([] { hoop_Hz({.wall_m = 1}, 2, 1); }), HasSubstr("Tube::wall_m"));
  EXPECT_THAT(input_error_of([] {
                bat_modes({.end_m = {0.4, 0.2}, .diameter_m = {0.03, 0.06}});
              }),
              HasSubstr("BatProfile::end_m"));
  EXPECT_THAT(input_error_of([] { bat_performance({.length_m = Measured{0.2}}); }), HasSubstr("length_m"));
}

}  // namespace percuss::api_errors_test
