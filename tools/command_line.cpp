#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/error.hpp"

namespace percuss::tools {
namespace {

double number_in(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);  // from_chars takes none
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

CLI::Validator number(const std::string& wanted, const std::function<bool(double)>& holds) {
  return {[wanted, holds](std::string& text) {
            const double value = number_in(text);
            return std::isfinite(value) && holds(value) ? std::string()
                                                        : "'" + one_line(text, 40) + "' is not " + wanted;
          },
          ""};
}

}  // namespace

Option Option::type(const char* shown) {
  option_->type_name(shown);
  return *this;
}
Option Option::one_of(const std::vector<std::string>& names) {
  option_->check(CLI::IsMember(names));
  return *this;
}
Option Option::within(double low, double high) {
  const std::string wanted = fmt::format("a number from {} to {}", low, high);
  option_->check(number(wanted, [low, high](double value) { return value >= low && value <= high; }));
  return *this;
}
Option Option::above_zero() {
  option_->check(number("a number above 0", [](double value) { return value > 0; }));
  return *this;
}
Option Option::not_negative() {
  option_->check(number("a number from 0 up", [](double value) { return value >= 0; }));
  return *this;
}
Option Option::finite() {
  option_->check(number("a number", [](double) { return true; }));
  return *this;
}
Option Option::counted() {
  option_->check({[](std::string& text) {
                    const bool digits = !text.empty() && std::all_of(text.begin(), text.end(),
                                                                     [](char c) { return c >= '0' && c <= '9'; });
                    return digits ? std::string() : "'" + one_line(text, 40) + "' is not a whole number from 0 up";
                  },
                  ""});
  return *this;
}
Option Option::required() {
  option_->required();
  return *this;
}
Option Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option Command::word(const char* name, std::string& value, const char* help) {
  return Option(app_->add_option(name, value, help)->type_name(""));
}
Option Command::words(const char* name, std::vector<std::string>& values, const char* help) {
  return Option(app_->add_option(name, values, help)->type_name(""));
}
Option Command::value(const char* names, std::string& value, const char* help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::value(const char* names, double& value, const char* help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::value(const char* names, std::size_t& value, const char* help) {
  return Option(app_->add_option(names, value, help)).counted();
}
Option Command::value(const char* names, std::optional<double>& value, const char* help) {
  return Option(app_->add_option(names, value, help));
}
Option Command::value(const char* names, std::optional<std::size_t>& value, const char* help) {
  return Option(app_->add_option(names, value, help)).counted();
}
Option Command::value(const char* names, const std::function<void(const std::string&)>& set, const char* help) {
  return Option(app_->add_option_function<std::string>(names, set, help));
}
Option Command::repeatable(const char* names, std::vector<std::string>& values, const char* help) {
  return Option(app_->add_option(names, values, help)->allow_extra_args(false));
}
Option Command::list(const char* names, std::vector<std::string>& values, const char* help) {
  return Option(app_->add_option(names, values, help)->delimiter(',')->allow_extra_args(false));
}
Option Command::list(const char* names, std::vector<double>& values, const char* help) {
  return Option(app_->add_option(names, values, help)->delimiter(',')->allow_extra_args(false));
}
Option Command::list(const char* names, std::vector<std::size_t>& values, const char* help) {
  return Option(app_->add_option(names, values, help)->delimiter(',')->allow_extra_args(false)).counted();
}
void Command::flag(const char* names, bool& value, const char* help) { app_->add_flag(names, value, help); }
std::string Command::heading(const std::string& name) {
  std::string before = app_->option_defaults()->get_group();
  app_->option_defaults()->group(name);
  return before;
}
void Command::example(const char* command_line) { app_->footer(std::string("Example: ") + command_line); }

CommandLine::CommandLine(const char* name, const char* description, const char* version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", std::string(name) + " " + version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

void CommandLine::group(const char* name, const char* description) {
  app_->add_subcommand(name, description)->require_subcommand(1);
}

Command CommandLine::command(const char* name, const char* description, std::function<int()> run) {
  const std::string_view words = name;
  const std::size_t blank = words.find(' ');
  CLI::App* parent =
      blank == std::string_view::npos ? app_.get() : app_->get_subcommand(std::string(words.substr(0, blank)));
  CLI::App* command = parent->add_subcommand(std::string(words.substr(blank + 1)), description);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  return Command(command);
}

// A word that is no command would be called a missing command.
void CommandLine::check_commands(int argc, char** argv) const {
  const CLI::App* app = app_.get();
  std::string before;  // the words so far
  for (int i = 1; i < argc && argv[i][0] != '-'; ++i) {
    const auto all = app->get_subcommands(nullptr);
    if (all.empty()) return;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto* one) { return one->check_name(argv[i]); });
    if (found == all.end()) {
      throw UsageError("there is no command '" + before + one_line(argv[i], 40) + "'",
                       "percuss " + before + "--help lists them");
    }
    app = *found;
    before += app->get_name() + " ";
  }
}

int CommandLine::run(int argc, char** argv) {
  check_commands(argc, argv);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app_->exit(e);  // --help and --version
  } catch (const CLI::ParseError& e) {
    throw UsageError(one_line(e.what()), "see percuss --help or percuss COMMAND --help");
  }
  return chosen_();
}

}  // namespace percuss::tools
