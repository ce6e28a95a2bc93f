#include "run_command.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command.hpp"
#include "provenance.hpp"
#include "read_flags.hpp"
#include "report/version.hpp"

namespace percuss::python {
namespace {

using Json = nlohmann::ordered_json;
using namespace tools;

// Not among the tool's: its results are no text.
constexpr std::string_view kRead = "read";

// Files are opened and handed over, described but not read.
void add_read(CommandLine& line, Host& host) {
  auto flags = std::make_shared<ReadFlags>();
  Command command = line.command("read", "Opens records or FRFs: what is in them, and their samples when asked for",
                                 [flags, &host] {
                                   Measurements opened = open_measurements(*flags);
                                   for (Record& record : opened.records) {
                                     host.outcome.opened.emplace_back(std::move(record));
                                   }
                                   for (FrfRecord& frfs : opened.frfs) host.outcome.opened.emplace_back(std::move(frfs));
                                   return static_cast<int>(kOk);
                                 });
  add_read_flags(command, *flags);
}

std::string as_typed(const std::vector<std::string>& words) {
  std::string line = "percuss";
  for (const std::string& word : words) line += ' ' + quoted_word(word);
  return line;
}

Json json_of(const DeclaredOption& option) {
  return {{"name", option.name()},     {"value", option.value},       {"help", option.help},
          {"group", option.group},     {"initial", option.initial},   {"choices", option.choices},
          {"required", option.required}, {"repeatable", option.repeatable}, {"list", option.list}};
}

Json json_of(const DeclaredCommand& command) {
  Json words = Json::array(), options = Json::array(), examples = Json::array();
  for (const DeclaredOption& word : command.words) words.push_back(json_of(word));
  for (const DeclaredOption& option : command.options) options.push_back(json_of(option));
  for (const DeclaredExample& one : command.examples) examples.push_back({{"line", one.line}, {"meaning", one.meaning}});
  return {{"name", command.name}, {"summary", command.summary}, {"about", command.about},
          {"words", words},       {"options", options},         {"examples", examples}};
}

}  // namespace

Ran run_command(const std::vector<std::string>& words, std::vector<GivenInput> inputs) {
  Host host{.called_as = as_typed(words), .inputs = std::move(inputs), .outcome = {}};
  CommandLine line("percuss", "", version(), &host);
  const std::string_view first = words.empty() ? std::string_view() : words.front();
  if (first == kRead) {
    add_read(line, host);
  } else {
    add_commands(line, first);
  }
  std::vector<const char*> typed{"percuss"};
  for (const std::string& word : words) typed.push_back(word.c_str());
  Ran ran;
  ran.code = line.run(static_cast<int>(typed.size()), typed.data());
  ran.outcome = std::move(host.outcome);
  return ran;
}

std::string declared_commands() {
  Host host;
  CommandLine line("percuss", "", version(), &host);
  add_commands(line, "");
  add_read(line, host);
  Json commands = Json::array();
  for (const DeclaredCommand& command : line.declaration().commands) {
    if (!command.is_group) commands.push_back(json_of(command));
  }
  return Json{{"commands", commands}}.dump();
}

}  // namespace percuss::python
