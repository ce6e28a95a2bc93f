#include "cli/command_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "cli/option_units.hpp"
#include "cli/usage_errors.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::tools {
namespace {

// "1.5D3" as "1500": CLI11 reads fewer forms of numbers than parse_number.
std::string plain_number(const std::string& text) {
  const ParsedNumber number = parse_number(text, false);
  const bool plain = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  return number.problem == NumberProblem::none && !plain ? fmt::format("{}", number.value) : text;
}

std::function<bool(const std::string&)> number_check(const std::function<bool(double)>& accepts) {
  return [accepts](const std::string& text) {
    const ParsedNumber number = parse_number(text, false);
    return number.problem == NumberProblem::none && accepts(number.value);
  };
}

bool only_digits(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::string> names_in(std::string_view names) {
  const std::size_t comma = names.find(',');
  if (comma == std::string_view::npos) return {std::string(names)};
  return {std::string(names.substr(0, comma)), std::string(names.substr(comma + 1))};
}

}  // namespace

Option Option::add_check(std::string requirement, const std::function<bool(const std::string&)>& check) {
  declared_->requirement = std::move(requirement);
  const DeclaredOption* const declared = declared_;
  option_->check([declared, check](const std::string& text) {
    return check(text) ? std::string() : throw wrong_value(*declared, text);
  });
  return *this;
}

Option Option::type(const char* shown) {
  declared_->value = shown;
  const std::string_view name = shown;
  if (has_option_units(name)) {
    // Runs before all checks, so that they see the number in the option's unit.
    option_->transform([unit = std::string(shown)](const std::string& text) { return in_option_unit(text, unit); });
  }
  declared_->kind = name == "FILE" ? ArgumentKind::file : name == "FOLDER" ? ArgumentKind::folder : ArgumentKind::text;
  return *this;
}
Option Option::one_of(const std::vector<std::string>& names) {
  declared_->choices = names;
  if (!declared_->list && !declared_->value.empty()) type(fmt::format("{}", fmt::join(names, "|")).c_str());
  declared_->kind = ArgumentKind::text;
  // Runs before the check, so that H1 becomes h1.
  option_->transform([names](const std::string& text) {
    const auto alike = [&](const std::string& name) { return lower_case(name) == lower_case(text); };
    const auto match = std::find_if(names.begin(), names.end(), alike);
    return match == names.end() ? text : *match;
  });
  return add_check("",
                   [names](const auto& text) { return std::find(names.begin(), names.end(), text) != names.end(); });
}
Option Option::suggest(const std::vector<std::string>& names) {
  declared_->suggestions = names;
  return *this;
}
Option Option::within(double low, double high) {
  const char* const kind = declared_->whole ? "whole number" : "number";
  return add_check(fmt::format("a {} from {} to {}", kind, low, high),
                   number_check([low, high](double value) { return value >= low && value <= high; }));
}
Option Option::above_zero() {
  return add_check(declared_->whole ? "a whole number above 0" : "a number above 0",
                   number_check([](double value) { return value > 0; }));
}
Option Option::not_negative() {
  return add_check("a number from 0 up", number_check([](double value) { return value >= 0; }));
}
Option Option::finite() {
  option_->transform(plain_number);
  return add_check("a number", number_check([](double) { return true; }));
}
Option Option::counted() {
  declared_->whole = true;
  return add_check("a whole number from 0 up", [declared = declared_](const std::string& text) {
    if (!only_digits(text)) return false;
    std::size_t number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc{}) return true;
    DeclaredOption narrower = *declared;
    narrower.requirement = "a whole number below 2^64";
    throw wrong_value(narrower, text);
  });
}
Option Option::required() {
  option_->required();
  declared_->required = true;
  return *this;
}
Option Option::show_default() {
  option_->capture_default_str();
  declared_->initial = option_->get_default_str();
  return *this;
}

