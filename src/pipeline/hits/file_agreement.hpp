#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_consistency.hpp"

namespace percuss::pipeline {

/// A file whose hits the FRFs of the other files do not explain.
struct FileDisagreement {
  std::size_t file = 0;  // index into Record::files
  double explained = 0;  // part of its responses' energy that the H1 of the other files explains
};

/// The file whose responses the other files explain least, if they explain less than half of the energy. Files are
/// compared point by point, by their accepted hits. A file of two hits or more disagrees, too, if all are outliers,
/// each with less than half of its energy explained by the other hits.
/// Nothing where no two files share a point.
std::optional<FileDisagreement> disagreeing_file(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                                 const std::vector<ComparedHit>& spectra);

}  // namespace percuss::pipeline
