#include "acquire/sandbox/fork_server_process.hpp"

#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/sandbox/child_process.hpp"
#include "acquire/sandbox/fork_request.hpp"
#include "acquire/sandbox/serve_in_sandbox.hpp"

namespace percuss::acquire {
namespace {

// Pins this process and the children that it forks to `cpu` while the object lives. The requesting thread sleeps until
// its reader answers, so its processor is free. Without pinning, the kernel often starts the reader on a busy
// processor.
class CpuPinning {
 public:
  explicit CpuPinning(int cpu) {
    if (cpu < 0 || cpu >= CPU_SETSIZE || ::sched_getaffinity(0, sizeof allowed_, &allowed_) != 0) return;
    cpu_set_t pinned;
    CPU_ZERO(&pinned);
    CPU_SET(static_cast<std::size_t>(cpu), &pinned);
    pinned_ = ::sched_setaffinity(0, sizeof pinned, &pinned) == 0;
  }
  ~CpuPinning() {
    if (pinned_) ::sched_setaffinity(0, sizeof allowed_, &allowed_);
  }
  CpuPinning(const CpuPinning&) = delete;
  CpuPinning& operator=(const CpuPinning&) = delete;

 private:
  cpu_set_t allowed_{};
  bool pinned_ = false;
};

// The readers of the server. Released readers are reaped before the next start: waiting for them would delay requests.
class Readers {
 public:
  explicit Readers(const ForkServer::Open& open) : open_(open) {}

  void start(const ForkRequest& request) {
    reap();
    const int process = fork_on_cpu(request.command.cpu);
    if (process > 0) processes_[request.command.reader] = process;
    if (process != 0) return;
    ::_exit(serve_in_sandbox(request.descriptors, request.path, [&] { return open_(request.path); }));
  }

  ForkReply ended(int reader, int flags) {
    ForkReply reply;
    const auto found = processes_.find(reader);
    if (found == processes_.end()) return reply;
    const int process = ::waitpid(found->second, &reply.status, flags);
    if (process == 0) reply.reader = 0;
    if (process <= 0) return reply;
    processes_.erase(found);
    reply.reader = reader;
    return reply;
  }

  ForkReply kill_and_wait(int reader) {
    kill(reader);
    return ended(reader, 0);
  }

  void release(int reader) {
    kill(reader);
    released_.insert(reader);
  }

 private:
  static int fork_on_cpu(int cpu) {
    const CpuPinning pinning(cpu);
    return fork_child();
  }
  // A reader in `processes_` has not been reaped, so its process number is still its own.
  void kill(int reader) {
    const auto found = processes_.find(reader);
    if (found != processes_.end()) ::kill(found->second, SIGKILL);
  }
  void reap() {
    std::erase_if(released_, [&](int reader) { return ended(reader, WNOHANG).reader != 0; });
  }

  const ForkServer::Open& open_;
  std::map<int, int> processes_;  // of readers that have not been reaped
  std::set<int> released_;
};

}  // namespace

void run_fork_server(int socket, const ForkServer::Open& open) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);  // the parent handles them
  hdf5::start_library();                                                            // once, for all readers
  Readers readers(open);
  while (const auto request = receive_fork_request(socket)) {
    const ForkCommand& command = request->command;
    const ReaderDescriptors& descriptors = request->descriptors;
    const bool has_descriptors = descriptors.socket >= 0;
    if (command.kind == kStartReader && has_descriptors) readers.start(*request);
    for (const int descriptor : {descriptors.socket, descriptors.memory, descriptors.parent_pipe}) {
      if (has_descriptors) ::close(descriptor);
    }
    if (command.kind == kRelease) readers.release(command.reader);
    if (command.kind != kPoll && command.kind != kKillReader) continue;
    const ForkReply reply =
        command.kind == kKillReader ? readers.kill_and_wait(command.reader) : readers.ended(command.reader, WNOHANG);
    if (::send(socket, &reply, sizeof reply, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof reply)) return;
  }
}

}  // namespace percuss::acquire
