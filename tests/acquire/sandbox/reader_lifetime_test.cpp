#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <thread>

#include "acquire/sandbox/fork_server.hpp"
#include "acquire/sandbox/sandbox_process.hpp"
#include "core/error.hpp"
#include "support/confinement.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// A sandboxed reader ends with the process that started it, whatever the reader does.
namespace percuss::acquire::reader_lifetime_test {

using Number = std::atomic<int>;

SandboxService counting() {
  return {.description = "d", .read = [](std::size_t, std::size_t, std::size_t first, std::span<double> out) {
            out[0] = static_cast<double>(first);
          }};
}

class ReaderLifetime : public testing::Test {
 protected:
  ReaderLifetime() {
    void* const memory = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    reader_ = new (memory) Number(0);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);  // this process becomes the parent of orphans
  }
  ~ReaderLifetime() override {
    if (reader_->load() > 0) ::kill(reader_->load(), SIGKILL);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0);
    ::munmap(reader_, 4096);
  }
  /// Opens a file whose reader states its process id and then waits for ever.
  std::function<SandboxService(const std::string&)> waiting() {
    return [reader = reader_](const std::string&) -> SandboxService {
      reader->store(::getpid());
      while (true) reader->wait(reader->load());
    };
  }
  /// Runs `start` in a child process. Kills the child when the reader has stated its id, and expects the reader to end.
  void expect_end_of_reader_with_process(const std::function<void()>& start) {
    const pid_t process = ::fork();
    if (process == 0) {
      start();
      ::_exit(0);
    }
    for (int i = 0; i < 2000 && reader_->load() == 0; ++i) ::usleep(10'000);
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    const pid_t reader = reader_->load();
    ASSERT_GT(reader, 0);
    bool ended = false;
    for (int i = 0; i < 1000 && !ended; ++i) {
      ended = ::waitpid(reader, nullptr, WNOHANG) != 0 && ::kill(reader, 0) != 0;
      if (!ended) ::usleep(10'000);
    }
    EXPECT_TRUE(ended);
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat");
  Number* reader_ = nullptr;
};

TEST_F(ReaderLifetime, EndsWithItsParent) {
  if (!test::has_seccomp()) return;  // no reader starts: see SandboxSupport
  expect_end_of_reader_with_process([&] { const SandboxProcess process(path_, [&] { return waiting()(path_); }); });
}

TEST_F(ReaderLifetime, EndsWithAParentWhoseThreadStartedIt) {
  if (!test::has_seccomp()) return;
  expect_end_of_reader_with_process(
      [&] { std::thread([&] { const SandboxProcess process(path_, [&] { return waiting()(path_); }); }).join(); });
}

TEST_F(ReaderLifetime, EndsWithTheParentOfItsForkServer) {
  if (!test::has_seccomp()) return;
  expect_end_of_reader_with_process([&] {
    const auto fork_server = std::make_shared<ForkServer>(waiting());
    const SandboxProcess process(path_, fork_server);
  });
}

TEST_F(ReaderLifetime, OutlivesTheThreadThatStartedIt) {
  if (!test::has_seccomp()) return;
  std::unique_ptr<SandboxProcess> process;
  std::thread([&] { process = std::make_unique<SandboxProcess>(path_, counting); }).join();
  ::usleep(50'000);
  std::array<double, 1> out{};
  process->read(0, 0, 7, out);
  EXPECT_EQ(out[0], 7);
}

// Two processes that share a socket would receive each other's numbers.
TEST_F(ReaderLifetime, ServesOnlyTheProcessThatStartedIt) {
  if (!test::has_seccomp()) return;
  auto process = std::make_unique<SandboxProcess>(path_, counting);
  const pid_t other = ::fork();
  if (other == 0) {
    const std::string message = test::input_error_of([&] {
      std::array<double, 1> out{};
      process->read(0, 0, 7, out);
    });
    process.reset();
    ::_exit(message.find("opened by another process") == std::string::npos ? 1 : 0);
  }
  int status = -1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  std::array<double, 1> out{};
  process->read(0, 0, 7, out);
  EXPECT_EQ(out[0], 7);
}

}  // namespace percuss::acquire::reader_lifetime_test
