#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_cell.hpp"
#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// A model's relative performance against the hoop frequency, for the hoop figures. One factor scales it to the centre
/// of a figure's bats.
struct StudyCurve {
  std::string name;
  std::vector<double> hoop_Hz, value;  // hoop_Hz rising
};

/// Reads the "curve" of a document percuss/model-trampoline/1.
/// errors  InputError: another document.
StudyCurve parse_study_curve(std::string_view text, const std::string& where);

/// Replaces each `id` by a neutral one: AS001, AS002, … in their order. Replaces `bat` by the neutral id of the bat's
/// first state. Removes maker and model. Returns the key: a table of neutral and true names.
std::string anonymise_bats(std::vector<StudyBat>& bats, CsvFormulas formulas = CsvFormulas::neutralise);

/// The bats as a table that a study can read.
std::string study_table_csv(const std::vector<StudyBat>& bats, CsvFormulas formulas = CsvFormulas::neutralise);

}  // namespace percuss::metrics
