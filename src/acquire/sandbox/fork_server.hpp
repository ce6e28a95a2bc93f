#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss::acquire {

struct ForkRequest;
struct ForkCommand;

/// A small process that forks sandboxed readers for this process. Forking a process with threads and much memory slows
/// down all its threads. Create the server before any thread: it then stays small. It ends with this object, or with
/// this process.
class ForkServer {
 public:
  using Open = std::function<SandboxService(const std::string& path)>;
  /// The readers call `open`.
  /// errors  MachineFault: no process can be started
  explicit ForkServer(const Open& open);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // For SandboxProcess. Several threads may call at the same time.
  /// Requests a reader and does not wait for it. The reader gets copies of the descriptors. Returns the reader's
  /// number; −1 when the server has ended.
  int start(const std::string& path, const ReaderDescriptors& descriptors);
  /// The reader's number when it has ended, with its status as from waitpid; 0 while it runs; −1 for an unknown reader,
  /// and when the server has ended.
  int ended(int reader, int& status);
  /// Kills a reader and waits for its status.
  void kill_and_wait(int reader, int& status);
  /// Kills a reader without waiting. Its number is not valid afterwards.
  void release(int reader);

  /// Whether the server has ended unexpectedly: requests get no reply.
  bool lost() const { return lost_; }

 private:
  bool send(const ForkRequest& request);
  int send_and_receive(const ForkCommand& command, int& status);

  std::mutex mutex_;  // held from a command to its reply
  std::atomic<int> readers_{0};
  std::atomic<bool> lost_{false};
  int descriptor_ = -1;
  int process_ = -1;
};

}  // namespace percuss::acquire
