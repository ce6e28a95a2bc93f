#include "metrics/study/study.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "metrics/study/study_figures.hpp"

namespace percuss::metrics {
namespace {

constexpr double kFalsePositives = 0.05;
constexpr const char* kMainProgram = "besr";  // bats without a stated program count as its bats

ClassPoints points_of(const Study& study, StudyQuantity x, StudyQuantity y, const std::vector<std::size_t>& members) {
  ClassPoints points;
  for (const std::size_t b : members) {
    points.x.push_back(*study.bats[b].value(x));
    points.y.push_back(*study.bats[b].value(y));
  }
  return points;
}

// States of one bat are not independent: only the first state counts. Bats of other programs are only shown, not
// counted.
std::vector<std::size_t> counted_of(const Study& study, const std::vector<std::size_t>& members) {
  std::vector<std::size_t> out;
  for (const std::size_t b : members) {
    if (study.counted[b]) out.push_back(b);
  }
  return out;
}

void fit_figure(const Study& study, StudyFigure& figure) {
  std::vector<ClassPoints> lengths;
  for (StudyClass& one : figure.classes) {
    if (one.length_class == 0) {
      one.association = association_of(lengths);
      continue;
    }
    const std::vector<std::size_t> counted = counted_of(study, one.bats);
    lengths.push_back(points_of(study, figure.x, figure.y, counted));
    one.association = association_of({lengths.back()});
    one.trend = trend_line_of(lengths.back());
    if (!one.trend) continue;
    for (const std::size_t i : outliers_of(lengths.back(), *one.trend)) one.outliers.push_back(counted[i]);
  }
}

// The programs, each with its number of bats and whether it counts. The programs of the options count. Without any,
// only the main program counts: "besr" if it has bats, else the program with the most bats.
std::vector<StudyProgram> programs_of(const Study& study, const StudyOptions& options) {
  std::map<std::string, std::size_t> bats_of;
  for (std::size_t b = 0; b < study.bats.size(); ++b) bats_of[program_of(study.bats[b])] += study.repeated[b] ? 0U : 1U;
  std::vector<StudyProgram> out;
  out.reserve(bats_of.size());
  for (const auto& [name, count] : bats_of) out.push_back({.name = name, .bats = count, .counted = false});
  if (options.programs.empty()) {
    const auto main = std::max_element(out.begin(), out.end(), [](const StudyProgram& a, const StudyProgram& b) {
      return std::pair(a.bats > 0 && a.name == kMainProgram, a.bats) <
             std::pair(b.bats > 0 && b.name == kMainProgram, b.bats);
    });
    if (main != out.end()) main->counted = true;
  }
  for (const std::string& asked : options.programs) {
    bool found = false;
    for (StudyProgram& program : out) {
      const bool hit = asked == "all" || asked == program.name;
      program.counted = program.counted || hit;
      found = found || hit;
    }
    if (!found) {
      throw InputError("no bats of the program " + one_line(asked, 40), "the tables",
                       "give a program of the tables, or all", {"program"});
    }
  }
  return out;
}

std::vector<bool> repeats_of(const std::vector<StudyBat>& bats) {
  std::set<std::string> seen;
  std::vector<bool> out;
  out.reserve(bats.size());
  for (const StudyBat& bat : bats) out.push_back(!bat.bat.empty() && !seen.insert(bat.bat).second);
  return out;
}

std::optional<Association> history_association(const Study& study, const StudyHistory& history, StudyQuantity y) {
  std::vector<std::size_t> known;
  for (const std::size_t b : history.states) {
    if (study.bats[b].value(y)) known.push_back(b);
  }
  return association_of({points_of(study, StudyQuantity::hoop1, y, known)});
}

std::vector<StudyHistory> histories_of(const std::vector<StudyBat>& bats) {
  std::map<std::string, StudyHistory> by_bat;
  for (std::size_t b = 0; b < bats.size(); ++b) {
    if (bats[b].bat.empty() || !bats[b].value(StudyQuantity::hoop1)) continue;
    StudyHistory& history = by_bat[bats[b].bat];
    history.bat = bats[b].bat;
    history.states.push_back(b);
  }
  std::vector<StudyHistory> out;
  for (auto& [name, history] : by_bat) {
    if (history.states.size() > 1) out.push_back(std::move(history));
  }
  return out;
}

void judge_statements(Study& study) {
  std::vector<double> p;
  std::vector<std::size_t> testable;
  for (std::size_t s = 0; s < study.statements.size(); ++s) {
    StudyStatement& statement = study.statements[s];
    for (const StudyFigure& figure : study.figures) {
      if (figure.x == statement.x && figure.y == statement.y && figure.family == statement.family &&
          figure.length_class == 0)
        statement.association = figure.classes.back().association;
    }
    if (!statement.association) continue;
    testable.push_back(s);
    p.push_back(statement.association->p);
  }
  const auto adjusted = holm_adjusted(p);
  for (std::size_t k = 0; k < testable.size(); ++k) {
    StudyStatement& statement = study.statements[testable[k]];
    statement.adjusted_p = adjusted[k];
    if (!(adjusted[k] < kFalsePositives)) continue;
    const bool has_stated_sign = statement.association->spearman.value * statement.sign > 0;
    statement.verdict = has_stated_sign ? StatementVerdict::supported : StatementVerdict::contradicted;
  }
}

}  // namespace

const char* name_of(StatementVerdict verdict) {
  switch (verdict) {
    case StatementVerdict::supported:
      return "supported";
    case StatementVerdict::contradicted:
      return "contradicted";
    case StatementVerdict::not_supported:
      break;
  }
  return "not supported";
}

std::string program_of(const StudyBat& bat) { return bat.program.empty() ? kMainProgram : bat.program; }

Study study_of(std::vector<StudyBat> bats, const StudyOptions& options) {
  Study study{.bats = std::move(bats)};
  study.repeated = repeats_of(study.bats);
  study.programs = programs_of(study, options);
  study.groups = study_groups_of(study.bats);
  for (std::size_t b = 0; b < study.bats.size(); ++b) {
    const auto program = std::find_if(study.programs.begin(), study.programs.end(),
                                      [&](const StudyProgram& p) { return p.name == program_of(study.bats[b]); });
    study.counted.push_back(program->counted && !study.repeated[b]);
  }
  study.figures = study_figures_of(study.bats);
  for (StudyFigure& figure : study.figures) fit_figure(study, figure);
  study.histories = histories_of(study.bats);
  for (StudyHistory& history : study.histories) {
    history.besr = history_association(study, history, StudyQuantity::besr);
    history.bbs = history_association(study, history, StudyQuantity::bbs);
    history.bbcor = history_association(study, history, StudyQuantity::bbcor);
  }
  study.statements = published_statements();
  judge_statements(study);
  return study;
}

}  // namespace percuss::metrics
