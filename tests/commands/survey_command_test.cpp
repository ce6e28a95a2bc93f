#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::survey_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class SurveyCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::ScratchFolder>();
    synth::SynthSpec spec{.fs_Hz = 4096, .samples = 4096, .band_high_Hz = 1500};
    spec.modes = {
        {.freq_Hz = 205, .damping_ratio = 0.02, .order = 1, .angle_rad = 0.3},
        {.freq_Hz = 1100, .damping_ratio = 0.006, .type = synth::SynthModeType::hoop, .order = 1, .angle_rad = 0.1}};
    spec.sensors = {{.position_m = 0.05, .angle_rad = 0}};
    spec.points.clear();
    for (std::size_t p = 0; p < 18; ++p) {
      const std::size_t ring = p / 6;
      spec.points.push_back({.position_m = 0.05 + 0.08 * static_cast<double>(ring),
                             .angle_rad = static_cast<double>(p % 6) * std::numbers::pi / 3});
    }
    spec.hits = 2;
    spec.noise = {.force = 1e-4, .accel = 1e-3};
    acquire::Record record = synth::synthesise(spec).record;
    acquire::write_hdf5(file("barrel.h5"), record, true);
    record.geometry.clear();
    acquire::write_hdf5(file("bare.h5"), record, true);
    write_parts(record);
    test::write_bytes(file("points.csv"), geometry_from(0));
    test::write_bytes(file("from_one.csv"), geometry_from(1));
    test::write_small_test(file("runs.h5"), R"("hits": 1, "runs": 2)");
    test::write_small_test(file("missing.h5"), R"("hits": 1, "faults": [{"hit": 0, "kind": "missing"}])");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  // A geometry file of the 18 points, which counts them from `first`.
  static std::string geometry_from(std::size_t first) {
    std::string text = "point,position_mm,angle_deg\n";
    for (std::size_t p = 0; p < 18; ++p) text += fmt::format("{},{},{}\n", p + first, 50 + 80 * (p / 6), 60 * (p % 6));
    return text;
  }
  // The points as files points/P1.h5 …, and the hits as files hits/P1_1.h5 …
  static void write_parts(const acquire::Record& record) {
    std::filesystem::create_directory(file("points"));
    std::filesystem::create_directory(file("hits"));
    const auto write = [&](const std::string& name, auto keep) {
      acquire::Record part = acquire::select_rows(record, keep);
      for (acquire::RowInfo& row : part.rows) row.point = 0;
      acquire::write_hdf5(file(name), part, true);
    };
    for (int p = 0; p < 18; ++p) {
      write(fmt::format("points/P{}.h5", p + 1), [&](const acquire::RowInfo& row) { return row.point == p; });
      for (int h = 0; h < 2; ++h) {
        int before = 0;
        write(fmt::format("hits/P{}_{}.h5", p + 1, h + 1),
              [&](const acquire::RowInfo& row) { return row.point == p && before++ == h; });
      }
    }
  }
  // The warnings as "code: message".
  static std::vector<std::string> messages_of(const json& document) {
    std::vector<std::string> out;
    for (const json& warning : document["warnings"])
      out.push_back(warning["code"].get<std::string>() + ": " + warning["message"].get<std::string>());
    return out;
  }
  static std::string file(const std::string& name) { return folder_->file(name); }
  static test::ProcessOutcome survey(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"survey", "--band", "60:1500"});
    return run_percuss(arguments);
  }
  static json document_of(std::vector<std::string> arguments, int code = 0) {
    arguments.emplace_back("--json");
    const auto outcome = survey(std::move(arguments));
    EXPECT_EQ(outcome.code, code) << outcome.err;
    json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
    return document;
  }
  inline static std::unique_ptr<test::ScratchFolder> folder_;
};

