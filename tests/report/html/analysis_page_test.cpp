#include "report/html/analysis_page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "report/html/html_page.hpp"
#include "report/text/digest.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/text_parts.hpp"

namespace percuss::report::analysis_page_test {

using test::between;
using test::run_percuss;
using testing::HasSubstr;
using testing::Not;

nlohmann::json data_of(const std::string& page) {
  auto parts = nlohmann::json::parse(between(page, R"(<script type="application/json" id="data">)", "</script>"));
  nlohmann::json all = nlohmann::json::object();
  for (const auto& part : parts) all.update(part);
  return all;
}

class AnalysisPage : public testing::Test {
 protected:
  std::string page_of(const std::string& record, const std::vector<std::string>& more = {}) {
    const std::string path = folder_.file("page.html");
    std::vector<std::string> words{"analyze", record, "-o", path, "--force"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = run_percuss(words, {.environment = {"SOURCE_DATE_EPOCH=0"}});
    EXPECT_THAT(outcome.code, testing::AnyOf(0, 4)) << outcome.err;
    return test::bytes_of(path);
  }
  test::ScratchFolder folder_;
};

TEST_F(AnalysisPage, StrikesThroughTheValuesOfRejectedHits) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string whole = page_of(folder_.file("bat.h5"));
  EXPECT_THAT(whole, Not(HasSubstr("<tr class=\"excluded\">")));
  EXPECT_THAT(whole, Not(HasSubstr("rejected hits and are in no result")));
  const std::string page = page_of(folder_.file("bat.h5"), {"--reject-hit", "2"});
  EXPECT_THAT(page, HasSubstr("<tr class=\"excluded\"><td class=\"right\">2</td>"));
  EXPECT_THAT(page, HasSubstr("rejected hits and are in no result"));
}

TEST_F(AnalysisPage, ContainsVerdictTableAndPlots) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string page = page_of(folder_.file("bat.h5"));
  EXPECT_THAT(page, HasSubstr(R"(<p class="verdict">2 modes between)"));
  EXPECT_THAT(page, HasSubstr("bending at 200.0 Hz; hoop at 700.0 Hz."));
  EXPECT_THAT(page, HasSubstr("<td>hoop 1</td>"));
  EXPECT_THAT(page, HasSubstr("1970-01-01 00:00 UTC"));
  EXPECT_THAT(page, HasSubstr(hexadecimal(sha256(test::bytes_of(folder_.file("bat.h5"))))));
  const auto data = data_of(page);
  EXPECT_EQ(data["frf"]["curves"].size(), 2U);
  EXPECT_EQ(data["modes"].size(), 2U);
  EXPECT_EQ(data["hits"].size(), 3U);
  EXPECT_GT(data["stabilisation"]["order"].size(), 10U);
  EXPECT_LT(page.size(), 500'000U);
}

// A broad mode without a peak, which a quick fit leaves out: the diagram shows each pole of which the page warns.
TEST_F(AnalysisPage, DrawsThePolesThatNoModeDescribes) {
  test::write_bytes(folder_.file("broad.json"), R"({"fs_hz": 4096, "samples": 4096, "band_hz": [60, 1500], "seed": 1,
    "hits": 3, "noise": {"force": 1e-4, "accel": 1e-3}, "modes": [
    {"frequency_hz": 200, "damping_ratio": 0.01, "residue_per_kg": [1, 0.5]},
    {"frequency_hz": 400, "damping_ratio": 0.08, "residue_per_kg": [0.3, 0.3]},
    {"frequency_hz": 700, "damping_ratio": 0.005, "residue_per_kg": [1, -1]}]})");
  ASSERT_EQ(run_percuss({"synth", folder_.file("broad.json"), "-o", folder_.file("broad.h5")}).code, 0);
  const std::string page = page_of(folder_.file("broad.h5"), {"--band", "60:1500", "--effort", "quick"});
  EXPECT_THAT(page, HasSubstr("stabilisation diagrams of sections of the band show stable poles"));
  const auto unmodelled_Hz = data_of(page)["stabilisation"]["unmodelled_hz"];
  ASSERT_EQ(unmodelled_Hz.size(), 1U);
  EXPECT_NEAR(unmodelled_Hz[0].get<double>(), 400, 4) << "1 % of the frequency, a sixteenth of the bandwidth";
  const auto chart = run_percuss({"analyze", folder_.file("broad.h5"), "--band", "60:1500", "--effort", "quick",
                                  "--picture", "stabilisation", "-o", folder_.file("broad.svg")});
  EXPECT_EQ(chart.code, 0) << chart.err;
  EXPECT_THAT(test::bytes_of(folder_.file("broad.svg")), HasSubstr("stable in a part of the band, no mode"));
}

