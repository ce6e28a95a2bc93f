#include "commands/analyze_tests.hpp"

#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"

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

}  // namespace

std::vector<Test> tests_of(const AnalyzeFlags& flags) {
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty()) return tests_of_frfs(flags, std::move(opened.frfs));
  std::vector<acquire::Record> records = std::move(opened.records);
  if (flags.read.files != acquire::FileGrouping::tests) {
    acquire::Record joined = acquire::join_records(std::move(records), flags.read.files);
    records.clear();
    records.push_back(std::move(joined));
  }
  return tests_of_runs(pipeline::analyses_of_runs(std::move(records), analysis_options(flags.analysis)));
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
    } catch (const std::exception&) {
    }
  });
}

}  // namespace percuss::tools
