#include "acquire/sandbox/fork_server.hpp"

#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "acquire/sandbox/fork_request.hpp"
#include "acquire/sandbox/fork_server_process.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

ForkServer::ForkServer(const Open& open) {
  std::array<int, 2> ends{};
  const bool paired = ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0;
  process_ = paired ? ::fork() : -1;
  if (process_ == 0) {
    ::close(ends[0]);
    try {
      run_fork_server(ends[1], open);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  if (paired) ::close(ends[1]);
  descriptor_ = paired ? ends[0] : -1;
  if (process_ > 0) return;
  if (paired) ::close(descriptor_);
  throw InputError("no process can be started to read files in", "batch",
                   "close other programs, or give --trust-input");
}

ForkServer::~ForkServer() {
  ::close(descriptor_);
  ::waitpid(process_, nullptr, 0);
}

int ForkServer::start(const std::string& path, int descriptor, int memory) {
  const int reader = ++readers_;
  const bool told = tell({.command = {.kind = kStartReader, .reader = reader, .processor = ::sched_getcpu()},
                          .path = path,
                          .descriptors = {descriptor, memory}});
  return told ? reader : -1;
}

int ForkServer::ended(int reader, int& status) { return ask({.kind = kPoll, .reader = reader}, status); }
void ForkServer::end(int reader, int& status) { ask({.kind = kKillReader, .reader = reader}, status); }
void ForkServer::release(int reader) { tell({.command = {.kind = kRelease, .reader = reader}}); }

bool ForkServer::tell(const ForkRequest& request) {
  if (!send_fork_request(descriptor_, request)) lost_ = true;
  return !lost_;
}

int ForkServer::ask(const ForkCommand& command, int& status) {
  ForkReply reply;
  const std::lock_guard lock(mutex_);
  if (!tell({.command = command})) return -1;
  ssize_t got = -1;
  do {
    got = ::recv(descriptor_, &reply, sizeof reply, 0);
  } while (got < 0 && errno == EINTR);
  if (got != static_cast<ssize_t>(sizeof reply)) lost_ = true;
  if (lost_) return -1;
  status = reply.status;
  return reply.reader;
}

}  // namespace percuss::acquire
