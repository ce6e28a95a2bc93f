#pragma once
#include <string>
#include <vector>

#include "scaling.hpp"
#include "skipped_work_study.hpp"

namespace percuss::accuracy {

/// The section on the growth of time and memory.
std::string scaling_section(const std::vector<Scaling>& scalings);

/// The section on skipped work.
std::string skipped_work_section(const std::vector<Saving>& savings);

}  // namespace percuss::accuracy
