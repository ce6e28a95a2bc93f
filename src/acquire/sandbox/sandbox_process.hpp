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

/// The service of a sandboxed process: a description as bytes, and numbers on request.
struct SandboxService {
  std::string description;
  /// Numbers first … first + out.size() − 1 of a row's signal. The opener defines the meaning of `signal`.
  std::function<void(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out)> read;
};

/// The descriptors that a reader needs: its end of a socket, the memory for numbers, and a pipe whose other end closes
/// when the parent ends.
struct ReaderDescriptors {
  int socket = -1, memory = -1, parent_pipe = -1;
};

class ForkServer;
enum class SandboxOutcome : std::uint64_t;

/// A child process that opens a foreign file with `open` and serves it during the lifetime of this object. The child is
/// restricted by enter_sandbox. Whatever the file does to the library that reads it, this process sees only an
/// InputError.
class SandboxProcess {
 public:
  /// `timeout_s`: wall-clock limit for each answer of the child; the default follows from the file's size.
  /// errors  InputError: the error of `open` (also AmbiguousColumns); the child crashed or exceeded a limit
  SandboxProcess(std::string path, const std::function<SandboxService()>& open,
                 std::optional<unsigned> timeout_s = std::nullopt);
  /// As above. The fork server forks the child, which opens the file with the server's `open`.
  SandboxProcess(std::string path, std::shared_ptr<ForkServer> fork_server);
  ~SandboxProcess();
  SandboxProcess(const SandboxProcess&) = delete;
  SandboxProcess& operator=(const SandboxProcess&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t file_bytes() const { return file_bytes_; }
  const std::string& description() const { return description_; }
  /// Copies numbers from the child, as SandboxService::read. Several threads may call at the same time.
  /// errors  InputError: as above; a process other than the one that created the object calls, after a fork
  void read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out);
  /// Throws the InputError for an impossible description.
  [[noreturn]] void report_contradiction() const;

 private:
  /// Creates the descriptors, starts the child and receives its description. `start` gets the child's descriptors and
  /// returns a process number.
  void begin(const std::function<int(const ReaderDescriptors&)>& start);
  bool create_descriptors(ReaderDescriptors& of_child);
  bool is_owner() const;
  int ended(int& status) const;  // as ForkServer::ended
  void receive_outcome(std::string& payload);
  void close_descriptors();
  int kill_child();  // returns the child's status as from waitpid; 0 without a child
  [[noreturn]] void report_crash();
  [[noreturn]] void report_no_process() const;
  [[noreturn]] void report_timeout() const;
  [[noreturn]] void report_processor_time() const;
  [[noreturn]] void report_no_memory() const;
  [[noreturn]] void report_no_memory_for_all() const;
  [[noreturn]] void rethrow(SandboxOutcome outcome, const std::string& payload) const;
  void receive(void* to, std::size_t bytes);

  std::string path_, description_;
  std::uint64_t file_bytes_ = 0;
  unsigned timeout_s_ = 0;
  std::mutex mutex_;
  double* shared_ = nullptr;  // the child writes numbers here
  int descriptor_ = -1, pipe_ = -1;
  int owner_ = -1;                           // the process that opened the file
  int child_ = -1;                           // process number; with a fork server, the server's number of the reader
  std::shared_ptr<ForkServer> fork_server_;  // parent of the child; nullptr: this process
};

}  // namespace percuss::acquire
