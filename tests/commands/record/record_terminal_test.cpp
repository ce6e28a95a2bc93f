#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/scratch_folder.hpp"
#include "support/terminal_process.hpp"

// percuss record on a terminal.
namespace percuss::record_terminal_test {

using testing::HasSubstr;

/// percuss record -o t.h5 with a simulated device, on a pseudo-terminal.
class Terminal : public test::TerminalProcess {
 public:
  explicit Terminal(const std::string& device, const std::vector<std::string>& more = {})
      : Terminal(std::make_unique<test::ScratchFolder>(), device, more) {}
  std::string file(const std::string& name) const { return folder_->file(name); }
  std::size_t blows() const { return acquire::open_hdf5(file("t.h5"), {}).rows.size(); }

 private:
  Terminal(std::unique_ptr<test::ScratchFolder> folder, const std::string& device, const std::vector<std::string>& more)
      : TerminalProcess(words_for(device, more), {.folder = folder->path(), .columns = 200}),
        folder_(std::move(folder)) {}
  static std::vector<std::string> words_for(const std::string& device, const std::vector<std::string>& more) {
    std::vector<std::string> words{"record", "-o", "t.h5", "--device", device};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::unique_ptr<test::ScratchFolder> folder_;
};

TEST(RecordTerminal, ShowsBlowsModesAndAPrompt) {
  Terminal terminal("sim:aluminium-bat,double=2,speed=8");
  EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
  EXPECT_TRUE(terminal.shows("rejected: two contacts"));
  EXPECT_TRUE(terminal.shows("strike: blow 2 of 5"));
  EXPECT_FALSE(terminal.has_echo_and_lines());
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.has_echo_and_lines());
  EXPECT_THAT(terminal.screen(), HasSubstr("modes in Hz: "));
  EXPECT_EQ(std::count(terminal.screen().begin(), terminal.screen().end(), '\a'), 6);
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
  terminal.type("g1000000000\n");
  EXPECT_TRUE(terminal.shows("there is no point 1000000000;")) << "the largest point number has ten digits";
  terminal.type("g4294967296\n");
  EXPECT_TRUE(terminal.shows("there is no point 4294967296;")) << "2^32 is not point 0";
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.has_echo_and_lines());
  EXPECT_GE(terminal.blows(), 2U);
}

TEST(RecordTerminal, IsRestoredAfterSignals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Terminal terminal("sim:aluminium-bat,speed=4");
    EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
    terminal.send(signal);
    EXPECT_EQ(terminal.wait(), 6) << signal;
    EXPECT_TRUE(terminal.has_echo_and_lines()) << signal;
    EXPECT_GE(terminal.blows(), 1U);
    EXPECT_TRUE(std::filesystem::exists(terminal.file("t.h5.journal")));
    EXPECT_THAT(terminal.screen(), HasSubstr("percuss record --resume t.h5"));
  }
  Terminal terminal("sim:aluminium-bat,speed=4");
  EXPECT_TRUE(terminal.shows("Blow 1 of 5: accepted"));
  terminal.send(SIGQUIT);  // ends it at once; the journal stays
  EXPECT_EQ(terminal.wait(), -1);
  EXPECT_TRUE(terminal.has_echo_and_lines());
  EXPECT_TRUE(std::filesystem::exists(terminal.file("t.h5.journal")));
}

// SIGTSTP is the signal of Ctrl-Z. Here percuss leads the session of its terminal, so SIGTSTP runs its handlers but
// does not stop it. SIGSTOP and SIGCONT then stop and continue it.
TEST(RecordTerminal, GoesOnAfterAStop) {
  Terminal terminal("sim:aluminium-bat,hits=40,speed=4", {"--hits", "30"});
  EXPECT_TRUE(terminal.shows("Blow 1 of 30: accepted"));
  terminal.send(SIGTSTP);
  EXPECT_TRUE(terminal.shows("Blow 2 of 30: accepted"));
  EXPECT_FALSE(terminal.has_echo_and_lines());
  terminal.send(SIGSTOP);
  terminal.send(SIGCONT);
  EXPECT_TRUE(terminal.shows("Blow 3 of 30: accepted"));
  EXPECT_FALSE(terminal.has_echo_and_lines());
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.has_echo_and_lines());
}

// Nobody reads the terminal: its buffer is full after some lines.
TEST(RecordTerminal, NeverHoldsUpTheRecording) {
  Terminal terminal("sim:aluminium-bat,hits=30,every=1,speed=8", {"--hits", "30"});
  EXPECT_EQ(terminal.wait(false), 0);
  EXPECT_EQ(terminal.blows(), 30U);
}

}  // namespace percuss::record_terminal_test