Option Command::declared(const char* names, const char* value, const char* help, CLI::Option* option) {
  const bool is_argument = names[0] != '-';
  auto& place = is_argument ? declared_->arguments : declared_->options;
  place.push_back({.names = names_in(names), .value = value, .help = help, .group = group_});
  DeclaredOption* const made = &place.back();
  made->kind = is_argument ? ArgumentKind::file : ArgumentKind::text;
  if (!is_argument && !made->is_flag()) {  // the name of an option is never a value
    option->check([made, all = declared_](const std::string& text) {
      return find_option(*all, text) == nullptr ? std::string() : throw missing_value(*made);
    });
  }
  return {option, made};
}
Option Command::repeated(const char* names, const char* value, const char* help, CLI::Option* option) {
  const Option made = declared(names, value, help, option);
  made.declared_->repeatable = true;
  return made;
}
Option Command::listed(const char* names, const char* value, const char* help, CLI::Option* option) {
  const Option made = repeated(names, value, help, option->delimiter(',')->allow_extra_args(false));
  made.declared_->list = true;
  return made;
}

Option Command::argument(const char* name, std::string& value, const char* help) {
  return declared(name, "", help, app_->add_option(name, value));
}
Option Command::arguments(const char* name, std::vector<std::string>& values, const char* help) {
  return repeated(name, "", help, app_->add_option(name, values));
}
Option Command::value(const char* names, std::string& value, const char* help) {
  return declared(names, "TEXT", help, app_->add_option(names, value));
}
Option Command::value(const char* names, double& value, const char* help) {
  return declared(names, "NUMBER", help, app_->add_option(names, value)).finite();
}
Option Command::value(const char* names, std::size_t& value, const char* help) {
  return declared(names, "N", help, app_->add_option(names, value)).counted();
}
Option Command::value(const char* names, std::optional<double>& value, const char* help) {
  return declared(names, "NUMBER", help, app_->add_option(names, value)).finite();
}
Option Command::value(const char* names, std::optional<std::size_t>& value, const char* help) {
  return declared(names, "N", help, app_->add_option(names, value)).counted();
}
Option Command::value(const char* names, const std::function<void(const std::string&)>& set, const char* help) {
  return declared(names, "TEXT", help, app_->add_option_function<std::string>(names, set));
}
Option Command::repeatable(const char* names, std::vector<std::string>& values, const char* help) {
  return repeated(names, "TEXT", help, app_->add_option(names, values)->allow_extra_args(false));
}
Option Command::list(const char* names, std::vector<std::string>& values, const char* help) {
  return listed(names, "TEXT,...", help, app_->add_option(names, values));
}
Option Command::list(const char* names, std::vector<double>& values, const char* help) {
  return listed(names, "NUMBER,...", help, app_->add_option(names, values)).finite();
}
Option Command::list(const char* names, std::vector<std::size_t>& values, const char* help) {
  return listed(names, "N,...", help, app_->add_option(names, values)).counted();
}
void Command::flag(const char* names, bool& value, const char* help) {
  declared(names, "", help, app_->add_flag(names, value)->disable_flag_override());
}
std::vector<std::string> Command::given(const std::string& heading) const {
  std::vector<std::string> words;
  for (const DeclaredOption& option : declared_->options) {
    const CLI::Option* const parsed = option.group == heading ? app_->get_option(option.name()) : nullptr;
    if (parsed == nullptr || parsed->count() == 0) continue;
    if (option.is_flag()) {
      words.push_back(option.name());
    } else {
      for (const std::string& value : parsed->results()) words.push_back(option.name() + "=" + value);
    }
  }
  return words;
}
std::string Command::heading(const std::string& name) { return std::exchange(group_, name); }
void Command::about(const char* text) { declared_->about = text; }
void Command::example(const char* command_line, const char* meaning) {
  declared_->examples.push_back({.line = command_line, .meaning = meaning});
}

}  // namespace percuss::tools
