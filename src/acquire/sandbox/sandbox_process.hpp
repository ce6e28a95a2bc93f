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

namespace percuss {

/// What a confined reader offers: a description as bytes, and numbers on request.
struct ConfinedService {
  std::string description;
  /// Numbers first … first + out.size() − 1 of a row's signal; the meaning of `signal` is the opener's affair.
  std::function<void(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out)> read;
};

class ReaderNursery;

/// A child process that has opened a foreign file with `open` and serves it until this object goes. It runs confined
/// (confine_this_process): whatever the file does to the library that reads it, this process only sees an InputError.
class ConfinedProcess {
 public:
  /// `patience_s`: how long an answer of the child may take by the clock; by itself as the file's size allows.
  /// errors  InputError: what `open` threw (also UnclearColumns); the child crashed or ran into a limit, in one line.
  ConfinedProcess(std::string path, const std::function<ConfinedService()>& open,
                  std::optional<unsigned> patience_s = std::nullopt);
  /// The same, forked by the nursery, with what it opens files with.
  ConfinedProcess(std::string path, std::shared_ptr<ReaderNursery> nursery);
  ~ConfinedProcess();
  ConfinedProcess(const ConfinedProcess&) = delete;
  ConfinedProcess& operator=(const ConfinedProcess&) = delete;

  const std::string& description() const { return description_; }
  /// Several threads may call at once. errors  as above.
  void read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out);
  /// "this file says nonsense": for what the child says that cannot be.
  [[noreturn]] void distrust() const;

 private:
  /// Sets everything up around start(the reader's end, memory), which gives a process number.
  void begin(const std::function<int(int descriptor, int memory)>& start);
  int ended(int& status) const;  // as ReaderNursery::ended
  void receive_outcome(std::string& payload);
  int end_child();  // how it ended, as waitpid tells it
  [[noreturn]] void report_death();
  [[noreturn]] void report_no_process() const;
  [[noreturn]] void report_slowness() const;
  [[noreturn]] void report_no_memory() const;
  void receive(void* to, std::size_t bytes);

  std::string path_, description_;
  std::uint64_t file_bytes_ = 0;
  unsigned patience_s_ = 0;
  std::mutex mutex_;
  double* shared_ = nullptr;  // what the child writes numbers into
  int descriptor_ = -1;
  int child_ = -1;                          // its process; with a nursery its number there
  std::shared_ptr<ReaderNursery> nursery_;  // whose child it is; nullptr: this process's
};

/// What a reader's process does until its parent has heard enough; returns its exit code. `shared` holds
/// kSharedNumbers.
int serve_confined(int descriptor, double* shared, std::uint64_t file_bytes,
                   const std::function<ConfinedService()>& open);
inline constexpr std::size_t kSharedNumbers = std::size_t{1} << 17U;  // that go over at once: 1 MiB

}  // namespace percuss
