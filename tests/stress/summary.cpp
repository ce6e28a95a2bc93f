#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/parallel/parallel.hpp"

namespace percuss::stress {
namespace {

constexpr double kInterval = 1.96;       // standard deviations of 95 %
constexpr std::size_t kMaxFailures = 3;  // listed per check

void add_run(Summary& all, std::size_t run, const Result& result) {
  if (!result.failures.empty()) ++all.failed_runs;
  for (const std::string& failure : result.failures) all.failures.emplace_back(run, failure);
  all.said.insert(result.said.begin(), result.said.end());
  all.wanted += result.wanted;
  all.found += result.found;
  all.freq_relative = std::max(all.freq_relative, result.freq_relative);
  all.damping_absolute = std::max(all.damping_absolute, result.damping_absolute);
  all.freq_bound = std::max(all.freq_bound, result.freq_bound);
  for (const ModeError& error : result.mode_errors) {
    all.largest.freq_sigmas = std::max(all.largest.freq_sigmas, error.freq_sigmas);
    all.largest.damping_sigmas = std::max(all.largest.damping_sigmas, error.damping_sigmas);
    if (!result.calibrated) continue;
    ++all.coverage.modes;
    if (error.freq_sigmas < kInterval) ++all.coverage.freq;
    if (error.damping_sigmas < kInterval) ++all.coverage.damping;
  }
}

std::string verdict_of(const Summary& summary) {
  if (!summary.failed()) return "ok";
  return fmt::format("{} in {} of {}", summary.known() ? "known defect" : "**fails**", summary.failed_runs,
                     summary.runs);
}

std::string measured(const Summary& s) {
  if (s.found == 0) return "";
  return fmt::format("{:.1f}, {:.1f} | {:.0e}, {:.0e}", s.largest.freq_sigmas, s.largest.damping_sigmas,
                     s.freq_relative, s.damping_absolute);
}

}  // namespace

void add(Coverage& to, const Coverage& more) {
  to.modes += more.modes;
  to.freq += more.freq;
  to.damping += more.damping;
}

std::vector<Summary> run_all(const std::vector<Check>& checks, bool full) {
  struct Job {
    std::size_t check, run;
  };
  std::vector<Job> jobs;
  std::vector<Summary> summaries;
  for (const Check& check : checks) {
    const std::size_t runs = full ? check.full_runs : check.runs;
    for (std::size_t run = 0; run < runs; ++run) jobs.push_back({summaries.size(), run});
    summaries.push_back({.check = check, .runs = runs});
  }
  std::vector<Result> results(jobs.size());
  parallel_for(jobs.size(), 0, [&](std::size_t j) { results[j] = checks[jobs[j].check].run(jobs[j].run); });
  for (std::size_t j = 0; j < jobs.size(); ++j) add_run(summaries[jobs[j].check], jobs[j].run, results[j]);
  return summaries;
}

std::string lines_of(const Summary& s) {
  const char* const verdict = !s.failed() ? "ok   " : s.known() ? "known" : "FAILS";
  std::string text = fmt::format("{} {}: {} | {}; {} of {} modes; {}; {}\n", verdict, s.check.group, s.check.name,
                                 s.check.expectation, s.found, s.wanted, measured(s), fmt::join(s.said, ", "));
  for (std::size_t f = 0; f < std::min(kMaxFailures, s.failures.size()); ++f)
    text += fmt::format("      run {}: {}\n", s.failures[f].first, s.failures[f].second);
  if (s.failed()) text += fmt::format("      {} of {} runs. {}\n", s.failed_runs, s.runs, s.check.defect);
  return text;
}

std::string defects_of(const std::vector<Summary>& summaries) {
  std::vector<std::string> defects;  // in the order of `summaries`
  std::map<std::string, std::string> cells;
  for (const Summary& s : summaries) {
    if (!s.known()) continue;
    if (!cells.contains(s.check.defect)) defects.push_back(s.check.defect);
    std::string& text = cells[s.check.defect];
    text += fmt::format("    - `{}: {}`, {} of {} runs", s.check.group, s.check.name, s.failed_runs, s.runs);
    if (s.failed()) text += fmt::format("; run {}: {}", s.failures.front().first, s.failures.front().second);
    text += "\n";
  }
  std::string text;
  for (const std::string& defect : defects) text += "- " + defect + "\n" + cells[defect];
  return text;
}

std::string tables_of(const std::vector<Summary>& summaries) {
  std::string text, group;
  for (const Summary& s : summaries) {
    if (s.check.group != group) {
      group = s.check.group;
      text += "\n### " + group +
              "\n| cell | expected | bound | modes | σ off | error | says | |\n|---|---|---|---|---|---|---|---|\n";
    }
    const std::string bound = s.freq_bound > 0 ? fmt::format("{:.0e}", s.freq_bound) : "";
    const std::string numbers = s.found > 0 ? measured(s) : " | ";
    text += fmt::format("| {} | {} | {} | {} of {} | {} | {} | {} |\n", s.check.name, s.check.expectation, bound,
                        s.found, s.wanted, numbers, fmt::join(s.said, ", "), verdict_of(s));
  }
  return text;
}

}  // namespace percuss::stress
