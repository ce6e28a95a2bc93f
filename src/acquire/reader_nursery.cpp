#include "acquire/reader_nursery.hpp"

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <set>

#include "acquire/hdf5_handle.hpp"
#include "core/error.hpp"

namespace percuss {
namespace {

enum NurseryKind : int { kStart, kWait, kForget };

struct NurseryQuestion {
  int kind = 0;
  int number = 0;  // kWait: flags and process
  int flags = 0;
};

struct NurseryAnswer {
  int number = -1, status = 0;
};

constexpr std::size_t kDescriptors = 2;
constexpr std::size_t kLongestPath = PATH_MAX;

// A message with room for the descriptors that go with it.
struct NurseryLetter {
  std::array<iovec, 2> parts{};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kDescriptors * sizeof(int))> control{};
  msghdr header{};

  NurseryLetter(NurseryQuestion& question, char* path, std::size_t path_bytes) {
    parts = {iovec{&question, sizeof question}, iovec{path, path_bytes}};
    header.msg_iov = parts.data();
    header.msg_iovlen = parts.size();
  }
  NurseryLetter(const NurseryLetter&) = delete;
  NurseryLetter& operator=(const NurseryLetter&) = delete;
  void make_room() {
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  void enclose(const int* descriptors) {
    make_room();
    cmsghdr* const first = CMSG_FIRSTHDR(&header);
    first->cmsg_level = SOL_SOCKET;
    first->cmsg_type = SCM_RIGHTS;
    first->cmsg_len = CMSG_LEN(kDescriptors * sizeof(int));
    std::memcpy(CMSG_DATA(first), descriptors, kDescriptors * sizeof(int));
  }
  bool enclosed(std::array<int, kDescriptors>& descriptors) {
    const cmsghdr* const first = CMSG_FIRSTHDR(&header);
    if (first == nullptr || first->cmsg_len != CMSG_LEN(kDescriptors * sizeof(int))) return false;
    std::memcpy(descriptors.data(), CMSG_DATA(first), kDescriptors * sizeof(int));
    return true;
  }
};

int read_for(const ReaderNursery::Open& open, const std::string& path, int descriptor, int memory) {
  struct stat status {};
  const std::uint64_t bytes = ::stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  void* const shared = ::mmap(nullptr, kSharedNumbers * sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
  if (shared == MAP_FAILED) return 1;
  return serve_confined(descriptor, static_cast<double*>(shared), bytes, [&] { return open(path); });
}

// The nursery's side. Readers that nobody asks about any more are buried when there is time: to wait for the end of one
// would keep everybody else waiting.
class Readers {
 public:
  Readers(int own, const ReaderNursery::Open& open) : own_(own), open_(open) {}

  NurseryAnswer answer(const NurseryQuestion& question, const std::string& path,
                       const std::array<int, kDescriptors>& descriptors) {
    bury();
    if (question.kind == kWait) return wait(question.number, question.flags);
    if (question.kind == kForget) {
      ::kill(question.number, SIGKILL);  // it is not buried yet, so that the number is its own
      forgotten_.insert(question.number);
      return {.number = question.number};
    }
    const int process = ::fork();
    if (process != 0) return {.number = process};
    ::close(own_);
    ::_exit(read_for(open_, path, descriptors[0], descriptors[1]));
  }

 private:
  static NurseryAnswer wait(int process, int flags) {
    NurseryAnswer answer;
    answer.number = ::waitpid(process, &answer.status, flags);
    return answer;
  }
  void bury() {
    std::erase_if(forgotten_, [](int process) { return wait(process, WNOHANG).number != 0; });
  }

  int own_;
  const ReaderNursery::Open& open_;
  std::set<int> forgotten_;
};

// Until nobody asks any more.
void answer_all(int own, const ReaderNursery::Open& open) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);  // its parent's affair
  hdf5::start_library();                                                            // once for all readers
  Readers readers(own, open);
  std::array<char, kLongestPath> path{};
  while (true) {
    NurseryQuestion question;
    NurseryLetter envelope(question, path.data(), path.size());
    envelope.make_room();
    const ssize_t got = ::recvmsg(own, &envelope.header, MSG_CMSG_CLOEXEC);
    if (got < 0 && errno == EINTR) continue;
    if (got < static_cast<ssize_t>(sizeof question)) return;
    std::array<int, kDescriptors> descriptors{-1, -1};
    const bool enclosed = envelope.enclosed(descriptors);
    const std::string name(path.data(), static_cast<std::size_t>(got) - sizeof question);
    const NurseryAnswer answer = readers.answer(question, name, descriptors);
    for (const int one : descriptors) {
      if (enclosed) ::close(one);
    }
    if (::send(own, &answer, sizeof answer, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof answer)) return;
  }
}

}  // namespace

ReaderNursery::ReaderNursery(const Open& open) {
  std::array<int, 2> ends{};
  const bool paired = ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0;
  process_ = paired ? ::fork() : -1;
  if (process_ == 0) {
    ::close(ends[0]);
    try {
      answer_all(ends[1], open);
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
  NurseryQuestion question{.kind = kStart};
  NurseryLetter envelope(question, name.data(), name.size());
  const std::array<int, kDescriptors> descriptors{descriptor, memory};
  envelope.enclose(descriptors.data());
  int status = 0;
  return ask(envelope.header, status);
}

int ReaderNursery::wait(int process, int& status, int flags) {
  NurseryQuestion question{.kind = kWait, .number = process, .flags = flags};
  NurseryLetter envelope(question, nullptr, 0);
  return ask(envelope.header, status);
}

void ReaderNursery::forget(int process) {
  NurseryQuestion question{.kind = kForget, .number = process};
  NurseryLetter envelope(question, nullptr, 0);
  int status = 0;
  ask(envelope.header, status);
}

int ReaderNursery::ask(const msghdr& question, int& status) {
  NurseryAnswer answer;
  const std::lock_guard lock(mutex_);
  ssize_t got = ::sendmsg(descriptor_, &question, MSG_NOSIGNAL);
  while (got >= 0) {
    got = ::recv(descriptor_, &answer, sizeof answer, 0);
    if (got >= 0 || errno != EINTR) break;
    got = 0;
  }
  lost_ = got != static_cast<ssize_t>(sizeof answer);
  if (lost_) return -1;
  status = answer.status;
  return answer.number;
}

}  // namespace percuss
