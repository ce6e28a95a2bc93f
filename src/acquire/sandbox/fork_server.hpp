#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss {

struct NurseryLetter;
struct NurseryQuestion;

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
  /// Has a reader started, and does not wait until it is there; it gets copies of the descriptors: to talk, and of the
  /// memory. The reader's number; −1 when nobody can be asked.
  int start(const std::string& path, int descriptor, int memory);
  /// The reader's number when it has ended, and how, as waitpid tells it; 0 when it has not; −1 when there is none.
  int ended(int reader, int& status);
  /// Ends a reader, and tells how it ended.
  void end(int reader, int& status);
  /// Ends a reader without waiting until it has; last.
  void forget(int reader);

  /// Whether it has ended before its time: nobody answers any more.
  bool lost() const { return lost_; }

 private:
  bool tell(const NurseryLetter& letter);
  int ask(const NurseryQuestion& question, int& status);

  std::mutex mutex_;  // from a question to its answer
  std::atomic<int> readers_{0};
  std::atomic<bool> lost_{false};
  int descriptor_ = -1;
  int process_ = -1;
};

}  // namespace percuss
