#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "report/text/fit_sentences.hpp"
#include "report/text/method_text.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/text_parts.hpp"
#include "synth/synthesise.hpp"

// What makes a page a test report: its title block, its section "Method", and the PDF.
namespace percuss::report::method_section_test {

using test::between;
using test::run_percuss;
using testing::HasSubstr;

class TestReport : public testing::Test {
 protected:
  std::string page_of(const std::string& record, const std::vector<std::string>& more = {}) {
    const std::string path = folder_.file("page.html");
    std::vector<std::string> words{"analyze", record, "-o", path, "--force"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = run_percuss(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return test::bytes_of(path);
  }
  test::ScratchFolder folder_;
};

TEST_F(TestReport, CarriesItsTitleBlock) {
  test::write_small_test(folder_.file("bat.h5"));
  test::write_bytes(folder_.file("note.txt"), "First line\n\n<b>second</b>\n");
  test::write_bytes(folder_.file("logo.svg"), R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0"/></svg>)");
  const std::string page =
      page_of(folder_.file("bat.h5"),
              {"--title", "Test of <a> bat", "--customer", "A & B", "--operator", "O", "--specimen", "S 1", "--note",
               "@" + folder_.file("note.txt"), "--logo", folder_.file("logo.svg"), "--paper", "letter"});
  for (const char* part :
       {"<h1>Test of &lt;a&gt; bat</h1>", "<dd>A &amp; B</dd>", "<dt>Operator</dt><dd>O</dd>", "<dd>S 1</dd>",
        "<p>First line</p>\n<p>&lt;b&gt;second&lt;/b&gt;</p>", "src=\"data:image/svg+xml;base64,",
        "; img-src data:", "@page { size: letter;", "<dt>Date of the test</dt><dd>not found in the file</dd>"})
    EXPECT_THAT(page, HasSubstr(part));
  const std::string dated = page_of(folder_.file("bat.h5"), {"--date", "3 May 2026"});
  EXPECT_THAT(dated, HasSubstr("<dt>Date of the test</dt><dd>3 May 2026</dd>"));
  EXPECT_THAT(dated, Not(HasSubstr("not found in the file")));
}

TEST_F(TestReport, SaysHowItsResultsWereMade) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string method = between(page_of(folder_.file("bat.h5"), {"--reject-hit", "2", "--estimator", "hv",
                                                                      "--effort", "standard", "--exponential", "0.01"}),
                                     "<h2 id=\"method-h\">", "</section>");
  for (const char* part : {"3 hits were taken from the rows of the record, one from each; 2 were used.",
                           "Hit 2 was not used: rejected by the user", "within a gate around each pulse",
                           "fell to 0.01", "estimator Hv (2.6)", "effort standard", "Bending or hoop was decided"})
    EXPECT_THAT(method, HasSubstr(part));
}

TEST_F(TestReport, StatesTheEstimatorOfGivenFrfsOnlyAsTheirFileDoes) {
  test::write_small_test(folder_.file("bat.h5"));
  for (const char* name : {"f.csv", "f.h5", "f.mat", "f.uff"}) {
    const std::string path = folder_.file(name);
    ASSERT_EQ(run_percuss({"frf", folder_.file("bat.h5"), "--estimator", "hv", "-o", path, "--quiet"}).code, 0);
    EXPECT_THAT(page_of(path), HasSubstr("their file states the estimator Hv")) << name;
  }
  const std::string own = test::bytes_of(folder_.file("f.csv"));
  test::write_bytes(folder_.file("foreign.csv"), "# accelerance (m/s^2)/N\n" + own.substr(own.find('\n') + 1));
  EXPECT_THAT(page_of(folder_.file("foreign.csv")), HasSubstr("their estimator is not stated"));
}

TEST(MethodSentences, SayHowTheHitsWereFound) {
  const auto sentence = [](std::size_t hits, bool continuous, std::optional<double> trigger_N) {
    synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02}}, 0.5);
    spec.hits = hits;
    spec.noise = {.force = 1e-4, .accel = 1e-3};
    acquire::Record record = synth::synthesise(spec).record;
    record.continuous = continuous;
    const pipeline::Analysis analysis(
        std::move(record), {.band_Hz = std::pair{100.0, 400.0}, .hits = {.trigger_N = trigger_N}, .threads = 1});
    return method_sentences(analysis, {.modes = false}).at(1);
  };
  EXPECT_EQ(sentence(2, false, std::nullopt),
            "2 hits were taken from the rows of the record, one from each; all were used.");
  EXPECT_EQ(sentence(2, false, 20), sentence(2, false, std::nullopt));
  for (const std::size_t hits : {1U, 2U}) {  // a single row may hold several hits
    const std::string found = hits == 1 ? "1 hit was found " : "2 hits were found ";
    const std::string used = hits == 1 ? "; it was used." : "; all were used.";
    EXPECT_EQ(sentence(hits, hits > 1, std::nullopt),
              found + "where the force differs from its baseline by more than the noise (1.1), (1.2)" + used);
    EXPECT_EQ(sentence(hits, hits > 1, 20),
              found + "where the force differs from its baseline by 20 N or more, as the user stated" + used);
  }
}

