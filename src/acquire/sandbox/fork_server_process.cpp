#include "acquire/sandbox/fork_server_process.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/sandbox/fork_request.hpp"

namespace percuss::acquire {
namespace {

int run_reader(const ForkServer::Open& open, const std::string& path, int descriptor, int memory) {
  struct stat status {};
  const std::uint64_t bytes = ::stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  void* const shared = ::mmap(nullptr, kSharedNumbers * sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
  if (shared == MAP_FAILED) return 1;
  return serve_in_sandbox(descriptor, static_cast<double*>(shared), bytes, [&] { return open(path); });
}

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
  Readers(int socket, const ForkServer::Open& open) : socket_(socket), open_(open) {}

  void start(const ForkRequest& request) {
    reap();
    const int process = fork_on_cpu(request.command.cpu);
    if (process > 0) processes_[request.command.reader] = process;
    if (process != 0) return;
    ::close(socket_);
    ::_exit(run_reader(open_, request.path, request.descriptors[0], request.descriptors[1]));
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
    return ::fork();
  }
  // A reader in `processes_` has not been reaped, so its process number is still its own.
  void kill(int reader) {
    const auto found = processes_.find(reader);
    if (found != processes_.end()) ::kill(found->second, SIGKILL);
  }
  void reap() {
    std::erase_if(released_, [&](int reader) { return ended(reader, WNOHANG).reader != 0; });
  }

  int socket_;  // only the server uses it: readers close their copy
  const ForkServer::Open& open_;
  std::map<int, int> processes_;  // of readers that have not been reaped
  std::set<int> released_;
};

}  // namespace

void run_fork_server(int socket, const ForkServer::Open& open) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);  // the parent handles them
  hdf5::start_library();                                                            // once, for all readers
  Readers readers(socket, open);
  while (const auto request = receive_fork_request(socket)) {
    const ForkCommand& command = request->command;
    const bool has_descriptors = request->descriptors.front() >= 0;
    if (command.kind == kStartReader && has_descriptors) readers.start(*request);
    for (const int descriptor : request->descriptors) {
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
