#pragma once
#include <CLI/CLI.hpp>

namespace percuss::tools {

/// What a number on the command line must be. Unlike CLI11's own checks these refuse NaN and infinity, and say so in
/// words.
CLI::Validator above_zero();
CLI::Validator not_negative();
CLI::Validator finite();
/// Digits only: CLI11 would take −1 as a very large count.
CLI::Validator counted();

}  // namespace percuss::tools
