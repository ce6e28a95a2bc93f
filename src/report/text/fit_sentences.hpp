#pragma once
#include <string>
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/mode.hpp"

namespace percuss::report {

/// Over which lines the modes were fitted. With effort best: whether the fit of all modes together was taken for any.
const char* effort_sentence(identify::Effort effort, const std::vector<identify::Mode>& modes);

/// Which modes the joint fit does not describe, and what each ± contains.
std::vector<std::string> fit_sentences(const std::vector<identify::Mode>& modes);

}  // namespace percuss::report
