#include "acquire/reader_nursery.hpp"

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "acquire/nursery_letter.hpp"
#include "acquire/nursery_service.hpp"
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
  if (path.size() > kLongestPath) return -1;
  std::string name = path;
  NurseryQuestion question{.kind = kStart, .reader = ++readers_, .processor = ::sched_getcpu()};
  NurseryLetter envelope(question, name.data(), name.size());
  const std::array<int, kDescriptors> descriptors{descriptor, memory};
  envelope.enclose(descriptors.data());
  return tell(envelope.header) ? question.reader : -1;
}

int ReaderNursery::ended(int reader, int& status) {
  NurseryQuestion question{.kind = kEnded, .reader = reader};
  NurseryLetter envelope(question, nullptr, 0);
  return ask(envelope.header, status);
}

void ReaderNursery::end(int reader, int& status) {
  NurseryQuestion question{.kind = kEnd, .reader = reader};
  NurseryLetter envelope(question, nullptr, 0);
  ask(envelope.header, status);
}

void ReaderNursery::forget(int reader) {
  NurseryQuestion question{.kind = kForget, .reader = reader};
  NurseryLetter envelope(question, nullptr, 0);
  tell(envelope.header);
}

bool ReaderNursery::tell(const msghdr& message) {
  if (::sendmsg(descriptor_, &message, MSG_NOSIGNAL) < 0) lost_ = true;
  return !lost_;
}

int ReaderNursery::ask(const msghdr& question, int& status) {
  NurseryAnswer answer;
  const std::lock_guard lock(mutex_);
  if (!tell(question)) return -1;
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
