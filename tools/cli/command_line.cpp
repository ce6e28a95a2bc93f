#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "cli/usage_errors.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::tools {
namespace {

// The program and the chosen command below it.
std::vector<const CLI::App*> chosen_path(const CLI::App& program) {
  std::vector<const CLI::App*> path{&program};
  while (!path.back()->get_subcommands().empty()) path.push_back(path.back()->get_subcommands().front());
  return path;
}

const DeclaredCommand& declared_of(const Declaration& all, const std::vector<const CLI::App*>& path,
                                   std::size_t length) {
  std::string name;
  for (std::size_t i = 1; i < length; ++i) name += (i > 1 ? " " : "") + path[i]->get_name();
  return *find_command(all, name);
}

// Checked first, since a mistyped option often causes the other errors.
void reject_unknown_options(const Declaration& all, const CLI::App& program) {
  const auto path = chosen_path(program);
  const DeclaredCommand& command = declared_of(all, path, path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const std::string& word : path[i]->remaining()) {
      if (word.size() < 2 || word.front() != '-') continue;
      const DeclaredOption* const later = find_option(command, word.substr(0, word.find('=')));
      if (i + 1 < path.size() && later != nullptr) throw option_before_command(all, command, *later);
      throw unknown_option(all, declared_of(all, path, i + 1), word);
    }
  }
}

void reject_missing(const Declaration& all, const DeclaredCommand& command, const CLI::App& app) {
  for (const auto* declared : {&command.options, &command.arguments}) {
    for (const DeclaredOption& one : *declared) {
      if (one.required && app.get_option(one.name())->count() == 0) throw missing_option(all, command, one);
    }
  }
}

void reject_mismatch(const DeclaredCommand& command, const CLI::App& app, const std::vector<std::string>& typed) {
  for (const std::string& word : typed) {
    const DeclaredOption* const flag = find_option(command, word.substr(0, word.find('=')));
    if (flag != nullptr && flag->is_flag() && word.find('=') != std::string::npos) throw flag_with_value(*flag);
  }
  const DeclaredOption* const last = find_option(command, typed.back().substr(0, typed.back().find('=')));
  if (last != nullptr && !last->is_flag()) throw missing_value(*last);
  for (const DeclaredOption& option : command.options) {
    const bool one_value = !option.is_flag() && !option.repeatable;
    if (one_value && app.get_option(option.name())->count() > 1) throw given_twice(option);
  }
}

// CLI11 does not say where the error is; the declaration and the typed words do.
[[noreturn]] void reject(const Declaration& all, const CLI::App& program, const CLI::ParseError& error,
                         const std::vector<std::string>& typed) {
  reject_unknown_options(all, program);
  const auto path = chosen_path(program);
  const DeclaredCommand& command = declared_of(all, path, path.size());
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) reject_mismatch(command, *path.back(), typed);
  if (const auto extra = path.back()->remaining(); !extra.empty()) throw extra_argument(all, command, extra.front());
  if (!commands_of(all, command).empty()) throw missing_command(all, command);
  reject_missing(all, command, *path.back());
  throw UsageError(one_line(error.what()), "see " + full_name(all, command) + " --help");
}

bool is_number(const std::string& text) { return parse_number(text, false).problem == NumberProblem::none; }

// Replaces "--band 60 3200" by "--band 60:3200". Otherwise the second number would be taken for a file.
std::vector<std::string> with_whole_ranges(const Declaration& all, const std::vector<std::string>& typed) {
  const auto takes_range = [&](const std::string& word) {
    if (!word.starts_with("--")) return false;
    const DeclaredOption* const option = find_option(*longest_command(all, typed).command, word);
    return option != nullptr && option->value == "LO:HI";
  };
  std::vector<std::string> out;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    out.push_back(typed[i]);
    if (i + 2 < typed.size() && is_number(typed[i + 1]) && is_number(typed[i + 2]) && takes_range(typed[i])) {
      out.push_back(typed[i + 1] + ":" + typed[i + 2]);
      i += 2;
    }
  }
  return out;
}

}  // namespace

