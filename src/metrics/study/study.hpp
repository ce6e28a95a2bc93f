#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/study/association.hpp"
#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// The families of bats that the figures keep apart.
enum class StudyFamily { wood, nonwood };

/// Bats of one length in a figure.
struct StudyClass {
  int length_class = 0;           // in; 0: all lengths, with what lengths differ by taken off
  std::vector<std::size_t> bats;  // of Study::bats
  std::optional<Association> association;
  std::optional<TrendLine> trend;     // of one length only
  std::vector<std::size_t> outliers;  // of Study::bats
};

/// One of the source's figures, as far as there are bats for it.
struct StudyFigure {
  std::string name;    // "besr-moi-nonwood-33"
  std::string title;   // "BESR vs. MOI, 33-in. nonwood bats"
  std::string source;  // the figure of [8] it is: "24"; empty: none
  StudyQuantity x = StudyQuantity::moi, y = StudyQuantity::besr;
  StudyFamily family = StudyFamily::wood;
  int length_class = 0;             // 0: all
  std::vector<StudyClass> classes;  // by length; of figures of all lengths the last is the one of all
};

/// One bat's states in their order, as it is broken in.
struct StudyHistory {
  std::string bat;
  std::vector<std::size_t> states;              // of Study::bats
  std::optional<Association> besr, bbs, bbcor;  // over the first hoop frequency
};

enum class StatementVerdict { supported, not_supported, contradicted };
const char* name_of(StatementVerdict verdict);

/// What the source says of bats, held against these. `sign` is that of the relation, 0 for none. A relation is
/// supported when Spearman's ρ within lengths has its sign and its p, adjusted for all statements of the study, is
/// below 5 %: in a study without any relation the chance of one false statement is at most that. That there is none is
/// contradicted by such a p, and never supported: not finding is no proof.
struct StudyStatement {
  std::string text;  // "BESR of wood bats rises with MOI"
  StudyQuantity x = StudyQuantity::moi, y = StudyQuantity::besr;
  StudyFamily family = StudyFamily::wood;
  int sign = 0;
  std::optional<Association> association;
  double adjusted_p = 1;
  StatementVerdict verdict = StatementVerdict::not_supported;
};

struct Study {
  std::vector<StudyBat> bats;
  std::vector<bool> repeated;  // [bats]: a later state of a bat that stands above; shown, but not counted again
  std::vector<StudyFigure> figures;
  std::vector<StudyHistory> trails;  // of bats with two states or more whose hoop frequency is known
  std::vector<StudyStatement> statements;
};

/// Every figure that has a bat, with its statistics, and every statement.
Study study_of(std::vector<StudyBat> bats);

}  // namespace percuss::metrics
