#include "commands/analyze_tests.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "commands/analyze_outputs.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "report/compare_report.hpp"
#include "report/json/read_document.hpp"

namespace percuss::tools {
namespace {

std::vector<Test> tests_of_runs(std::vector<pipeline::RunAnalysis>&& runs) {
  std::vector<Test> tests;
  tests.reserve(runs.size());
  for (auto& [run, analysis] : runs) tests.push_back({.run = run, .analysis = std::move(analysis)});
  return tests;
}

std::vector<Test> tests_of_frfs(const AnalyzeFlags& flags, std::vector<acquire::FrfRecord> frfs) {
  if (flags.read.files != acquire::FileGrouping::tests) {
    acquire::FrfRecord joined = join_frfs_of(flags.read, std::move(frfs));
    frfs.clear();
    frfs.push_back(std::move(joined));
  }
  return tests_of_runs(pipeline::analyses_of_runs(std::move(frfs), analysis_options(flags.analysis)));
}

bool are_named_as_points(const acquire::Record& joined) {
  std::vector<std::string> paths;
  for (const acquire::InputFile& file : joined.files) paths.push_back(file.path);
  return pipeline::named_as_points(paths);
}

// The warning about files that are not one test.
pipeline::Warning files_disagree(const pipeline::Analysis& joined, const pipeline::FileDisagreement& found) {
  return pipeline::with_remedy(
      {"files_disagree",
       fmt::format("the other files explain only {:.0f} % of the responses in {}: the files measured different "
                   "structures or points and are not averaged; each file is a test of its own",
                   100 * found.explained, one_line(joined.record().files[found.file].path, 80)),
       {"files"}},
      are_named_as_points(joined.record()) ? "if they are points of one structure, use percuss survey; if they are "
                                             "hits of one point, state how they belong together"
                                           : "state how the files belong together, if they are hits of one point");
}

[[noreturn]] void refuse_disagreeing(const pipeline::Analysis& analysis, const pipeline::Warning& said) {
  const std::string points =
      are_named_as_points(analysis.record()) ? "if they are points of one structure, use percuss survey; else " : "";
  throw InputError(said.message.substr(0, said.message.find(" and are not averaged")), analysis.record().source(),
                   points + "analyse one file at a time, or state how the files belong together", {"files"});
}

// Several files are one test unless the user says otherwise or their FRFs disagree.
std::vector<Test> tests_of_joined(const AnalyzeFlags& flags, const std::vector<acquire::Record>& records) {
  std::vector<acquire::Record> joined;
  joined.push_back(acquire::join_records(records, flags.read.files));
  pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  std::vector<Test> tests = tests_of_runs(pipeline::analyses_of_runs(std::move(joined), options));
  const bool force_only = flags.only == std::vector<std::string>{"hits"};
  if (flags.read.files != acquire::FileGrouping::automatic || tests.size() > 1 || force_only) return tests;
  const pipeline::Analysis& analysis = *tests.front().analysis;
  const auto found = analysis.possible() ? analysis.file_disagreement() : std::nullopt;
  if (!found) return tests;
  const pipeline::Warning said = files_disagree(analysis, *found);
  if (!holds_several_tests(flags) || !flags.compared.empty()) refuse_disagreeing(analysis, said);
  options.known.push_back(said);
  return tests_of_runs(pipeline::analyses_of_runs(records, options));
}

}  // namespace

void require_agreeing_files(const ReadFlags& read, const pipeline::Analysis& analysis) {
  if (read.files != acquire::FileGrouping::automatic || !analysis.possible()) return;
  if (const auto found = analysis.file_disagreement()) refuse_disagreeing(analysis, files_disagree(analysis, *found));
}

std::vector<Test> tests_of(const AnalyzeFlags& flags, Measurements opened) {
  if (!opened.frfs.empty()) return tests_of_frfs(flags, std::move(opened.frfs));
  if (flags.read.files != acquire::FileGrouping::tests && opened.records.size() > 1)
    return tests_of_joined(flags, opened.records);
  return tests_of_runs(pipeline::analyses_of_runs(std::move(opened.records), analysis_options(flags.analysis)));
}

void compute(const std::vector<Test>& tests, const std::set<report::ReportSection>& sections) {
  constexpr std::size_t kFlopsPerTest = 1'000'000;  // minimum cost in floating-point operations
  if (tests.size() < 2) return;
  parallel_for_cost(tests.size(), kFlopsPerTest, [&](std::size_t t) {
    const pipeline::Analysis& analysis = *tests[t].analysis;
    try {
      if (!analysis.possible()) return;
      if (sections.contains(report::ReportSection::frf) || sections.contains(report::ReportSection::coherence))
        analysis.frfs();
      if (sections.contains(report::ReportSection::modes)) analysis.modes();
      if (sections.contains(report::ReportSection::classes)) analysis.classifications();
    } catch (const InputError&) {
    }
  });
}

report::CommandReport comparison_of(const AnalyzeFlags& flags, const std::string& document, const std::string& name) {
  std::vector<metrics::ComparedDocument> documents = report::parse_documents(document, name);
  for (const std::string& path : flags.compared) {
    for (metrics::ComparedDocument& one : report::read_documents(path)) {
      one.name = with_display_names(flags.output.host, one.name);
      documents.push_back(std::move(one));
    }
  }
  return report::compare_report(documents);
}

}  // namespace percuss::tools
