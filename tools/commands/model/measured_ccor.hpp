#pragma once
#include <string>
#include <vector>

#include "model/trampoline/ccor_misfit.hpp"

namespace percuss::tools {

/// The values of --fit-ccor: triples SPEED:COR:STD, or the name of a file of such triples, or of lines of three
/// numbers. Throws OptionError or InputError.
std::vector<model::MeasuredCor> measured_ccor(const std::vector<std::string>& words);

}  // namespace percuss::tools
