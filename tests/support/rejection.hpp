#pragma once
#include <string>
#include <vector>

#include "support/percuss_process.hpp"

namespace percuss::test {

/// Runs percuss on input that it cannot use and holds it to its promise: it ends soon and by itself with exit code 3,
/// with one line on standard error that names `named` and a remedy, nothing on standard output, without much memory,
/// and leaves no file behind although it is asked for one of each of the kinds in `outputs` (".json", …). Returns the
/// line.
std::string rejection_of(const std::vector<std::string>& arguments, const std::vector<std::string>& outputs,
                         const std::string& named, const ProcessOptions& options = {});

/// The same for each command that reads records: analyze, frf, calibrate and info.
void expect_every_command_rejects(const std::string& path, const std::string& named,
                                  const ProcessOptions& options = {});
/// … and for those that read the samples, which info does not: analyze and frf.
void expect_analyses_reject(const std::string& path, const std::string& named, const ProcessOptions& options = {});

}  // namespace percuss::test
