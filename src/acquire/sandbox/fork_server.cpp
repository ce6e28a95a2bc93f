#include "acquire/sandbox/fork_server.hpp"

#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "acquire/sandbox/child_process.hpp"
#include "acquire/sandbox/fork_request.hpp"
#include "acquire/sandbox/fork_server_process.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

ForkServer::ForkServer(const Open& open) {
  std::array<int, 2> ends{};
  const bool paired = ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0;
  process_ = paired ? fork_child() : -1;
  if (process_ == 0) {
    try {
      keep_only_descriptors({ends[1]});
      run_fork_server(0, open);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  if (paired) ::close(ends[1]);
  descriptor_ = paired ? ends[0] : -1;
  if (process_ > 0) return;
  if (paired) ::close(descriptor_);
  throw MachineFault("cannot start a process", "reading files in child processes",
                     "close other programs, or trust the input", {"trust_input"});
}

ForkServer::~ForkServer() {
  ::close(descriptor_);
  ::waitpid(process_, nullptr, 0);
}

int ForkServer::start(const std::string& path, const ReaderDescriptors& descriptors) {
  const int reader = ++readers_;
  const bool sent = send({.command = {.kind = kStartReader, .reader = reader, .cpu = ::sched_getcpu()},
                          .path = path,
                          .descriptors = descriptors});
  return sent ? reader : -1;
}

int ForkServer::ended(int reader, int& status) { return send_and_receive({.kind = kPoll, .reader = reader}, status); }
void ForkServer::kill_and_wait(int reader, int& status) {
  send_and_receive({.kind = kKillReader, .reader = reader}, status);
}
void ForkServer::release(int reader) { send({.command = {.kind = kRelease, .reader = reader}}); }

bool ForkServer::send(const ForkRequest& request) {
  if (!send_fork_request(descriptor_, request)) lost_ = true;
  return !lost_;
}

int ForkServer::send_and_receive(const ForkCommand& command, int& status) {
  ForkReply reply;
  const std::lock_guard lock(mutex_);
  if (!send({.command = command})) return -1;
  ssize_t received = -1;
  do {
    received = ::recv(descriptor_, &reply, sizeof reply, 0);
  } while (received < 0 && errno == EINTR);
  if (received != static_cast<ssize_t>(sizeof reply)) lost_ = true;
  if (lost_) return -1;
  status = reply.status;
  return reply.reader;
}

}  // namespace percuss::acquire
