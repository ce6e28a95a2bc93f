#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "record_study.hpp"
#include "scaling.hpp"
#include "skipped_work_study.hpp"

namespace percuss::accuracy {

/// All that was measured.
struct Measured {
  RecordStudy records;
  Family deflection, impact;
  std::vector<Scaling> scalings;
  std::vector<Saving> savings;
};

/// docs/project/accuracy.md: what was measured, how, the figures and what they mean. Its sentences take their numbers from the
/// figures.
std::string page_of(const Measured& measured, const std::string& build_description);

/// The table at its top, whose rows README.md shows as well.
std::string short_table(const Measured& measured);

}  // namespace percuss::accuracy
