#include "support/percuss_process.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace percuss::test {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t end) { ::close(std::exchange(ends[end], -1)); }
  std::array<int, 2> ends{-1, -1};
};

// From the next exec on, permissions apply to root too. The process keeps its user, because another user might not have
// access to the libraries.
bool give_up_root_rights() {
  return ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) == 0 && ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH) == 0;
}

// Between fork and exec, only system calls are allowed.
[[noreturn]] void become_percuss(char* const* arguments, char* const* environment, const ProcessOptions& options,
                                 const Pipe& out, const Pipe& err) {
  const int program = ::open(PERCUSS_EXECUTABLE, O_RDONLY | O_CLOEXEC);
  const int input = ::open(options.input.empty() ? "/dev/null" : options.input.c_str(), O_RDONLY | O_CLOEXEC);
  const int output =
      options.output.empty() ? out.ends[1] : ::open(options.output.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  bool ready = program >= 0 && ::dup2(input, 0) == 0 && ::dup2(output, 1) == 1 && ::dup2(err.ends[1], 2) == 2;
  ready = ready && (options.folder.empty() || ::chdir(options.folder.c_str()) == 0);
  if (options.max_address_bytes > 0) {
    const rlimit limit{.rlim_cur = options.max_address_bytes, .rlim_max = options.max_address_bytes};
    ready = ready && ::setrlimit(RLIMIT_AS, &limit) == 0;
  }
  for (const ProcessLimit& one : options.limits) {
    const rlimit limit{.rlim_cur = one.value, .rlim_max = one.value};
    ready = ready && ::setrlimit(one.resource, &limit) == 0;
  }
  for (const int stream : options.closed) ::close(stream);
  if (options.ordinary_user && ::geteuid() == 0) ready = ready && give_up_root_rights();
  if (options.prepare) options.prepare();
  if (ready) ::fexecve(program, arguments, environment);
  ::_exit(127);
}

// Reads the available bytes; returns false once the writer has closed its end.
bool drain(int end, std::string& text) {
  std::array<char, 65536> block{};
  const ssize_t got = ::read(end, block.data(), block.size());
  if (got > 0) text.append(block.data(), static_cast<std::size_t>(got));
  return got > 0;
}

// Reads both streams to their end; returns false if the deadline passes first.
bool read_both(const Pipe& out, const Pipe& err, ProcessOutcome& outcome, Clock::time_point deadline) {
  std::array<pollfd, 2> streams{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    ::poll(streams.data(), streams.size(), static_cast<int>(left));
    if (streams[0].revents != 0 && !drain(streams[0].fd, outcome.out)) streams[0].fd = -1;
    if (streams[1].revents != 0 && !drain(streams[1].fd, outcome.err)) streams[1].fd = -1;
  }
  return true;
}

}  // namespace

ProcessOutcome run_percuss(const std::vector<std::string>& arguments, const ProcessOptions& options) {
  std::vector<std::string> words{"percuss"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = options.environment;
  for (char** entry = environ; *entry != nullptr; ++entry) environment.emplace_back(*entry);
  const std::vector<char*> argument_list = c_strings(words), environment_list = c_strings(environment);
  Pipe out, err;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_percuss(argument_list.data(), environment_list.data(), options, out, err);
  out.close_end(1);
  err.close_end(1);
  ProcessOutcome outcome;
  outcome.timed_out = !read_both(out, err, outcome, Clock::now() + options.time_limit);
  if (outcome.timed_out) ::kill(child, SIGKILL);
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child) throw std::runtime_error("the process is lost");
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  outcome.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  outcome.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return outcome;
}

std::vector<char*> c_strings(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace percuss::test
