#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "record_study.hpp"
#include "scaling.hpp"
#include "skipped_work_study.hpp"

namespace percuss::accuracy {

/// All measurements.
struct Measured {
  RecordStudy records;
  TaskFigures deflection, impact;
  std::vector<Scaling> scalings;
  std::vector<Saving> savings;
};

/// The page docs/project/accuracy.md: method, figures and their meaning. Most numbers in its sentences come from the
/// figures.
std::string page_of(const Measured& measured, const std::string& build_description);

/// The table at the top of the page; README.md shows the same rows.
std::string short_table(const Measured& measured);

}  // namespace percuss::accuracy