TEST(EffortSentence, SaysWhetherTheJointFitWasTaken) {
  constexpr auto kBest = identify::Effort::best;
  std::vector<identify::Mode> modes(3);
  EXPECT_THAT(effort_sentence(kBest, modes), testing::StartsWith("All modes were fitted together"));
  for (identify::Mode& mode : modes) mode.joint_misfit = 1.5;
  EXPECT_THAT(effort_sentence(kBest, modes), HasSubstr("leaves more residual than a fit over the mode's own"));
  modes[2].joint_misfit = 0;
  EXPECT_THAT(effort_sentence(kBest, modes), testing::StartsWith("All modes were fitted together"));
  for (identify::Mode& mode : modes) mode.joint_misfit = std::numeric_limits<double>::infinity();
  EXPECT_THAT(effort_sentence(kBest, modes), HasSubstr("did not converge: all modes keep"));
  EXPECT_THAT(effort_sentence(identify::Effort::quick, modes), testing::StartsWith("Each peak was fitted"));
}

TEST(MethodSentences, SayThatOtherModesTookPartInTheFit) {
  const acquire::Record record = synth::synthesise(test::bending_and_hoop_spec()).record;
  const auto method = [&](identify::IdentifyOptions modes) {
    const pipeline::Analysis analysis(record, {.band_Hz = std::pair{60.0, 3200.0}, .modes = modes, .threads = 1});
    return method_sentences(analysis, {});
  };
  EXPECT_THAT(method({.start_Hz = {200}}),
              testing::AllOf(testing::Contains("The user chose the modes at 1 frequency."),
                             testing::Contains("1 other mode took part in the fit and is not listed."),
                             testing::Contains(HasSubstr("synthesised from all fitted modes"))));
  EXPECT_THAT(method({.modes = 1}), testing::Contains("The user limited the list to the clearest 1 mode."));
  EXPECT_THAT(method({}), testing::Not(testing::Contains(HasSubstr("took part"))));
}

TEST(MethodSentences, SayWhichPartOfEachHitWasUsed) {
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02}}, 20);
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  const auto sentences = [&](std::optional<double> length_s) {
    const pipeline::Analysis analysis(
        synth::synthesise(spec).record,
        {.band_Hz = std::pair{100.0, 400.0}, .hits = {.length_s = length_s}, .threads = 1});
    return method_sentences(analysis, {.modes = false});
  };
  const auto part = testing::AllOf(HasSubstr("The first 0."), HasSubstr(" s of each hit entered the transforms, of "));
  const auto cut_off = HasSubstr("the decay that a record cuts off is part of the model");
  spec.layout = synth::SynthLayout::continuous;
  EXPECT_THAT(sentences(std::nullopt), testing::Contains(part));
  EXPECT_THAT(sentences(std::nullopt), testing::Not(testing::Contains(cut_off)));
  EXPECT_THAT(sentences(2), testing::AllOf(testing::Not(testing::Contains(part)), testing::Contains(cut_off)));
}

TEST(FitSentences, NameTheExceptionsAndThePartsOfTheDeviations) {
  std::vector<identify::Mode> modes(3);
  EXPECT_THAT(fit_sentences(modes), testing::ElementsAre(HasSubstr("from the noise (4.12) alone.")));
  modes[0].joint_misfit = 20;
  modes[1].freq_scatter_Hz = 0.1;
  modes[2].damping_std_parts.hits = 1e-4;
  EXPECT_THAT(fit_sentences(modes),
              testing::ElementsAre(HasSubstr("1 of 3 modes keeps the fit over its own spectral lines"),
                                   HasSubstr("1 of 3 modes was fitted at each point alone"),
                                   HasSubstr("the noise (4.12), the scatter between the hits (4.19) and the scatter "
                                             "between the points (4.15), where")));
  EXPECT_TRUE(fit_sentences({}).empty());
}