TEST_F(SurveyCommand, PrintsShapesAndNames) {
  const auto outcome = survey({file("bare.h5"), "--geometry", file("points.csv")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("bending 1"), HasSubstr("hoop 1"), HasSubstr("MPC"), HasSubstr("nodes"),
                                 HasSubstr("36 hits"), HasSubstr("FRAC")));
}

TEST_F(SurveyCommand, PrintsTheDocumentWithShapes) {
  const json document = document_of({file("bare.h5"), "--geometry", file("points.csv")});
  EXPECT_EQ(document["roving"], "hammer");
  EXPECT_EQ(document["geometry"]["from"], "file");
  ASSERT_EQ(document["modes"].size(), 2U);
  EXPECT_EQ(document["modes"][0]["family"], "bending");
  EXPECT_EQ(document["modes"][0]["shape"]["circumferential_order"], 1);
  EXPECT_EQ(document["modes"][1]["family"], "hoop");
  EXPECT_EQ(document["modes"][1]["shape"]["circumferential_order"], 2);
  EXPECT_EQ(document["modes"][1]["shape"]["axial_order"], 0);
  EXPECT_EQ(document["modes"][1]["shape"]["values"].size(), 18U);
  EXPECT_EQ(document["modes"][1]["shape"]["normalisation"], "unit_modal_mass") << "point 0 lies at the sensor";
  EXPECT_EQ(document["auto_mac"]["value"][0][0], 1);
  EXPECT_EQ(document["frac"].size(), 18U);
}

// Without P7, the points that follow keep their places and names. The document holds indices.
TEST_F(SurveyCommand, TakesTheNumbersInTheNamesOfFiles) {
  const json all = document_of({file("points"), "--geometry", file("from_one.csv"), "--driving-point", "P1:0"});
  EXPECT_THAT(messages_of(all), Not(Contains(HasSubstr("points_from_one"))));
  std::filesystem::rename(file("points/P7.h5"), file("P7.h5"));
  const auto outcome = survey({file("points"), "--geometry", file("from_one.csv"), "--driving-point", "P8:0", "--hits",
                               "--force", "-o", file("s.html"), "-o", file("s.json"), "-o", file("s.csv")});
  std::filesystem::rename(file("P7.h5"), file("points/P7.h5"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("from the driving point 8 (P8.h5, "),
                                 HasSubstr("1 of the geometry's 18 points were not measured: 7;")));
  EXPECT_THAT(test::bytes_of(file("s.html")),
              AllOf(HasSubstr("\"6 (P6.h5)\",\"8 (P8.h5)\""), HasSubstr("not drawn: point 7 of the geometry")));
  const json document = test::parse_json(test::bytes_of(file("s.json")));
  EXPECT_EQ(document["driving_point"][0]["point"], 6);
  ASSERT_EQ(document["modes"].size(), all["modes"].size());
  EXPECT_EQ(document["modes"][1]["shape"]["circumferential_order"], 2);
  const std::string place = ",6,0,0.13,", row = test::lines_of(test::bytes_of(file("s.csv"))).at(7);
  ASSERT_THAT(row, HasSubstr(place));
  EXPECT_NEAR(std::stod(row.substr(row.find(place) + place.size())), 60, 1e-9) << "the angle of P8, the seventh file";
}

TEST_F(SurveyCommand, RefusesAFileWhoseNumberTheGeometryLacks) {
  std::string geometry = test::bytes_of(file("from_one.csv"));
  geometry.erase(geometry.find("\n5,") + 1, geometry.find("\n6,") - geometry.find("\n5,"));
  test::write_bytes(file("without_5.csv"), geometry);
  const auto outcome = survey({file("points"), "--geometry", file("without_5.csv")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the geometry lacks point 5, the number in the name of P5.h5"),
                                 HasSubstr("percuss convert --files")));
}

