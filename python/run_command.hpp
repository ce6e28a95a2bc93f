#pragma once
#include <map>
#include <string>
#include <vector>

#include "cli/host.hpp"

namespace percuss::python {

/// The exit code of a command and its result.
struct RunResult {
  int code = 0;
  tools::CommandResult outcome;
};

/// Runs a command with the declarations and checks of the command line. `arguments` are its words, `inputs` replace
/// files, and `names` map the paths of documents in memory to display names. "read" opens files and returns them.
/// Several threads may call at once. Throws UsageError, InputError and NoHitError as the tool does.
RunResult run_command(const std::vector<std::string>& arguments, std::vector<tools::InMemoryInput> inputs,
                      const std::map<std::string, std::string>& names);

/// All commands and their options as JSON: {"commands": [{name, summary, about, arguments, options, examples}]}.
std::string declared_commands();

}  // namespace percuss::python
