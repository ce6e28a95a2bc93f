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

namespace percuss {
namespace {

int read_for(const ReaderNursery::Open& open, const std::string& path, int descriptor, int memory) {
  struct stat status {};
  const std::uint64_t bytes = ::stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  void* const shared = ::mmap(nullptr, kSharedNumbers * sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
  if (shared == MAP_FAILED) return 1;
  return serve_confined(descriptor, static_cast<double*>(shared), bytes, [&] { return open(path); });
}

// Whoever asks for a reader sleeps until that one answers, so that its processor is free; the kernel often places a
// reader where another thread is at work instead. While this lives, this process and what it forks are there.
class Placed {
 public:
  explicit Placed(int processor) {
    if (processor < 0 || processor >= CPU_SETSIZE || ::sched_getaffinity(0, sizeof allowed_, &allowed_) != 0) return;
    cpu_set_t there;
    CPU_ZERO(&there);
    CPU_SET(static_cast<std::size_t>(processor), &there);
    moved_ = ::sched_setaffinity(0, sizeof there, &there) == 0;
  }
  ~Placed() {
    if (moved_) ::sched_setaffinity(0, sizeof allowed_, &allowed_);
  }
  Placed(const Placed&) = delete;
  Placed& operator=(const Placed&) = delete;

 private:
  cpu_set_t allowed_{};
  bool moved_ = false;
};

// The nursery's side. Readers that nobody asks about any more are buried when there is time: to wait for the end of one
// would keep everybody else waiting.
class Readers {
 public:
  Readers(int own, const ReaderNursery::Open& open) : own_(own), open_(open) {}

  void start(const NurseryLetter& letter) {
    bury();
    const int process = fork_at(letter.question.processor);
    if (process > 0) processes_[letter.question.reader] = process;
    if (process != 0) return;
    ::close(own_);
    ::_exit(read_for(open_, letter.path, letter.descriptors[0], letter.descriptors[1]));
  }

  NurseryAnswer ended(int reader, int flags) {
    NurseryAnswer answer;
    const auto found = processes_.find(reader);
    if (found == processes_.end()) return answer;
    const int process = ::waitpid(found->second, &answer.status, flags);
    if (process == 0) answer.reader = 0;
    if (process <= 0) return answer;
    processes_.erase(found);
    answer.reader = reader;
    return answer;
  }

  NurseryAnswer end(int reader) {
    kill(reader);
    return ended(reader, 0);
  }

  void forget(int reader) {
    kill(reader);
    forgotten_.insert(reader);
  }

 private:
  static int fork_at(int processor) {
    const Placed there(processor);
    return ::fork();
  }
  // It is not buried yet, so that the process number is its own.
  void kill(int reader) {
    const auto found = processes_.find(reader);
    if (found != processes_.end()) ::kill(found->second, SIGKILL);
  }
  void bury() {
    std::erase_if(forgotten_, [&](int reader) { return ended(reader, WNOHANG).reader != 0; });
  }

  int own_;
  const ReaderNursery::Open& open_;
  std::map<int, int> processes_;  // of readers that are not buried
  std::set<int> forgotten_;
};

}  // namespace

void serve_nursery(int own, const ReaderNursery::Open& open) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);  // its parent's affair
  hdf5::start_library();                                                            // once for all readers
  Readers readers(own, open);
  while (const auto letter = receive_letter(own)) {
    const NurseryQuestion& question = letter->question;
    const bool enclosed = letter->descriptors.front() >= 0;
    if (question.kind == kStart && enclosed) readers.start(*letter);
    for (const int one : letter->descriptors) {
      if (enclosed) ::close(one);
    }
    if (question.kind == kForget) readers.forget(question.reader);
    if (question.kind != kEnded && question.kind != kEnd) continue;
    const NurseryAnswer answer =
        question.kind == kEnd ? readers.end(question.reader) : readers.ended(question.reader, WNOHANG);
    if (::send(own, &answer, sizeof answer, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof answer)) return;
  }
}

}  // namespace percuss
