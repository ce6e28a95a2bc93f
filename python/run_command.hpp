#pragma once
#include <map>
#include <string>
#include <vector>

#include "cli/host.hpp"

namespace percuss::python {

/// What a command ended with and what it found.
struct RunResult {
  int code = 0;
  tools::CommandResult outcome;
};

/// Runs a command as the command line would: the same words, declarations, checks and messages. `inputs` stand in place
/// of files, `names` in place of the paths of documents in memory. Beside the tool's commands there is "read", which
/// opens and hands over. Several threads may call at once. errors  UsageError, InputError, NoHitError: as the tool.
RunResult run_command(const std::vector<std::string>& words, std::vector<tools::InMemoryInput> inputs,
                      const std::map<std::string, std::string>& names);

/// Every command with its options as JSON: {"commands": [{name, summary, about, words, options, examples}]}.
std::string declared_commands();

}  // namespace percuss::python
