#pragma once
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace percuss::test {

/// A limit of resources, as `ulimit` sets one: {RLIMIT_FSIZE, 4096}.
struct ProcessLimit {
  int resource = 0;
  std::size_t value = 0;
};

/// How to run the percuss program.
struct ProcessOptions {
  std::string input;                       // file for standard input; empty: /dev/null
  std::string output;                      // file for standard output; empty: captured in the outcome
  std::string folder;                      // working folder; empty: the current one
  std::vector<std::string> environment{};  // NAME=VALUE, in addition to the current environment
  bool ordinary_user = false;              // drop root's privileges first
  std::function<void()> prepare{};         // runs in the new process before the program
  std::size_t max_address_bytes = 0;       // limit of the address space; 0: the current limit
  std::vector<ProcessLimit> limits{};      // further limits
  std::vector<int> closed{};               // standard streams that are closed: {0, 1}
  std::chrono::seconds time_limit{110};    // then it is killed; sanitizers make programs twenty times slower
};

/// The outcome of a run.
struct ProcessOutcome {
  int code = -1;               // exit code; −1 if a signal ended the process
  int signal = 0;              // the signal, or 0
  bool timed_out = false;      // killed after the time limit
  std::size_t peak_bytes = 0;  // peak of the resident memory, of the process or a child of it
  double processor_s = 0;      // processor time, children included
  std::string out, err;
};

/// Runs the built percuss with these arguments, without a shell.
ProcessOutcome run_percuss(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

/// A null-terminated list for exec, of pointers to the texts.
std::vector<char*> c_strings(std::vector<std::string>& texts);

/// The lines of a text, including a last line without a newline.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace percuss::test
