#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/study/association.hpp"
#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// The groups of bats that have figures of their own.
enum class StudyFamily { wood, nonwood };

/// Bats of one length in a figure.
struct StudyClass {
  int length_class = 0;           // inches; 0: bats of all lengths, whose association is taken within each length
  std::vector<std::size_t> bats;  // indices into Study::bats
  std::optional<Association> association;
  std::optional<TrendLine> trend;     // of one length only
  std::vector<std::size_t> outliers;  // indices into Study::bats
};

/// One of the figures of the source, with the bats that belong to it.
struct StudyFigure {
  std::string name;    // "besr-moi-nonwood-33"
  std::string title;   // "BESR vs. MOI, 33-in. nonwood bats"
  std::string source;  // number of the figure in [8]: "24"; empty: none
  StudyQuantity x = StudyQuantity::moi, y = StudyQuantity::besr;
  StudyFamily family = StudyFamily::wood;
  int length_class = 0;             // 0: all
  std::vector<StudyClass> classes;  // by length; in a figure of all lengths the last holds all bats
};

/// The history of a bat: its states during the break-in, in their order.
struct StudyHistory {
  std::string bat;
  std::vector<std::size_t> states;              // indices into Study::bats
  std::optional<Association> besr, bbs, bbcor;  // over the first hoop frequency
};

enum class StatementVerdict { supported, not_supported, contradicted };
const char* name_of(StatementVerdict verdict);

/// A statement of the source, tested with these bats. `sign` is the sign of the relation, 0 for no relation. The test
/// uses Spearman's ρ within lengths, with p adjusted for all statements of the study. If p is below 5 %, a ρ of the
/// stated sign supports the statement, and any other ρ contradicts it. Otherwise the statement is not supported. A
/// statement of no relation is never supported, because failing to find a relation is no proof. In a study without any
/// relation, the chance of any p below 5 % is at most 5 %.
struct StudyStatement {
  std::string text;  // "BESR of wood bats rises with MOI"
  StudyQuantity x = StudyQuantity::moi, y = StudyQuantity::besr;
  StudyFamily family = StudyFamily::wood;
  int sign = 0;
  std::optional<Association> association;
  double adjusted_p = 1;
  StatementVerdict verdict = StatementVerdict::not_supported;
};

/// The certification programs whose bats count in statements, trends and statistics.
struct StudyOptions {
  std::vector<std::string> programs;  // empty: the main program; "all": every bat
};

/// The bats of one program in the study. Bats without a program and those of "besr" are one program, "besr".
struct StudyProgram {
  std::string name;
  std::size_t bats = 0;
  bool counted = true;
};

/// Descriptive numbers of a quantity. std: of the sample, 0 for one value.
struct QuantitySummary {
  StudyQuantity quantity = StudyQuantity::moi;
  std::size_t states = 0;
  double mean = 0, std = 0, low = 0, high = 0;
};

/// The bats of one material and kind. All their states are included, even the repeated states that statistics do not
/// count.
struct StudyGroup {
  BarrelMaterial material = BarrelMaterial::wood;
  std::string kind;     // "all", "new", "broken in"
  std::string program;  // as in StudyProgram; "all"
  std::size_t states = 0, bats = 0;
  std::vector<QuantitySummary> quantities;  // with at least one value
};

/// The groups with bats: each material, then its kinds and programs where it has several.
std::vector<StudyGroup> study_groups_of(const std::vector<StudyBat>& bats);

/// The program of a bat as in StudyProgram.
std::string program_of(const StudyBat& bat);

struct Study {
  std::vector<StudyBat> bats;
  std::vector<bool> repeated;  // [bats]: a later state of a bat already listed; shown, but not counted again
  std::vector<bool> counted;   // [bats]: of a counted program, and not repeated
  std::vector<StudyProgram> programs;
  std::vector<StudyGroup> groups;
  std::vector<StudyFigure> figures;
  std::vector<StudyHistory> histories;  // of bats with at least two states of known hoop frequency
  std::vector<StudyStatement> statements;
};

/// Computes every figure with at least one bat, its statistics, and every statement. The main program is "besr" where
/// it has bats, else the program with the most bats: [8] states its relations for bats of one program, and shows the
/// others apart.
/// errors  InputError: a program without bats.
Study study_of(std::vector<StudyBat> bats, const StudyOptions& options = {});

}  // namespace percuss::metrics
