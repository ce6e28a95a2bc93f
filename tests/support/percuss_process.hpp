#pragma once
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::test {

/// How the percuss program is to be run.
struct ProcessOptions {
  std::string input;                       // the file that is its standard input; empty: none (/dev/null)
  std::string output;                      // the file that is its standard output; empty: kept in the outcome
  std::string folder;                      // its working folder; empty: this one
  std::vector<std::string> environment{};  // NAME=VALUE, beside this process's own
  bool ordinary_user = false;              // give up root's rights first, where the tests have them
  std::size_t most_address_bytes = 0;      // that it may have; 0: as this process may
  std::chrono::seconds limit{110};         // sanitized programs are twenty times slower
};

/// What it did.
struct ProcessOutcome {
  int code = -1;               // exit code; −1 when a signal ended it
  int signal = 0;              // the signal; 0 when there was none
  bool timed_out = false;      // killed, as it did not end within the limit
  std::size_t peak_bytes = 0;  // of its resident memory
  std::string out, err;
};

/// Runs the built percuss with these arguments, as a user would, without a shell between.
ProcessOutcome run_percuss(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

/// The lines of a text; a last line without its end counts.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace percuss::test
