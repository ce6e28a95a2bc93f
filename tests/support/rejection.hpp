#pragma once
#include <string>
#include <vector>

#include "support/percuss_process.hpp"

namespace percuss::test {

/// Runs percuss on unusable input and checks the rejection: percuss ends soon with exit code 3, prints one line with
/// `named` and a remedy on standard error and nothing on standard output, and needs little memory. It leaves no file,
/// although it is asked for one of each kind in `outputs` (".json", …). Returns the line.
std::string rejection_of(const std::vector<std::string>& arguments, const std::vector<std::string>& outputs,
                         const std::string& named, const ProcessOptions& options = {});

/// Checks that percuss refuses these arguments: exit code 2, and one line on standard error that contains `named`.
void expect_usage_error(const std::vector<std::string>& arguments, const std::string& named);

/// Checks the rejection by the commands analyze, frf, calibrate and info.
void expect_reading_commands_reject(const std::string& path, const std::string& named,
                                    const ProcessOptions& options = {});
/// Checks the rejection by the commands analyze and frf.
void expect_analyses_reject(const std::string& path, const std::string& named, const ProcessOptions& options = {});

}  // namespace percuss::test
