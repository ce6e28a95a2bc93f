#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::acquire {

/// What a confined reader offers: a description as bytes, and numbers on request.
struct SandboxService {
  std::string description;
  /// Numbers first … first + out.size() − 1 of a row's signal; the meaning of `signal` is the opener's affair.
  std::function<void(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out)> read;
};

class ForkServer;

/// A child process that has opened a foreign file with `open` and serves it until this object goes. It runs confined
/// (enter_sandbox): whatever the file does to the library that reads it, this process only sees an InputError.
class SandboxProcess {
 public:
  /// `timeout_s`: how long an answer of the child may take by the clock; by itself as the file's size allows.
  /// errors  InputError: what `open` threw (also AmbiguousColumns); the child crashed or ran into a limit, in one line.
  SandboxProcess(std::string path, const std::function<SandboxService()>& open,
                 std::optional<unsigned> timeout_s = std::nullopt);
  /// The same, forked by the nursery, with what it opens files with.
  SandboxProcess(std::string path, std::shared_ptr<ForkServer> fork_server);
  ~SandboxProcess();
  SandboxProcess(const SandboxProcess&) = delete;
  SandboxProcess& operator=(const SandboxProcess&) = delete;

  const std::string& description() const { return description_; }
  /// Several threads may call at once. errors  as above.
  void read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out);
  /// "this file says nonsense": for what the child says that cannot be.
  [[noreturn]] void report_contradiction() const;

 private:
  /// Sets everything up around start(the reader's end, memory), which gives a process number.
  void begin(const std::function<int(int descriptor, int memory)>& start);
  int ended(int& status) const;  // as ForkServer::ended
  void receive_outcome(std::string& payload);
  int kill_child();  // how it ended, as waitpid tells it
  [[noreturn]] void report_crash();
  [[noreturn]] void report_no_process() const;
  [[noreturn]] void report_timeout() const;
  [[noreturn]] void report_no_memory() const;
  void receive(void* to, std::size_t bytes);

  std::string path_, description_;
  std::uint64_t file_bytes_ = 0;
  unsigned timeout_s_ = 0;
  std::mutex mutex_;
  double* shared_ = nullptr;  // what the child writes numbers into
  int descriptor_ = -1;
  int child_ = -1;                           // its process; with a nursery its number there
  std::shared_ptr<ForkServer> fork_server_;  // whose child it is; nullptr: this process's
};

/// What a reader's process does until its parent has heard enough; returns its exit code. `shared` holds
/// kSharedNumbers.
int serve_in_sandbox(int descriptor, double* shared, std::uint64_t file_bytes,
                     const std::function<SandboxService()>& open);
inline constexpr std::size_t kSharedNumbers = std::size_t{1} << 17U;  // that go over at once: 1 MiB

}  // namespace percuss::acquire