TEST_F(AnalysisPage, IsMadeForPaperToo) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string page = page_of(folder_.file("bat.h5"));
  EXPECT_THAT(page, HasSubstr("content: counter(page)"));
  EXPECT_THAT(page, HasSubstr("<p class=\"hint\">Drag to zoom"));
  const std::string print = between(page, "@media print", "@page");
  EXPECT_THAT(print, HasSubstr(".screen, .hint { display: none; }"));
  EXPECT_THAT(page, HasSubstr("caption, \", while paused\").className = \"screen\""));
  // An unbroken figure of many modes would begin on a page of its own and leave the one before it nearly empty.
  EXPECT_THAT(print, HasSubstr("figure[data-plot=\"shapes\"] { break-inside: auto; }"));
  EXPECT_THAT(print, HasSubstr("td:not(.words) { white-space: nowrap; }"));
}

TEST_F(AnalysisPage, AllowsOnlyItsOwnScripts) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string page = page_of(folder_.file("bat.h5"));
  const std::string program = between(page, "</script>\n<script>", "</script>"),
                    style = between(page, "<style>", "</style>");
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("script-src 'sha256-" + base64(sha256(program)) + "'"));
  EXPECT_THAT(page, HasSubstr("style-src 'sha256-" + base64(sha256(style)) + "'"));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, Not(HasSubstr("href=")));
}

TEST_F(AnalysisPage, IsTheSameForTheSameInput) {
  test::write_small_test(folder_.file("bat.h5"));
  EXPECT_TRUE(page_of(folder_.file("bat.h5")) == page_of(folder_.file("bat.h5")));
}

TEST_F(AnalysisPage, EscapesNames) {
  const std::string attack = "<img src=x onerror=alert(1)>";
  acquire::Record record = acquire::open_record([&] {
    test::write_small_test(folder_.file("bat.h5"));
    return folder_.file("bat.h5");
  }());
  record.accel[0].name = attack + "</script><script>alert(2)</script>";
  const std::string file = folder_.file("a'\"><script>alert(3)<") + ".wav";
  acquire::write_record(file, record, false);
  const std::string page = page_of(file);
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("a&#39;&quot;&gt;&lt;script&gt;alert(3)&lt;.wav"));
  EXPECT_THAT(data_of(page)["frf"]["curves"][0]["name"].get<std::string>(), HasSubstr(attack));
}

TEST_F(AnalysisPage, ShowsThatARecordCannotBeUsed) {
  test::write_small_test(folder_.file("bat.h5"), R"("hits": 1)");
  const std::string page = page_of(folder_.file("bat.h5"), {"--reject-hit", "1"});
  EXPECT_THAT(page, HasSubstr("No hit can be used"));
  EXPECT_THAT(page, HasSubstr(R"(id="hits")"));
  for (const char* id : {"frf", "stabilisation", "movement"})
    EXPECT_THAT(page, Not(HasSubstr(fmt::format(R"(<section id="{}")", id))));
}

TEST_F(AnalysisPage, IsRefusedForSeveralTests) {
  test::write_small_test(folder_.file("bat.h5"), R"("hits": 2, "runs": 2)");
  EXPECT_EQ(run_percuss({"analyze", folder_.file("bat.h5"), "-o", folder_.file("x.html")}).code, 2);
}

TEST_F(AnalysisPage, OfASurveyContainsShapesAndMac) {
  const std::string record = folder_.file("barrel.h5"), path = folder_.file("survey.html");
  ASSERT_EQ(run_percuss({"synth", "roving-barrel", "-o", record}).code, 0);
  const auto outcome = run_percuss({"survey", record, "-o", path});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = test::bytes_of(path);
  const auto shapes = data_of(page)["shapes"];
  EXPECT_EQ(shapes["points"].size(), 24U);
  EXPECT_EQ(shapes["lines"].size(), 3U * 8 + 2 * 8) << "three rings of eight, and eight lines along them";
  ASSERT_EQ(shapes["modes"].size(), 5U);
  EXPECT_EQ(shapes["modes"][3]["moves"].size(), 24U * 6);
  EXPECT_THAT(page, HasSubstr(R"(<td class="right shade4">1.00</td>)"));
  EXPECT_LT(page.size(), 500'000U);
  const auto fit = data_of(page)["fit"];
  EXPECT_EQ(fit["frfs"].size(), 24U * fit["channels"].size());
  EXPECT_EQ(fit["places"].size(), 24U);
  EXPECT_GT(data_of(page)["stabilisation"]["order"].size(), 10U);
  EXPECT_TRUE(data_of(page)["indicator"].contains("mif"));
}

}  // namespace percuss::report::analysis_page_test
