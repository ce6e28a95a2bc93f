#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/files/synthetic_files.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::report_files_test {

using test::run_percuss;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

// A command with its input files, and a text that its page must contain.
struct ReportCase {
  const char* name;
  std::vector<std::string> words;
  const char* contained_text;
};

void PrintTo(const ReportCase& one, std::ostream* out) { *out << one.name; }

class ReportFiles : public testing::TestWithParam<ReportCase> {
 protected:
  void SetUp() override {
    test::write_small_test(folder_.file("bat.h5"));
    for (const auto& [command, file] :
         {std::pair{"abi", "log.json"}, {"certify", "session.json"}, {"study", "bats.csv"}})
      std::ofstream(folder_.file(file)) << run_percuss({command, "--example"}).out;
    std::ofstream(folder_.file("bat.txt")) << "0.02 0.05\n0.3 0.025\n0.6 0.045\n0.84 0.066\n";
  }
  int run(const std::vector<std::string>& more) {
    std::vector<std::string> words = GetParam().words;
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = run_percuss(words, {.folder = folder_.path(), .environment = {"SOURCE_DATE_EPOCH=0"}});
    EXPECT_THAT(outcome.code, testing::AnyOf(0, 5)) << outcome.err;
    return outcome.code;
  }
  test::ScratchFolder folder_;
};

TEST_P(ReportFiles, AreSelfContainedPages) {
  run({"-o", "page.html"});
  const std::string page = test::bytes_of(folder_.file("page.html"));
  EXPECT_THAT(page, AllOf(HasSubstr("<!DOCTYPE html>"), HasSubstr("default-src 'none'"), HasSubstr("class=\"verdict\""),
                          HasSubstr(GetParam().contained_text), HasSubstr("1970-01-01 00:00 UTC")));
  EXPECT_THAT(page,
              AllOf(Not(HasSubstr("src=")), Not(HasSubstr("href=")), Not(HasSubstr(">nan")), Not(HasSubstr(" nan"))));
  for (const char* tag : {"table", "section", "figure", "ul", "p", "svg", "details"}) {
    EXPECT_EQ(count_of(page, fmt::format("<{}>", tag)) + count_of(page, fmt::format("<{} ", tag)),
              count_of(page, fmt::format("</{}>", tag)))
        << tag;
  }
}

