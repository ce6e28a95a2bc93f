#pragma once
#include <string>

#include "cli/declaration.hpp"
#include "cli/option_error.hpp"
#include "core/error.hpp"

namespace percuss::tools {

// Errors of the command line. Each message is one line: it names the wrong word and says what to type instead. An error
// that Python can meet too is an OptionError.

UsageError missing_command(const Declaration& all, const DeclaredCommand& group);
UsageError unknown_command(const Declaration& all, const DeclaredCommand& group, const std::string& typed);
UsageError unknown_option(const Declaration& all, const DeclaredCommand& command, const std::string& typed);
/// An option that stands before the name of its command.
UsageError option_before_command(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option);
/// An argument more than the command takes.
UsageError extra_argument(const Declaration& all, const DeclaredCommand& command, const std::string& typed);
UsageError missing_option(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option);
OptionError missing_value(const DeclaredOption& option);
UsageError flag_with_value(const DeclaredOption& option);
OptionError given_twice(const DeclaredOption& option);
OptionError wrong_value(const DeclaredOption& option, const std::string& typed);

}  // namespace percuss::tools
