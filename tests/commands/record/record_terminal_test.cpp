#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/scratch_folder.hpp"

// percuss record on a terminal.
namespace percuss::record_terminal_test {
namespace {

using Clock = std::chrono::steady_clock;
using testing::HasSubstr;

constexpr std::chrono::seconds kPatience{100};  // sanitizers are slow

/// percuss record -o t.h5 with a simulated device, on a pseudo-terminal.
class Terminal {
 public:
  explicit Terminal(const std::string& device, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"percuss", "record", "-o", "t.h5", "--device", device};
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    winsize size{.ws_row = 40, .ws_col = 200, .ws_xpixel = 0, .ws_ypixel = 0};
    child_ = ::forkpty(&master_, nullptr, nullptr, &size);
    if (child_ == 0) {
      if (::chdir(folder.path().c_str()) == 0) ::execv(PERCUSS_EXECUTABLE, arguments.data());
      ::_exit(99);
    }
    ::fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() {
    if (child_ > 0) {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
    }
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(const std::string& keys) const { static_cast<void>(!::write(master_, keys.data(), keys.size())); }
  void send(int signal) const { ::kill(child_, signal); }
  /// Reads until the screen has shown this text. False after a long time.
  bool shows(const std::string& text) {
    const auto deadline = Clock::now() + kPatience;
    while (screen.find(text, seen_) == std::string::npos) {
      if (Clock::now() > deadline) return false;
      read_some();
    }
    seen_ = screen.find(text, seen_) + text.size();
    return true;
  }
  /// The exit code; −1 for a signal or after a long time. `read`: takes what is written meanwhile.
  int wait(bool read = true) {
    const auto deadline = Clock::now() + kPatience;
    int status = 0;
    while (::waitpid(child_, &status, WNOHANG) == 0) {
      if (Clock::now() > deadline) return -1;
      if (read) read_some();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    child_ = -1;
    if (read) read_rest();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// The terminal shows what is typed, and delivers lines.
  bool is_ordinary() const {
    termios mode{};
    return ::tcgetattr(master_, &mode) == 0 && (mode.c_lflag & ICANON) != 0 && (mode.c_lflag & ECHO) != 0;
  }
  std::size_t blows() const { return acquire::open_hdf5(folder.file("t.h5"), {}).rows.size(); }

  test::ScratchFolder folder;
  std::string screen;

 private:
  void read_rest() {
    for (std::size_t before = screen.size() + 1; before != screen.size();) {
      before = screen.size();
      read_some();
    }
  }
  void read_some() {
    pollfd file{.fd = master_, .events = POLLIN, .revents = 0};
    ::poll(&file, 1, 20);
    std::array<char, 4096> bytes{};
    const auto got = ::read(master_, bytes.data(), bytes.size());
    if (got > 0) screen.append(bytes.data(), static_cast<std::size_t>(got));
  }

  int master_ = -1;
  pid_t child_ = -1;
  std::size_t seen_ = 0;
};

TEST(RecordTerminal, ShowsBlowsModesAndAPrompt) {
  Terminal terminal("sim:aluminium-bat,double=2,speed=8");
  EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
  EXPECT_TRUE(terminal.shows("rejected: two contacts"));
  EXPECT_TRUE(terminal.shows("strike: blow 2 of 5"));
  EXPECT_FALSE(terminal.is_ordinary());
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.is_ordinary());
  EXPECT_THAT(terminal.screen, HasSubstr("modes in Hz: "));
  EXPECT_EQ(std::count(terminal.screen.begin(), terminal.screen.end(), '\a'), 6);
}

TEST(RecordTerminal, ObeysKeys) {
  Terminal terminal("sim:aluminium-bat,hits=40,speed=4", {"--hits", "30"});
  EXPECT_TRUE(terminal.shows("Blow 2 of 30: accepted"));
  terminal.type("u");
  EXPECT_TRUE(terminal.shows("undone; next: blow 2 of 30"));
  terminal.type(" ");
  EXPECT_TRUE(terminal.shows("paused"));
  terminal.type(" ");
  EXPECT_TRUE(terminal.shows("goes on"));
  terminal.type("g9\n");
  EXPECT_TRUE(terminal.shows("there is no point 9"));
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.is_ordinary());
  EXPECT_GE(terminal.blows(), 2U);
}

TEST(RecordTerminal, IsRestoredAfterSignals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Terminal terminal("sim:aluminium-bat,speed=4");
    EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
    terminal.send(signal);
    EXPECT_EQ(terminal.wait(), 6) << signal;
    EXPECT_TRUE(terminal.is_ordinary()) << signal;
    EXPECT_GE(terminal.blows(), 1U);
    EXPECT_TRUE(std::filesystem::exists(terminal.folder.file("t.h5.journal")));
    EXPECT_THAT(terminal.screen, HasSubstr("percuss record --resume t.h5"));
  }
  Terminal terminal("sim:aluminium-bat,speed=4");
  EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
  terminal.send(SIGQUIT);  // ends it at once; the journal stays
  EXPECT_EQ(terminal.wait(), -1);
  EXPECT_TRUE(terminal.is_ordinary());
  EXPECT_TRUE(std::filesystem::exists(terminal.folder.file("t.h5.journal")));
}

// As Ctrl-Z does for a session that a shell runs: the pseudo-terminal's own session leader cannot be stopped, but goes
// through the same handlers.
TEST(RecordTerminal, GoesOnAfterAStop) {
  Terminal terminal("sim:aluminium-bat,hits=40,speed=4", {"--hits", "30"});
  EXPECT_TRUE(terminal.shows("Blow 1 of 30: accepted"));
  terminal.send(SIGTSTP);
  EXPECT_TRUE(terminal.shows("Blow 2 of 30: accepted"));
  EXPECT_FALSE(terminal.is_ordinary());
  terminal.send(SIGSTOP);
  terminal.send(SIGCONT);
  EXPECT_TRUE(terminal.shows("Blow 3 of 30: accepted"));
  EXPECT_FALSE(terminal.is_ordinary());
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.is_ordinary());
}

// Nobody reads the terminal: its buffer is full after some lines.
TEST(RecordTerminal, NeverHoldsUpTheRecording) {
  Terminal terminal("sim:aluminium-bat,hits=30,every=1,speed=8", {"--hits", "30"});
  EXPECT_EQ(terminal.wait(false), 0);
  EXPECT_EQ(terminal.blows(), 30U);
}

}  // namespace
}  // namespace percuss::record_terminal_test
