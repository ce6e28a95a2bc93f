#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// A model's relative performance over the hoop frequency, to be drawn over the hoop figures: scaled by the one factor
/// that brings it to the middle of a figure's bats.
struct StudyCurve {
  std::string name;
  std::vector<double> hoop_Hz, value;  // hoop_Hz rising
};

/// The "curve" of a document percuss/model-trampoline/1. InputError when it is none.
StudyCurve parse_study_curve(std::string_view text, const std::string& where);

/// Gives the bats neutral ids (AS001, AS002, … in their order; states of one bat stay together under the id of the
/// first) and takes maker and model out. Returns the key, a table of neutral and true names.
std::string anonymise_bats(std::vector<StudyBat>& bats);

/// The bats as a table that a study reads again.
std::string study_table_csv(const std::vector<StudyBat>& bats);

}  // namespace percuss::metrics
