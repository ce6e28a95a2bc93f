#include "acquire/sandbox/sandbox_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <new>
#include <utility>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/sandbox/fork_server.hpp"
#include "acquire/sandbox/sandbox_limits.hpp"
#include "acquire/sandbox/sandbox_protocol.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr int kNoMemoryExit = 11, kFailedExit = 12;
constexpr const char* kDamaged = "is the file damaged? Save it again";
constexpr const char* kDamagedOrTrusted = "is the file damaged? If not, trust the input";

// Holds the lock across the fork: otherwise the child could inherit the library while another thread changes it.
int fork_with_libraries_idle() {
  const hdf5::ExclusiveAccess access;
  return ::fork();
}

void serve(int descriptor, double* shared, std::uint64_t file_bytes, const std::function<SandboxService()>& open) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  std::signal(SIGPIPE, SIG_IGN);
  enter_sandbox(descriptor, file_bytes);
  SandboxService service;
  const bool connected = run_and_send_outcome(descriptor, [&] {
    service = open();
    return service.description;
  });
  SandboxRequest request;
  while (connected && service.read && receive_bytes(descriptor, &request, sizeof request)) {
    const auto out = std::span(shared, std::min<std::size_t>(request.count, kSharedNumbers));
    const bool sent = run_and_send_outcome(descriptor, [&] {
      service.read(request.row, request.signal, request.first, out);
      return std::string();
    });
    if (!sent) return;
  }
}

}  // namespace

// No exception may leave the child: the callers are the parent's code.
int serve_in_sandbox(int descriptor, double* shared, std::uint64_t file_bytes,
                     const std::function<SandboxService()>& open) {
  try {
    serve(descriptor, shared, file_bytes, open);
    return 0;
  } catch (const std::bad_alloc&) {
    return kNoMemoryExit;
  } catch (...) {
    return kFailedExit;
  }
}

SandboxProcess::SandboxProcess(std::string path, const std::function<SandboxService()>& open,
                               std::optional<unsigned> timeout_s)
    : path_(std::move(path)), timeout_s_(timeout_s.value_or(0)) {
  begin([&](int descriptor, int /*memory*/) {
    const int process = fork_with_libraries_idle();
    if (process != 0) return process;
    ::close(descriptor_);
    ::_exit(serve_in_sandbox(descriptor, shared_, file_bytes_, open));
  });
}

SandboxProcess::SandboxProcess(std::string path, std::shared_ptr<ForkServer> fork_server)
    : path_(std::move(path)), fork_server_(std::move(fork_server)) {
  begin([&](int descriptor, int memory) { return fork_server_->start(path_, descriptor, memory); });
}

void SandboxProcess::begin(const std::function<int(int descriptor, int memory)>& start) {
  constexpr unsigned kWallPerCpuTime = 3;  // the child waits for the disk and for other programs as well
  constexpr std::size_t kSharedBytes = kSharedNumbers * sizeof(double);
  struct stat status {};
  if (::stat(path_.c_str(), &status) == 0) file_bytes_ = static_cast<std::uint64_t>(status.st_size);
  if (timeout_s_ == 0) timeout_s_ = kWallPerCpuTime * processor_limit_s(file_bytes_);
  std::array<int, 2> ends{-1, -1};
  const int memory = ::memfd_create("percuss", MFD_CLOEXEC);
  const bool sized = memory >= 0 && ::ftruncate(memory, kSharedBytes) == 0;
  void* const shared =
      sized ? ::mmap(nullptr, kSharedBytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0) : MAP_FAILED;
  const bool paired = shared != MAP_FAILED && ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  shared_ = static_cast<double*>(shared);
  descriptor_ = ends[0];
  if (paired) child_ = start(ends[1], memory);
  if (memory >= 0) ::close(memory);
  if (paired) ::close(ends[1]);
  try {
    if (child_ < 0) report_no_process();
    receive_outcome(description_);
  } catch (...) {
    if (paired) ::close(descriptor_);
    kill_child();
    if (shared != MAP_FAILED) ::munmap(shared_, kSharedBytes);
    throw;
  }
}

int SandboxProcess::ended(int& status) const {
  return fork_server_ != nullptr ? fork_server_->ended(child_, status) : ::waitpid(child_, &status, WNOHANG);
}

SandboxProcess::~SandboxProcess() {
  ::close(descriptor_);
  if (fork_server_ != nullptr && child_ > 0) fork_server_->release(std::exchange(child_, -1));
  kill_child();
  ::munmap(shared_, kSharedNumbers * sizeof(double));
}