CommandLine::CommandLine(const char* name, const char* description, const char* version, Host* host)
    : host_(host), app_(std::make_unique<CLI::App>(description, name)) {
  declaration_.program = name;
  declaration_.version = version;
  DeclaredCommand* const program = declare("", description);
  program->is_group = true;
  program->options.push_back({.names = {"--version"}, .help = "Show the version and stop"});
  app_->set_version_flag("--version", std::string(name) + " " + version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

DeclaredCommand* CommandLine::declare(const char* name, const char* description) {
  declaration_.commands.push_back({.name = name, .summary = description});
  DeclaredCommand* const made = &declaration_.commands.back();
  made->options.push_back({.names = {"-h", "--help"}, .help = "Show this help and stop"});
  return made;
}

Command CommandLine::program() { return {app_.get(), &declaration_.commands.front()}; }

Command CommandLine::group(const char* name, const char* description) {
  CLI::App* const group = app_->add_subcommand(name);
  group->require_subcommand(1);
  DeclaredCommand* const declared = declare(name, description);
  declared->is_group = true;
  return {group, declared};
}

Command CommandLine::command(const char* name, const char* description, std::function<int()> run) {
  const std::string_view words = name;
  const std::size_t blank = words.find(' ');
  CLI::App* parent =
      blank == std::string_view::npos ? app_.get() : app_->get_subcommand(std::string(words.substr(0, blank)));
  CLI::App* command = parent->add_subcommand(std::string(words.substr(blank + 1)));
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  return {command, declare(name, description), host_};
}

void CommandLine::exit_code(int code, const char* meaning) {
  declaration_.exits.push_back({.code = code, .meaning = meaning});
}

// CLI11 would report an unknown command as a missing one.
void CommandLine::check_commands(const std::vector<std::string>& words) const {
  const CommandMatch named = longest_command(declaration_, words);
  if (!named.command->is_group || named.words == words.size() || words[named.words].starts_with('-')) return;
  throw unknown_command(declaration_, *named.command, words[named.words]);
}

// "percuss help model beam" is "percuss model beam --help".
int CommandLine::show_help(const std::vector<std::string>& command_words) const {
  check_commands(command_words);
  const std::string name = fmt::format("{}", fmt::join(command_words, " "));
  const DeclaredCommand* const command = find_command(declaration_, name);
  if (command == nullptr)
    throw UsageError("help takes the name of one command", "see " + declaration_.program + " --help");
  std::cout << help_text(declaration_, *command, terminal_width());
  return 0;
}

int CommandLine::run(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!kept_words_.empty() && words == kept_words_) {
    for (const Variables& one : variables_) one.restore();
    return chosen_();
  }
  const std::vector<std::string> typed = with_whole_ranges(declaration_, words);
  if (!typed.empty() && typed.front() == "help") return show_help({typed.begin() + 1, typed.end()});
  check_commands(typed);
  kept_words_.clear();
  for (const Variables& one : variables_) one.reset();
  if (!parse(typed)) return 0;
  if (host_ != nullptr) {
    for (const Variables& one : variables_) one.keep();
    kept_words_ = std::move(words);
  }
  return chosen_();
}

bool CommandLine::parse(const std::vector<std::string>& typed) {
  try {
    app_->parse(std::vector<std::string>(typed.rbegin(), typed.rend()));  // CLI11 takes the words last to first
  } catch (const CLI::CallForHelp&) {
    const auto path = chosen_path(*app_);
    std::cout << help_text(declaration_, declared_of(declaration_, path, path.size()), terminal_width());
    return false;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    return false;
  } catch (const UsageError&) {
    reject_unknown_options(declaration_, *app_);
    throw;
  } catch (const CLI::ParseError& error) {
    reject(declaration_, *app_, error, typed);
  }
  return true;
}

}  // namespace percuss::tools
