#pragma once
#include <string>

#include "cli/declaration.hpp"

namespace percuss::tools {

// What a shell needs to complete a command line of percuss: commands, options, values that can be listed, files and
// folders. The scripts hold all of it, so that a completion does not start percuss.

std::string bash_completion(const Declaration& all);
std::string zsh_completion(const Declaration& all);
std::string fish_completion(const Declaration& all);

}  // namespace percuss::tools