TEST_P(ReportFiles, AreReproducible) {
  for (const char* file : {"page.html", "chart.svg"}) {
    if (std::string(GetParam().name) == "metrics" && std::string(file) == "chart.svg")
      continue;  // metrics draws no chart
    run({"-o", file});
    const std::string first = test::bytes_of(folder_.file(file));
    EXPECT_GT(first.size(), 1000U);
    run({"-o", file, "--force"});
    const std::string again = test::bytes_of(folder_.file(file));
    const auto without_command = [](std::string page) {  // --force stands in the provenance
      const std::size_t at = page.find("<pre>");
      return at == std::string::npos ? page : page.erase(at, page.find("</pre>") - at);
    };
    EXPECT_TRUE(without_command(first) == without_command(again)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Commands, ReportFiles,
    testing::Values(ReportCase{"analyze", {"analyze", "bat.h5"}, "hoop 1"},
                    ReportCase{"deflection", {"analyze", "bat.h5", "--only", "modes,deflection"}, "largest deflection"},
                    ReportCase{"frf", {"frf", "bat.h5"}, "data-plot=\"magnitude\""},
                    ReportCase{"deflect", {"deflect", "bat.h5"}, "largest deflection"},
                    ReportCase{"certify", {"certify", "session.json"}, "AS001: shoot"},
                    ReportCase{"abi", {"abi", "log.json"}, "AS333: step 9"},
                    ReportCase{"study", {"study", "bats.csv"}, "BESR of wood bats rises with MOI"},
                    ReportCase{"metrics", {"metrics", "--length-in", "34", "--weight-oz", "31"}, "drop"},
                    ReportCase{"beam", {"model", "beam"}, "torsion spring/free beam"},
                    ReportCase{"impact", {"model", "impact"}, "coefficient of restitution"},
                    ReportCase{"rigid", {"model", "rigid"}, "the ball leaves fastest"},
                    ReportCase{"trampoline", {"model", "trampoline"}, "the COR is largest"},
                    ReportCase{"shell", {"model", "shell"}, "Rayleigh"},
                    ReportCase{"bat", {"model", "bat", "--profile", "bat.txt"}, "data-plot=\"bending\""}),
    [](const auto& one) { return std::string(one.param.name); });

class AnalyzeFiles : public testing::Test {
 protected:
  void SetUp() override { test::write_small_test(folder_.file("bat.h5")); }
  test::ProcessOutcome run(const std::vector<std::string>& words) {
    return run_percuss(words, {.folder = folder_.path()});
  }
  test::ScratchFolder folder_;
};

TEST_F(AnalyzeFiles, DrawTheRequestedPictures) {
  ASSERT_EQ(run({"analyze", "bat.h5", "-o", "one.svg", "--picture", "stabilisation"}).code, 0);
  const std::string one = test::bytes_of(folder_.file("one.svg"));
  EXPECT_EQ(count_of(one, "<svg "), 1U);
  EXPECT_THAT(one, AllOf(HasSubstr(">Stabilisation<"), HasSubstr("model order"), HasSubstr(">hoop 1<")));
  ASSERT_EQ(run({"analyze", "bat.h5", "-o", "all.svg", "--picture",
                 "magnitude,phase,coherence,force,spectrum,decay,stabilisation,movement"})
                .code,
            0);
  EXPECT_EQ(count_of(test::bytes_of(folder_.file("all.svg")), "<svg "), 9U) << "eight pictures within one";
  EXPECT_EQ(run({"analyze", "bat.h5", "-o", "x.svg", "--picture", "nothing"}).code, 2);
}

TEST_F(AnalyzeFiles, ContainDeflectionsOnRequest) {
  const auto outcome = run({"analyze", "bat.h5", "--only", "modes,classes,deflection", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto document = nlohmann::json::parse(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
  const auto alone = nlohmann::json::parse(run({"deflect", "bat.h5", "--json"}).out);
  EXPECT_EQ(document["deflection"]["hits"], alone["hits"]);
  EXPECT_EQ(document["modes"].size(), 2U);
  EXPECT_FALSE(document.contains("frf"));
  EXPECT_FALSE(nlohmann::json::parse(run({"analyze", "bat.h5", "--json"}).out).contains("deflection"));
}

TEST_F(AnalyzeFiles, ComputeOnlyTheRequestedSections) {
  const auto outcome = run({"analyze", "bat.h5", "--only", "hits", "-o", "hits.html", "--trace"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = test::bytes_of(folder_.file("hits.html"));
  EXPECT_THAT(page, AllOf(HasSubstr("id=\"hits\""), Not(HasSubstr("id=\"frf\"")), Not(HasSubstr("id=\"modes\""))));
  EXPECT_THAT(outcome.err, AllOf(Not(HasSubstr("modes")), Not(HasSubstr("stabilisation"))));
}

TEST_F(AnalyzeFiles, CompareWithOtherDocuments) {
  ASSERT_EQ(run({"analyze", "bat.h5", "-o", "test.json"}).code, 0);
  const auto outcome = run({"analyze", "bat.h5", "--compare", "test.json", "-o", "beside.html"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("(0.00 ppm"));
  EXPECT_THAT(test::bytes_of(folder_.file("beside.html")), HasSubstr("id=\"comparison\""));
}

// Points without trace lines are drawn as crosses.
TEST(SurveyDrawing, ShowsPointsWithoutLines) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("plate.json"))
      << R"({"fs_hz": 8192, "duration_s": 0.5, "hits": 1, "modes": [{"frequency_hz": 300, "damping_ratio": 0.01, "residue_per_kg": [1, 2, 3]}],
             "sensors": [{"position_m": 0.05, "angle_deg": 0}], "impact": [{"position_m": 0.1}, {"position_m": 0.2}, {"position_m": 0.3}]})";
  std::ofstream(folder.file("points.csv")) << "point,x_m,y_m,z_m\n0,0,0,0\n1,1,0,0\n2,0.5,1,0\n";
  ASSERT_EQ(run_percuss({"synth", folder.file("plate.json"), "-o", folder.file("plate.h5")}).code, 0);
  const auto outcome = run_percuss(
      {"survey", folder.file("plate.h5"), "--geometry", folder.file("points.csv"), "-o", folder.file("plate.svg")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string svg = test::bytes_of(folder.file("plate.svg"));
  EXPECT_THAT(svg, HasSubstr("Mode shapes"));
  EXPECT_EQ(count_of(svg, "M"), 2 * 2 * 3U + 2)
      << "one M for each of the two strokes of a point, at rest and moved; one M in each of two titles";
}

TEST(SessionPage, EscapesMarkupInNames) {
  const test::ScratchFolder folder;
  std::string session = run_percuss({"certify", "--example"}).out;
  const std::string id = "AS001";
  session.replace(session.find(id), id.size(), "<img src=x onerror=alert(1)></svg>");
  std::ofstream(folder.file("session.json")) << session;
  const auto outcome = run_percuss({"certify", folder.file("session.json"), "-o", folder.file("page.html")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = test::bytes_of(folder.file("page.html"));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<img")), HasSubstr("&lt;img src=x onerror=alert(1)")));
}

// The date of a text stays in the HDF5 file that is made from it, and stands on the page.
TEST(PageDate, ComesFromTheFile) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  ASSERT_EQ(run_percuss({"convert", "bat.h5", "bat.csv"}, {.folder = folder.path()}).code, 0);
  test::write_bytes(folder.file("dated.csv"), "# Date: 2026-11-20\n" + test::bytes_of(folder.file("bat.csv")));
  ASSERT_EQ(run_percuss({"convert", "dated.csv", "dated.h5"}, {.folder = folder.path()}).code, 0);
  for (const char* file : {"dated.csv", "dated.h5"}) {
    const auto outcome = run_percuss({"analyze", file, "--title", "Bat 7", "-o", "page.html", "--force", "--quiet"},
                                     {.folder = folder.path()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(test::bytes_of(folder.file("page.html")), HasSubstr("2026-11-20")) << file;
  }
}

// The title stands on the page; files of numbers have none.
TEST(AnalyzeTitle, AllowsFilesThatHaveNone) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  const auto outcome = run_percuss(
      {"analyze", "bat.h5", "--title", "Bat 7", "-o", "bat.html", "--frf", "f.csv", "--modes-file", "m.csv", "--quiet"},
      {.folder = folder.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(test::bytes_of(folder.file("bat.html")), HasSubstr("Bat 7"));
  EXPECT_FALSE(test::bytes_of(folder.file("f.csv")).empty());
  const auto none = run_percuss({"analyze", "bat.h5", "--title", "Bat 7", "--frf", "g.csv"}, {.folder = folder.path()});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("need a page"));
}

}  // namespace percuss::report_files_test