TEST_F(SurveyCommand, TakesFilesOfOneNameAsHitsOfOnePoint) {
  const json points = document_of({file("points"), "--geometry", file("from_one.csv")});
  const json hits = document_of({file("hits"), "--geometry", file("from_one.csv")});
  EXPECT_EQ(hits["hits"].size(), 36U);
  EXPECT_EQ(hits["hits"][2]["point"], 1);
  ASSERT_EQ(hits["modes"].size(), points["modes"].size());
  // A file of one hit is searched for its pulse, so that the lengths of the hits differ a little.
  const auto close = [](const json& a, const json& b, const char* value, const char* std) {
    EXPECT_NEAR(a[value].get<double>(), b[value].get<double>(), a[std].get<double>()) << value;
  };
  for (std::size_t m = 0; m < 2; ++m) {
    close(hits["modes"][m], points["modes"][m], "frequency_hz", "frequency_std_hz");
    for (std::size_t p = 0; p < 18; ++p)
      close(hits["modes"][m]["residues"][p], points["modes"][m]["residues"][p], "re", "std");
  }
  EXPECT_THAT(messages_of(hits), Contains(HasSubstr("the 36 files are hits of 18 points, by their names: P1_1.h5, "
                                                    "P1_2.h5 are hits of one point")));
  // Without a geometry, the responses decide.
  EXPECT_EQ(document_of({file("hits")})["hits"][2]["point"], 1);
  EXPECT_EQ(document_of({file("hits"), "--files", "points"})["hits"][2]["point"], 2);
}

// Names with two numbers, whatever the words are. The point's number may stand second.
TEST_F(SurveyCommand, TakesFilesWithTwoNumbersAsHitsOfPoints) {
  for (const bool point_first : {true, false}) {
    const std::string folder = point_first ? "schlag" : "punkt";
    std::filesystem::create_directory(file(folder));
    for (int p = 1; p <= 18; ++p) {
      for (int h = 1; h <= 2; ++h) {
        const std::string name =
            point_first ? fmt::format("Punkt{:02}_Schlag{}", p, h) : fmt::format("Schlag{}_Punkt{:02}", h, p);
        std::filesystem::copy_file(file(fmt::format("hits/P{}_{}.h5", p, h)), file(folder + "/" + name + ".h5"));
      }
    }
    for (const std::vector<std::string>& geometry :
         std::vector<std::vector<std::string>>{{"--geometry", file("from_one.csv")}, {}}) {
      if (!point_first && geometry.empty()) continue;  // each file is a point then
      std::vector<std::string> arguments{file(folder)};
      arguments.insert(arguments.end(), geometry.begin(), geometry.end());
      const json document = document_of(arguments);
      const std::size_t second = point_first ? 2 : 1;
      EXPECT_EQ(document["hits"][second]["point"], 1) << folder;
      EXPECT_EQ(document["hits"][35]["point"], 17) << folder;
      EXPECT_THAT(messages_of(document), Contains(HasSubstr("the 36 files are hits of 18 points, by their names")));
    }
  }
  const auto refused = survey({file("schlag"), "--geometry", file("from_one.csv"), "--files", "points"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("name them P1_hit1, P1_hit2, P2_hit1"), HasSubstr("convert --files")));
}

// The numbers of rows and columns: the responses of one row differ.
TEST_F(SurveyCommand, TakesRowsAndColumnsAsPoints) {
  std::filesystem::create_directory(file("rows"));
  for (int p = 0; p < 18; ++p) {
    std::filesystem::copy_file(file(fmt::format("points/P{}.h5", p + 1)),
                               file(fmt::format("rows/R{}C{}.h5", 1 + p / 6, 1 + p % 6)));
  }
  for (const std::vector<std::string>& geometry :
       std::vector<std::vector<std::string>>{{"--geometry", file("from_one.csv")}, {}}) {
    std::vector<std::string> arguments{file("rows")};
    arguments.insert(arguments.end(), geometry.begin(), geometry.end());
    EXPECT_EQ(document_of(arguments)["hits"][35]["point"], 17);
  }
}

