#include "acquire/sandbox/sandbox_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/record/sample_limits.hpp"
#include "acquire/sandbox/child_process.hpp"
#include "acquire/sandbox/fork_server.hpp"
#include "acquire/sandbox/readers_memory.hpp"
#include "acquire/sandbox/sandbox_limits.hpp"
#include "acquire/sandbox/sandbox_protocol.hpp"
#include "acquire/sandbox/serve_in_sandbox.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr const char* kDamaged = "is the file damaged? Save it again";
constexpr const char* kDamagedOrTrusted = "is the file damaged? If not, trust the input";

// Holds the lock across the fork: otherwise the child could inherit the library while another thread changes it.
int fork_with_libraries_idle() {
  const hdf5::ExclusiveAccess access;
  return fork_child();
}

}  // namespace

SandboxProcess::SandboxProcess(std::string path, const std::function<SandboxService()>& open,
                               std::optional<unsigned> timeout_s)
    : path_(std::move(path)), timeout_s_(timeout_s.value_or(0)) {
  begin([&](const ReaderDescriptors& descriptors) {
    const int process = fork_with_libraries_idle();
    if (process != 0) return process;
    ::_exit(serve_in_sandbox(descriptors, path_, open));
  });
}

SandboxProcess::SandboxProcess(std::string path, std::shared_ptr<ForkServer> fork_server)
    : path_(std::move(path)), fork_server_(std::move(fork_server)) {
  begin([&](const ReaderDescriptors& descriptors) { return fork_server_->start(path_, descriptors); });
}

bool SandboxProcess::create_descriptors(ReaderDescriptors& of_child) {
  std::array<int, 2> ends{-1, -1};
  of_child.memory = ::memfd_create("percuss", MFD_CLOEXEC);
  if (of_child.memory < 0 || ::ftruncate(of_child.memory, kSharedNumbers_bytes) != 0) return false;
  shared_ = map_shared_numbers(of_child.memory);
  // Other children do not inherit this mapping: a reader must not change the samples of another reader.
  if (shared_ == nullptr || ::madvise(shared_, kSharedNumbers_bytes, MADV_DONTFORK) != 0) return false;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
  of_child.parent_pipe = ends[0];
  pipe_ = ends[1];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
  descriptor_ = ends[0];
  of_child.socket = ends[1];
  return true;
}

void SandboxProcess::begin(const std::function<int(const ReaderDescriptors&)>& start) {
  owner_ = ::getpid();
  file_bytes_ = regular_file_bytes(path_);
  constexpr unsigned kWallPerCpuTime = 3, kMinTimeout_s = 60;  // the reader also waits for the disk and other programs
  if (timeout_s_ == 0) timeout_s_ = std::max(kMinTimeout_s, kWallPerCpuTime * processor_limit_s(file_bytes_));
  ReaderDescriptors of_child;
  if (create_descriptors(of_child)) child_ = start(of_child);
  for (const int descriptor : {of_child.socket, of_child.memory, of_child.parent_pipe}) {
    if (descriptor >= 0) ::close(descriptor);
  }
  try {
    if (child_ < 0) report_no_process();
    receive_outcome(description_);
  } catch (...) {
    readers_memory().remove(this);
    close_descriptors();
    kill_child();
    throw;
  }
}

void SandboxProcess::close_descriptors() {
  for (const int descriptor : {descriptor_, pipe_})
    if (descriptor >= 0) ::close(descriptor);
  if (shared_ != nullptr) ::munmap(shared_, kSharedNumbers_bytes);
}

bool SandboxProcess::is_owner() const { return owner_ == ::getpid(); }

int SandboxProcess::ended(int& status) const {
  return fork_server_ != nullptr ? fork_server_->ended(child_, status) : ::waitpid(child_, &status, WNOHANG);
}

SandboxProcess::~SandboxProcess() {
  readers_memory().remove(this);
  if (!is_owner()) {  // the reader serves the process that started it
    shared_ = nullptr;
    child_ = -1;
  }
  if (fork_server_ != nullptr && child_ > 0) fork_server_->release(std::exchange(child_, -1));
  kill_child();
  close_descriptors();
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
  SandboxOutcomeHead head;
  receive(&head, sizeof head);
  if (head.payload_bytes > claim_limit_bytes(file_bytes_)) report_contradiction();
  // A compromised reader can state any number, but cannot take more memory than its own limit.
  const std::uint64_t taken_bytes = std::min(head.memory_bytes, memory_limit_bytes(file_bytes_));
  if (!readers_memory().store(this, file_bytes_, taken_bytes)) report_no_memory_for_all();
  std::string bytes;
  constexpr std::size_t kStep = std::size_t{1} << 24U;  // memory grows with the bytes received, not the size claimed
  while (bytes.size() < head.payload_bytes) {
    const std::size_t received = bytes.size(), next = std::min<std::size_t>(kStep, head.payload_bytes - received);
    bytes.resize(received + next);
    receive(bytes.data() + received, next);
  }
  switch (head.outcome) {
    case SandboxOutcome::good:
      payload = std::move(bytes);
      return;
    case SandboxOutcome::input_error:
    case SandboxOutcome::machine_fault:
    case SandboxOutcome::ambiguous_columns:
      rethrow(head.outcome, bytes);
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
  throw InputError(fmt::format("reading takes longer than {} s, the limit for a file of this size", timeout_s_), path_,
                   kDamagedOrTrusted, {"trust_input"});
}

void SandboxProcess::report_processor_time() const {
  throw InputError(fmt::format("reading takes more than {} s of processor time, the limit for a file of this size",
                               processor_limit_s(file_bytes_)),
                   path_, kDamagedOrTrusted, {"trust_input"});
}

void SandboxProcess::report_no_memory() const {
  throw InputError(fmt::format("reading needs more memory than {} MiB, the limit for a file of this size",
                               memory_limit_bytes(file_bytes_) >> 20U),
                   path_, kDamagedOrTrusted, {"trust_input"});
}

void SandboxProcess::report_no_memory_for_all() const {
  throw InputError(fmt::format("all files together need more memory than {} MiB, the limit for files of their sizes",
                               readers_memory().limit_bytes() >> 20U),
                   path_, "open fewer files, or trust the input", {"trust_input"});
}

void SandboxProcess::report_crash() {
  int status = 0;
  int reaped = 0;
  for (int i = 0; i < 100 && reaped != child_; ++i) {  // a child that stopped answering may need time to end
    reaped = ended(status);
    if (reaped < 0 && fork_server_ != nullptr) {
      child_ = -1;
      report_no_process();  // the fork server could not start one, or has ended
    }
    if (reaped != child_) ::usleep(10'000);
  }
  if (reaped != child_) status = kill_child();
  child_ = -1;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGPROF || signal == SIGXCPU) report_processor_time();
  if (signal == 0 && WEXITSTATUS(status) == kNoMemoryExitCode) report_no_memory();
  const std::string how =
      signal != 0 ? fmt::format("signal {}", signal) : fmt::format("exit code {}", WEXITSTATUS(status));
  throw InputError("the file crashes the library that reads it (" + how + ")", path_,
                   "it is damaged, or memory ran out: save it again, or export another format");
}

void SandboxProcess::report_contradiction() const {
  throw InputError("the contents of the file contradict each other", path_, kDamaged);
}

void SandboxProcess::read(std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
  if (!is_owner())
    throw InputError("the file was opened by another process", path_, "open it in the process that reads it");
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
