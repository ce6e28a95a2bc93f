#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss::acquire {

struct ForkRequest;
struct ForkCommand;

/// A small process that forks confined readers for this one. To fork a process that has threads and much memory slows
/// down all of its threads; this one is forked once, before there are any, and stays small. It ends with the object, or
/// with this process however that ends.
class ForkServer {
 public:
  using Open = std::function<SandboxService(const std::string& path)>;
  /// `open` is called in the readers. errors  InputError: no process can be started.
  explicit ForkServer(const Open& open);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // For SandboxProcess; several threads may call at once.
  /// Has a reader started, and does not wait until it is there; it gets copies of the descriptors: to talk, and of the
  /// memory. The reader's number; −1 when nobody can be asked.
  int start(const std::string& path, int descriptor, int memory);
  /// The reader's number when it has ended, and how, as waitpid tells it; 0 when it has not; −1 when there is none.
  int ended(int reader, int& status);
  /// Ends a reader, and tells how it ended.
  void end(int reader, int& status);
  /// Ends a reader without waiting until it has; last.
  void release(int reader);

  /// Whether it has ended before its time: nobody answers any more.
  bool lost() const { return lost_; }

 private:
  bool tell(const ForkRequest& request);
  int ask(const ForkCommand& command, int& status);

  std::mutex mutex_;  // from a question to its answer
  std::atomic<int> readers_{0};
  std::atomic<bool> lost_{false};
  int descriptor_ = -1;
  int process_ = -1;
};

}  // namespace percuss::acquire