// Points of a grid that are numbered by row and column.
TEST_F(SurveyCommand, TakesFilesWithOtherResponsesAsPoints) {
  std::filesystem::create_directory(file("grid"));
  for (int p = 0; p < 18; ++p) {
    std::filesystem::copy_file(file(fmt::format("points/P{}.h5", p + 1)),
                               file(fmt::format("grid/{}_{}.h5", 1 + p / 6, 1 + p % 6)));
  }
  const json document = document_of({file("grid")});
  EXPECT_EQ(document["hits"][35]["point"], 17);
  EXPECT_THAT(messages_of(document),
              Contains(AllOf(HasSubstr("files_as_points: each of the 18 files is taken as a point"),
                             HasSubstr("percuss convert "), HasSubstr("1_6.h5 --files hits -o "))));
  const json placed = document_of({file("grid"), "--geometry", file("from_one.csv")});
  EXPECT_EQ(placed["hits"][35]["point"], 17);
  EXPECT_THAT(messages_of(placed), Not(Contains(HasSubstr("files_as_points")))) << "as many points as files";
}

// The record counts its points from 0.
TEST_F(SurveyCommand, ReadsGeometryNumberedFromOne) {
  const json document = document_of({file("bare.h5"), "--geometry", file("from_one.csv")});
  const json expected = document_of({file("bare.h5"), "--geometry", file("points.csv")});
  EXPECT_EQ(document["modes"], expected["modes"]);
  EXPECT_THAT(messages_of(document), Contains(StartsWith("points_from_one: ")));
}

// Coordinates without z and without units: metres, and the document says so. Large ones need a unit.
TEST_F(SurveyCommand, ReadsCoordinatesWithoutUnits) {
  const auto table = [](const char* names, double scale) {
    std::string text = std::string(names) + "\n";
    for (std::size_t p = 0; p < 18; ++p)
      text += fmt::format("{},{},{}\n", p, scale * static_cast<double>(p / 6), scale * static_cast<double>(p % 6));
    return text;
  };
  test::write_bytes(file("bare.csv"), table("point,x,y", 0.05));
  test::write_bytes(file("unit.csv"), table("point,x_m,y_m", 0.05));
  test::write_bytes(file("large.csv"), table("point,x,y", 50));
  const json document = document_of({file("bare.h5"), "--geometry", file("bare.csv")});
  EXPECT_EQ(document["modes"], document_of({file("bare.h5"), "--geometry", file("unit.csv")})["modes"]);
  EXPECT_THAT(messages_of(document), Contains(StartsWith("geometry_unit_assumed: ")));
  const auto large = survey({file("bare.h5"), "--geometry", file("large.csv")});
  EXPECT_EQ(large.code, 3);
  EXPECT_THAT(large.err, HasSubstr("call the column x_mm if they are in mm, x_m in m, x_in in inches"));
}

// The lines and faces of such a file count from 1 as its points do.
TEST_F(SurveyCommand, DrawsAGeometryNumberedFromOneAlike) {
  const auto drawn = [&](const std::string& name, std::size_t first) {
    std::string text = geometry_from(first);
    const auto number = [&](std::size_t p) { return "," + std::to_string(p + first); };
    text +=
        "line" + number(0) + number(6) + number(12) + "\nface" + number(0) + number(1) + number(7) + number(6) + "\n";
    test::write_bytes(file("connected.csv"), text);
    const auto outcome = survey({file("bare.h5"), "--geometry", file("connected.csv"), "--force", "-o", file(name)});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return test::bytes_of(file(name));
  };
  EXPECT_TRUE(drawn("one.glb", 1) == drawn("zero.glb", 0));
}

