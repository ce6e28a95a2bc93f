#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "frf/frf_record.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/survey.hpp"
#include "report/html/command_report.hpp"
#include "synth/synthesise.hpp"

namespace percuss::tools {

/// Data in memory where a command would open a file; what the options say of files holds for them too.
using InMemoryInput = std::function<std::variant<acquire::Record, frf::FrfRecord>(const frf::FrfReadOptions&)>;

/// What a command came to; what it does not have stays empty. The functions may be called for as long as the outcome
/// or a copy of it lives, by one thread at a time.
struct CommandResult {
  std::string document;                                             // what --json prints
  std::vector<std::string> notes;                                   // what it says on standard error
  std::function<std::string(std::size_t width)> text;               // what a terminal of that width shows
  std::function<std::string()> html;                                // the results alone, as elements of HTML
  std::function<void(const std::string& path, bool force)> save;    // as -o PATH
  std::vector<std::shared_ptr<const pipeline::Analysis>> analyses;  // of each test
  std::shared_ptr<const pipeline::Survey> survey;
  std::shared_ptr<const pipeline::ImpactTest> deflection;
  std::shared_ptr<const synth::SyntheticTest> synthetic;
  std::vector<std::variant<acquire::Record, frf::FrfRecord>> opened;
  std::vector<report::NumericColumn> columns;
};

/// Another program in whose process a command runs, in place of a terminal: what it gives, and what it gets.
struct Host {
  std::string
      equivalent_command;  // the command line that would do the same, for who asks later how a result came about
  std::vector<InMemoryInput> inputs;
  // Of documents in memory, by the paths that stand for them; of two that begin alike the longer first.
  std::map<std::string, std::string, std::greater<>> names;
  CommandResult outcome;
};

}  // namespace percuss::tools