TEST_F(TestReport, RefusesTitleBlocksThatItCannotShow) {
  const auto refused = [&](const std::vector<std::string>& words, int code) {
    std::vector<std::string> all{"analyze", folder_.file("bat.h5")};
    all.insert(all.end(), words.begin(), words.end());
    const auto outcome = run_percuss(all);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return outcome.err;
  };
  test::write_small_test(folder_.file("bat.h5"));
  test::write_bytes(folder_.file("bad.svg"), "<svg onload=\"x\"/>");
  EXPECT_THAT(refused({"--title", "a", "--json"}, 2), HasSubstr("need a page"));
  const std::string page = folder_.file("p.html");
  EXPECT_THAT(refused({"-o", page, "--logo", folder_.file("bad.svg")}, 3), HasSubstr("event handler"));
  EXPECT_THAT(refused({"-o", page, "--note", "@" + folder_.file("none.txt")}, 3), HasSubstr("none.txt"));
  EXPECT_THAT(refused({"-o", page, "--title", std::string(501, 'a')}, 2), HasSubstr("--title"));
}

TEST_F(TestReport, NamesTheBrowserThatAPdfNeeds) {
  test::write_small_test(folder_.file("bat.h5"));
  const auto outcome = run_percuss({"analyze", folder_.file("bat.h5"), "-o", folder_.file("p.pdf")},
                                   {.environment = {"PERCUSS_BROWSER=", "PATH=/nowhere"}});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("no browser is installed"), HasSubstr("PERCUSS_BROWSER")));
  const auto named = run_percuss({"analyze", folder_.file("bat.h5"), "-o", folder_.file("p.pdf")},
                                 {.environment = {"PERCUSS_BROWSER=/nowhere/chrome"}});
  EXPECT_EQ(named.code, 3);
  EXPECT_THAT(named.err, HasSubstr("PERCUSS_BROWSER names no program"));
}

// A program in place of the browser: it copies the page to the document.
TEST_F(TestReport, IsPrintedByABrowser) {
  test::write_small_test(folder_.file("bat.h5"));
  const std::string browser = folder_.file("browser");
  test::write_bytes(browser,
                    "#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) pdf=${word#*=};; file://*) "
                    "page=${word#file://};; esac; done\ncp \"$page\" \"$pdf\"\n");
  std::filesystem::permissions(browser, std::filesystem::perms::owner_all);
  const auto outcome = run_percuss({"analyze", folder_.file("bat.h5"), "-o", folder_.file("p.pdf"), "--quiet"},
                                   {.environment = {"PERCUSS_BROWSER=" + browser}});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(test::bytes_of(folder_.file("p.pdf")), HasSubstr("<!DOCTYPE html>"));
  test::write_bytes(browser, "#!/bin/sh\nexit 1\n");
  const auto failed = run_percuss({"analyze", folder_.file("bat.h5"), "-o", folder_.file("q.pdf"), "--quiet"},
                                  {.environment = {"PERCUSS_BROWSER=" + browser}});
  EXPECT_EQ(failed.code, 3);
  EXPECT_THAT(failed.err, HasSubstr("the browser printed nothing"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("q.pdf")));
}

TEST_F(TestReport, StatesTheDateOfTheFile) {
  test::write_small_test(folder_.file("bat.csv"));
  test::write_bytes(folder_.file("dated.csv"), "# Date: 2026-11-20 14:03\n" + test::bytes_of(folder_.file("bat.csv")));
  EXPECT_THAT(page_of(folder_.file("dated.csv")), HasSubstr("<dt>Date of the test</dt><dd>2026-11-20 14:03</dd>"));
}

TEST_F(TestReport, NamesTheInstrumentsOfTheSetup) {
  test::write_small_test(folder_.file("bat.h5"));
  test::write_bytes(
      folder_.file("setup.json"),
      R"([{"name": "force", "instrument": "hammer <1>"}, {"name": "accel 1", "instrument": "352C22, no. 7"}])");
  const std::string page = page_of(folder_.file("bat.h5"), {"--setup", folder_.file("setup.json")});
  EXPECT_THAT(page, HasSubstr("<dt>Instrument of force</dt><dd>hammer &lt;1&gt;</dd>"));
  EXPECT_THAT(page, HasSubstr("<dt>Instrument of accel 1</dt><dd>352C22, no. 7</dd>"));
}

}  // namespace percuss::report::method_section_test
