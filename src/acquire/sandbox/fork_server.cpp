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

namespace percuss {

ReaderNursery::ReaderNursery(const Open& open) {
  std::array<int, 2> ends{};
  const bool paired = ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0;
  process_ = paired ? ::fork() : -1;
  if (process_ == 0) {
    ::close(ends[0]);
    try {
      serve_nursery(ends[1], open);
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

ReaderNursery::~ReaderNursery() {
  ::close(descriptor_);
  ::waitpid(process_, nullptr, 0);
}

int ReaderNursery::start(const std::string& path, int descriptor, int memory) {
  const int reader = ++readers_;
  const bool told = tell({.question = {.kind = kStart, .reader = reader, .processor = ::sched_getcpu()},
                          .path = path,
                          .descriptors = {descriptor, memory}});
  return told ? reader : -1;
}

int ReaderNursery::ended(int reader, int& status) { return ask({.kind = kEnded, .reader = reader}, status); }
void ReaderNursery::end(int reader, int& status) { ask({.kind = kEnd, .reader = reader}, status); }
void ReaderNursery::forget(int reader) { tell({.question = {.kind = kForget, .reader = reader}}); }

bool ReaderNursery::tell(const NurseryLetter& letter) {
  if (!send_letter(descriptor_, letter)) lost_ = true;
  return !lost_;
}

int ReaderNursery::ask(const NurseryQuestion& question, int& status) {
  NurseryAnswer answer;
  const std::lock_guard lock(mutex_);
  if (!tell({.question = question})) return -1;
  ssize_t got = -1;
  do {
    got = ::recv(descriptor_, &answer, sizeof answer, 0);
  } while (got < 0 && errno == EINTR);
  if (got != static_cast<ssize_t>(sizeof answer)) lost_ = true;
  if (lost_) return -1;
  status = answer.status;
  return answer.reader;
}

}  // namespace percuss
