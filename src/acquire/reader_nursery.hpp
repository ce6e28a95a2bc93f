#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "acquire/confined_process.hpp"

struct msghdr;

namespace percuss {

/// A small process that forks confined readers for this one. To fork a process that has threads and much memory slows
/// down all of its threads; this one is forked once, before there are any, and stays small. It ends with the object, or
/// with this process however that ends.
class ReaderNursery {
 public:
  using Open = std::function<ConfinedService(const std::string& path)>;
  /// `open` is called in the readers. errors  InputError: no process can be started.
  explicit ReaderNursery(const Open& open);
  ~ReaderNursery();
  ReaderNursery(const ReaderNursery&) = delete;
  ReaderNursery& operator=(const ReaderNursery&) = delete;

  // For ConfinedProcess; several threads may call at once.
  /// A reader's process number; −1 when there is none. It gets copies of the descriptors: to talk, and of the memory.
  int start(const std::string& path, int descriptor, int memory);
  /// As waitpid for a process of start().
  int wait(int process, int& status, int flags);
  /// Ends a process of start() without waiting until it has; last.
  void forget(int process);

  /// Whether it has ended before its time: nobody answers any more.
  bool lost() const { return lost_; }

 private:
  int ask(const msghdr& question, int& status);

  std::mutex mutex_;
  std::atomic<bool> lost_{false};
  int descriptor_ = -1;
  int process_ = -1;
};

}  // namespace percuss
