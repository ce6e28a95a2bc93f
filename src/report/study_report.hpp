#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "metrics/study.hpp"
#include "metrics/study_join.hpp"

namespace percuss {

/// The document percuss/study/1 (docs/schema/study.schema.json), indented, with a line end.
std::string study_json(const Study& study);

/// What the study says: the statements with their statistics, then the outliers.
std::string study_text(const Study& study, std::size_t width);

/// The statistics of every class of every figure as one table.
std::string study_csv(const Study& study);

/// A file of the figures: its name ("besr-moi-wood-all.svg") and its text.
struct StudyFile {
  std::string name, text;
};

/// Every figure and every bat's trail, as a picture and as the table of its points.
std::vector<StudyFile> study_files(const Study& study, const std::optional<StudyCurve>& curve = {});

}  // namespace percuss
