#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/survey.hpp"
#include "report/html/command_report.hpp"
#include "synth/synthesise.hpp"

namespace percuss::tools {

/// Data in memory in place of a file; the reading options apply to it.
using InMemoryInput = std::function<std::variant<acquire::Record, acquire::FrfRecord>(const acquire::FrfReadOptions&)>;

/// A file that a host saves after the command has run, as -o PATH does, with --force if `force`. `page`: options of the
/// page by their names without dashes ("title", "paper"). They replace the options of the command.
struct SaveRequest {
  std::string path;
  bool force = false;
  std::map<std::string, std::string> page{};
};

/// The result of a command; parts that the command does not produce stay empty. Only one thread at a time may call the
/// functions.
struct CommandResult {
  std::string document;        // the output of --json
  std::vector<Message> notes;  // remarks, which the command line prints on standard error
  /// The text for a terminal of the given width; `write_option` writes the options of warnings.
  std::function<std::string(std::size_t width, OptionWriter write_option)> text;
  std::function<std::string()> html;  // the main table as HTML elements
  std::function<void(const SaveRequest& request)> save;
  /// Of a result of several tests: the result of one test, as if that test had been given alone.
  std::function<CommandResult(std::size_t test)> of_test;
  std::size_t tests = 0;                                            // of analyze: the number of tests
  bool possible = true;                                             // false: no hit can be used, or no decay fitted
  std::vector<std::shared_ptr<const pipeline::Analysis>> analyses;  // of each test
  std::shared_ptr<const pipeline::Survey> survey;
  std::shared_ptr<const pipeline::ImpactTest> deflection;
  std::shared_ptr<const synth::SyntheticTest> synthetic;
  std::vector<std::variant<acquire::Record, acquire::FrfRecord>> opened;
  std::vector<report::NumericColumn> columns;
  std::vector<report::WordColumn> words;
  std::string table;  // CSV, in place of `columns`
};

/// A program that calls a command as a function: its inputs, and the result.
struct Host {
  std::string equivalent_command;  // the command line with the same result, for provenance
  std::vector<InMemoryInput> inputs;
  // Display names of documents in memory by their paths, longer paths before their prefixes.
  std::map<std::string, std::string, std::greater<>> names;
  CommandResult outcome;
};

}  // namespace percuss::tools