TEST_F(SurveyCommand, UsesTheGeometryAndDrivingPointOfTheRecord) {
  const json document = document_of({file("barrel.h5")});
  EXPECT_EQ(document["geometry"]["from"], "record");
  EXPECT_EQ(document["geometry"]["tube"], true);
  EXPECT_EQ(document["modes"][1]["shape"]["normalisation"], "unit_modal_mass");
  ASSERT_EQ(document["driving_point"].size(), 2U);
  EXPECT_EQ(document["driving_point"][0]["wrong_sign"], false);
  const json named = document_of({file("bare.h5"), "--driving-point", "3:0"});
  EXPECT_EQ(named["driving_point"][0]["point"], 3);
  EXPECT_TRUE(named["geometry"].is_null());
}

TEST_F(SurveyCommand, PrintsEqualBytesForAnyNumberOfThreads) {
  EXPECT_TRUE(survey({file("barrel.h5"), "--json", "--threads", "1"}).out ==
              survey({file("barrel.h5"), "--json", "--threads", "3"}).out);
}

TEST_F(SurveyCommand, WritesShapesAndTheIndicator) {
  const auto outcome = survey({file("barrel.h5"), "--force", "-o", file("s.csv"), "-o", file("s.cmif.csv"), "-o",
                               file("s.h5"), "-o", file("s.hdf5"), "-o", file("s.json")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto shapes = test::lines_of(test::bytes_of(file("s.csv")));
  ASSERT_EQ(shapes.size(), 1U + 2U * 18U);
  EXPECT_THAT(shapes[0], HasSubstr("mode,frequency_hz,damping_ratio,family,order,point"));
  EXPECT_THAT(shapes[0], testing::EndsWith(",std,scale_std"));
  EXPECT_THAT(shapes[1], HasSubstr(",bending,1,0,0,0.05,"));
  const auto indicator = test::lines_of(test::bytes_of(file("s.cmif.csv")));
  EXPECT_EQ(indicator[0], "frequency_hz,singular_value_1");
  EXPECT_GT(indicator.size(), 500U);
  const acquire::hdf5::InputHdf5 stored(file("s.h5"));
  for (const char* set : {"shape", "shape_std", "scale_std", "xyz_m", "point", "auto_mac", "cmif", "cmif_frequency_hz"})
    EXPECT_TRUE(stored.has(set)) << set;
  EXPECT_EQ(test::bytes_of(file("s.hdf5")), test::bytes_of(file("s.h5")));
  EXPECT_EQ(test::parse_json(test::bytes_of(file("s.json")))["schema"], "percuss/analysis/1");
}

// Rings of six points: 3 · 6 lines around and 2 · 6 along, 2 · 6 faces.
TEST_F(SurveyCommand, DrawsTheTubeWithLinesAndFaces) {
  ASSERT_EQ(survey({file("barrel.h5"), "--force", "-o", file("s.html"), "-o", file("s.glb"), "-o", file("s.uff")}).code,
            0);
  const std::string page = test::bytes_of(file("s.html"));
  const std::string from = R"(<script type="application/json" id="data">)";
  const std::size_t at = page.find(from) + from.size();
  json shapes;
  for (const json& part : json::parse(page.substr(at, page.find("</script>", at) - at))) {
    if (part.contains("shapes")) shapes = part["shapes"];
  }
  EXPECT_EQ(shapes["points"].size(), 18U);
  EXPECT_EQ(shapes["lines"].size(), 30U);
  EXPECT_EQ(shapes["faces"].size(), 12U);
  EXPECT_EQ(shapes["sensors"][0]["at"], 0) << "the driving point";
  ASSERT_EQ(shapes["modes"].size(), 2U);
  int largest = 0;
  for (const json& move : shapes["modes"][1]["moves"]) largest = std::max(largest, std::abs(move.get<int>()));
  EXPECT_NEAR(largest, 10000, 200) << "points at 0°, 60°, … around the antinode";
  EXPECT_EQ(test::bytes_of(file("s.glb")).substr(0, 4), "glTF");
  EXPECT_THAT(test::bytes_of(file("s.uff")), AllOf(HasSubstr("\n    82\n"), HasSubstr("\n  2412\n")));
}

TEST_F(SurveyCommand, DrawsTheLinesAndFacesOfTheGeometryFile) {
  test::write_bytes(file("faces.csv"), test::bytes_of(file("points.csv")) + "line,0,6,12\nface,0,1,7,6\n");
  ASSERT_EQ(survey({file("bare.h5"), "--geometry", file("faces.csv"), "--force", "-o", file("s.html")}).code, 0);
  EXPECT_THAT(test::bytes_of(file("s.html")), HasSubstr(R"("lines":[[0,6],[6,12]],"faces":[[0,1,7,6]])"));
}

TEST_F(SurveyCommand, NeedsCoordinatesForAModel) {
  const auto outcome = survey({file("bare.h5"), "-o", file("none.glb")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("coordinates"), HasSubstr("--geometry")));
}

TEST_F(SurveyCommand, AcceptsARovingSensor) {
  const json document = document_of({file("barrel.h5"), "--roving", "sensor"});
  EXPECT_EQ(document["roving"], "sensor");
  EXPECT_EQ(document["modes"][0]["shape"]["values"][3]["channel"], 0);
  EXPECT_EQ(document["modes"][1]["family"], "hoop");
}

TEST_F(SurveyCommand, AcceptsFrfs) {
  ASSERT_EQ(run_percuss({"frf", file("bare.h5"), "--band", "60:1500", "-o", file("frf.h5"), "--force"}).code, 0);
  const json document = document_of({file("frf.h5"), "--geometry", file("points.csv")});
  ASSERT_EQ(document["modes"].size(), 2U);
  EXPECT_EQ(document["modes"][1]["family"], "hoop");
  EXPECT_EQ(document["frac"].size(), 18U);
  EXPECT_EQ(document["frac"][17]["point"], 17);
}

TEST_F(SurveyCommand, PrintsAnExampleThatItReads) {
  test::write_bytes(file("example.csv"), survey({"--example"}).out);
  EXPECT_EQ(document_of({file("bare.h5"), "--geometry", file("example.csv")})["geometry"]["points"], 24);
}

TEST_F(SurveyCommand, RejectsUnusableInput) {
  const auto refusal = [](std::vector<std::string> arguments, const std::string& named) {
    arguments.insert(arguments.begin(), "survey");
    return test::rejection_of(arguments, {".json", ".csv", ".h5"}, named);
  };
  test::write_bytes(file("short.csv"), "point,position_m,angle_deg\n0,0.1,0\n");
  refusal({file("bare.h5"), "--geometry", file("short.csv")}, "lacks point 1, which was measured");
  test::write_bytes(file("bad.csv"), "point,position_m,angle_deg\n0,0.1,zero\n");
  refusal({file("bare.h5"), "--geometry", file("bad.csv")}, "bad.csv: line 2");
  refusal({file("bare.h5"), "--geometry", file("none.csv")}, "none.csv");
  refusal({file("bare.h5"), "--driving-point", "99:0"}, "--driving-point");
  refusal({file("runs.h5")}, "several runs");
  const auto unknown = survey({file("bare.h5"), "--driving-point", "3:x"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, testing::HasSubstr("the channel counted from 0, such as 17:0"));
  for (const char* wrong : {"3:", ":0", ""})
    EXPECT_EQ(survey({file("bare.h5"), "--driving-point", wrong}).code, 2) << wrong;
  refusal({file("bare.h5"), "--driving-point", "P7:0"}, "no file \"P7\" is a point of its own");
  EXPECT_THAT(survey({"--help"}).out, testing::HasSubstr("1:0"));
  EXPECT_EQ(survey({file("bare.h5"), "--files", "tests"}).code, 2);
}

TEST_F(SurveyCommand, ReportsWithoutAUsableHit) {
  const json document = document_of({file("missing.h5")}, 4);
  EXPECT_THAT(document["modes"], IsEmpty());
  EXPECT_EQ(survey({file("missing.h5")}).code, 4);
}

}  // namespace percuss::survey_command_test