// A damaged file can make the child wait for ever, hence the timeout. It counts only seconds in which this process
// runs: the child must not fail because its parent was stopped.
void SandboxProcess::receive(void* to, std::size_t bytes) {
  pollfd readable{descriptor_, POLLIN, 0};
  for (unsigned s = 0; ::poll(&readable, 1, 1000) <= 0; ++s) {
    if (s + 1 < timeout_s_) continue;
    kill_child();
    report_timeout();
  }
  if (!receive_bytes(descriptor_, to, bytes)) report_crash();
}

int SandboxProcess::kill_child() {
  int status = 0;
  if (child_ <= 0) return status;
  if (fork_server_ != nullptr) {
    fork_server_->kill_and_wait(child_, status);
  } else {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, &status, 0);
  }
  child_ = -1;
  return status;
}

void SandboxProcess::receive_outcome(std::string& payload) {
  std::array<std::uint64_t, 2> head{};
  receive(head.data(), sizeof head);
  const std::uint64_t limit = (std::uint64_t{64} << 20U) + 64 * file_bytes_;
  if (head[1] > limit) report_contradiction();
  std::string bytes;
  constexpr std::size_t kStep = std::size_t{1} << 24U;  // memory grows with the bytes received, not the size claimed
  while (bytes.size() < head[1]) {
    const std::size_t received = bytes.size(), next = std::min<std::size_t>(kStep, head[1] - received);
    bytes.resize(received + next);
    receive(bytes.data() + received, next);
  }
  switch (static_cast<SandboxOutcome>(head[0])) {
    case SandboxOutcome::good:
      payload = std::move(bytes);
      return;
    case SandboxOutcome::input_error:
    case SandboxOutcome::machine_fault:
    case SandboxOutcome::ambiguous_columns:
      rethrow(static_cast<SandboxOutcome>(head[0]), bytes);
    case SandboxOutcome::no_memory:
      report_no_memory();
    case SandboxOutcome::other_error:
      break;
  }
  throw InputError("the file cannot be read: " + one_line(bytes, 200), path_, kDamaged);
}

void SandboxProcess::rethrow(SandboxOutcome outcome, const std::string& payload) const {
  try {
    if (outcome == SandboxOutcome::input_error) throw deserialize_input_error(payload);
    if (outcome == SandboxOutcome::machine_fault) throw deserialize_machine_fault(payload);
    throw deserialize_ambiguous_columns(payload);
  } catch (const std::out_of_range&) {
    report_contradiction();
  }
}

void SandboxProcess::report_no_process() const {
  throw MachineFault("cannot start a process that reads the file", path_, "close other programs, or trust the input",
                   {"trust_input"});
}

void SandboxProcess::report_timeout() const {
  throw InputError("reading takes longer than any file of this size should", path_, kDamagedOrTrusted, {"trust_input"});
}

void SandboxProcess::report_no_memory() const {
  throw InputError("reading needs more than 2 GiB of memory and more than four times the file's size", path_,
                   kDamagedOrTrusted, {"trust_input"});
}

void SandboxProcess::report_crash() {
  int status = 0;
  int reaped = 0;
  for (int i = 0; i < 100 && reaped != child_; ++i) {  // a child that stopped answering may need time to end
    reaped = ended(status);
    if (reaped < 0 && fork_server_ != nullptr) {
      child_ = -1;
      report_no_process();
    }
    if (reaped != child_) ::usleep(10'000);
  }
  if (reaped != child_) status = kill_child();
  child_ = -1;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL) report_timeout();
  if (signal == 0 && WEXITSTATUS(status) == kNoMemoryExit) report_no_memory();
  const std::string how =
      signal != 0 ? fmt::format("signal {}", signal) : fmt::format("exit code {}", WEXITSTATUS(status));
  throw InputError("the file crashes the library that reads it (" + how + ")", path_,
                   "it is damaged, or memory ran out: save it again, or export another format");
}

void SandboxProcess::report_contradiction() const {
  throw InputError("the contents of the file contradict each other", path_, kDamaged);
}

void SandboxProcess::read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
  const std::lock_guard lock(mutex_);
  for (std::size_t done = 0; done < out.size();) {
    const std::size_t count = std::min(kSharedNumbers, out.size() - done);
    if (child_ < 0) throw InputError("the process that reads the file has ended", path_, kDamaged);
    const SandboxRequest request{row, signal, first + done, count};
    if (::send(descriptor_, &request, sizeof request, MSG_NOSIGNAL) != static_cast<ssize_t>(sizeof request))
      report_crash();
    std::string no_payload;
    receive_outcome(no_payload);
    std::copy_n(shared_, count, out.begin() + static_cast<std::ptrdiff_t>(done));
    done += count;
  }
}

}  // namespace percuss::acquire
