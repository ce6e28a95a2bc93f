#include "commands/analyze_tests.hpp"

#include "core/parallel/parallel.hpp"
#include "pipeline/runs_of_record.hpp"

namespace percuss::tools {
namespace {

std::vector<Test> tests_of_frfs(const AnalyzeFlags& flags, std::vector<FrfRecord> frfs) {
  if (flags.read.files != FileGrouping::tests) {
    FrfRecord joined = join_frfs_of(flags.read, std::move(frfs));
    frfs.clear();
    frfs.push_back(std::move(joined));
  }
  std::vector<Test> tests;
  for (FrfRecord& record : frfs) {
    assume_angles(record);
    tests.push_back({.run = static_cast<int>(tests.size()),
                     .analysis = std::make_unique<Analysis>(std::move(record), analysis_options(flags.analysis))});
  }
  return tests;
}

}  // namespace

std::vector<Test> tests_of(const AnalyzeFlags& flags) {
  Measurements opened = open_measurements(flags.read);
  if (!opened.frfs.empty()) return tests_of_frfs(flags, std::move(opened.frfs));
  std::vector<Record> records = std::move(opened.records);
  if (flags.read.files != FileGrouping::tests) {
    Record joined = join_records(std::move(records), flags.read.files);
    records.clear();
    records.push_back(std::move(joined));
  }
  std::vector<Test> tests;
  for (Record& record : records) {
    assume_angles(record);
    for (auto& [run, part] : split_runs(record)) {
      const int number = records.size() > 1 ? static_cast<int>(tests.size()) : run;
      tests.push_back(
          {.run = number, .analysis = std::make_unique<Analysis>(std::move(part), analysis_options(flags.analysis))});
    }
  }
  return tests;
}

void compute(const std::vector<Test>& tests, const std::set<ReportSection>& sections) {
  constexpr std::size_t kPerTest = 1'000'000;  // operations, at the least
  if (tests.size() < 2) return;
  parallel_for_cost(tests.size(), kPerTest, [&](std::size_t t) {
    const Analysis& analysis = *tests[t].analysis;
    try {
      if (!analysis.possible()) return;
      if (sections.contains(ReportSection::frf) || sections.contains(ReportSection::coherence)) analysis.frfs();
      if (sections.contains(ReportSection::modes)) analysis.modes();
      if (sections.contains(ReportSection::classes)) analysis.classifications();
    } catch (const std::exception&) {
    }
  });
}

}  // namespace percuss::tools
