#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/live/record_bench.hpp"
#include "support/percuss_process.hpp"

// The files of percuss record: the output, the report and the journal.
namespace percuss::record_files_test {

namespace fs = std::filesystem;
using Bench = test::RecordBench;
using testing::HasSubstr;

TEST(RecordFiles, NamesAFailedReportAndPrintsTheDocument) {
  const Bench bench;
  const std::string record =
      "percuss record -o t.h5 --device sim:aluminium-bat,speed=4 --band 60:3200 --json --report r.html";
  EXPECT_EQ(bench.run_and_act(record, Bench::kHasBegun, "echo mine >r.html"), 3);
  EXPECT_EQ(bench.bytes("r.html"), "mine\n");
  EXPECT_THAT(bench.bytes("err"), HasSubstr("file exists (r.html)"));
  EXPECT_THAT(bench.bytes("err"), HasSubstr("to write it: percuss analyze t.h5 -o r.html --band 60:3200"));
  EXPECT_EQ(bench.bytes("out"), bench.run({"analyze", "t.h5", "--band", "60:3200", "--json"}).out);
  EXPECT_EQ(bench.run_and_act(record + " --force", Bench::kHasBegun, "echo mine >r.html"), 0);
  EXPECT_NE(bench.bytes("r.html"), "mine\n");
  const auto none = bench.record("sim:aluminium-bat,first=2,end=8,silent=2", {"--force", "--report", "r.html"});
  EXPECT_EQ(none.code, 4);
  EXPECT_THAT(none.err, HasSubstr("no report is written"));
}

// Unusable paths are refused before a blow is struck, not after the last one.
TEST(RecordFiles, ChecksItsFilesBeforeItBegins) {
  const Bench bench;
  const auto refusal = [&](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> words{"record", "--device", "sim:aluminium-bat", "--fast", "-o", output};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = bench.run(words);
    EXPECT_EQ(outcome.code, 3) << output << outcome.out;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(bench.has(output + ".journal")) << output;
    return outcome.err;
  };
  fs::create_directory(bench.folder.file("folder.h5"));
  fs::create_directory(bench.folder.file("folder.html"));
  fs::create_symlink("none.h5", bench.folder.file("link.h5"));
  EXPECT_THAT(refusal("folder.h5", {}), HasSubstr("is a folder (folder.h5); name a file"));
  EXPECT_THAT(refusal("folder.h5", {"--force"}), HasSubstr("is a folder (folder.h5); name a file"));
  EXPECT_THAT(refusal("link.h5", {}), HasSubstr("is a link to a file that does not exist (link.h5)"));
  EXPECT_THAT(refusal("none/t.h5", {}), HasSubstr("create the folder first"));
  EXPECT_THAT(refusal("t.h5", {"--report", "folder.html", "--force"}), HasSubstr("is a folder (folder.html)"));
  EXPECT_THAT(refusal("t.h5", {"--report", "none/r.html"}), HasSubstr("create the folder first"));
  EXPECT_THAT(refusal("t.h5", {"--report", std::string(300, 'r') + ".html"}), HasSubstr("File name too long"));
  // --force, which the message about the link names, replaces the link.
  EXPECT_EQ(bench.run({"record", "--device", "sim:aluminium-bat", "--fast", "-o", "link.h5", "--force"}).code, 0);
  EXPECT_TRUE(bench.has("link.h5"));
}

TEST(RecordFiles, ChecksThatTheReportsFolderCanBeWritten) {
  const Bench bench;
  fs::create_directory(bench.folder.file("closed"));
  fs::permissions(bench.folder.file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  const auto outcome = test::run_percuss(
      {"record", "--device", "sim:aluminium-bat", "--fast", "-o", "t.h5", "--report", "closed/r.html"},
      {.folder = bench.folder.path(), .ordinary_user = true});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("Permission denied (closed/r.html)"));
  EXPECT_FALSE(bench.has("t.h5"));
  fs::permissions(bench.folder.file("closed"), fs::perms::owner_all);
}

TEST(RecordFiles, SaysHowToSaveBlowsThatCannotBeWritten) {
  const std::string record = "percuss record -o t.h5 --device sim:aluminium-bat,speed=4";
  for (const char* in_the_way : {"mkdir t.h5", "echo notes >t.h5"}) {
    const Bench bench;
    EXPECT_EQ(bench.run_and_act(record, Bench::kHasBegun, in_the_way), 3);
    EXPECT_THAT(bench.bytes("err"), HasSubstr("the blows are safe in the journal: move this elsewhere, then type "
                                              "percuss record --resume t.h5"));
    fs::rename(bench.folder.file("t.h5"), bench.folder.file("elsewhere"));
    EXPECT_EQ(bench.shell("percuss record --resume t.h5"), 0);
    EXPECT_EQ(bench.marks().size(), 5U);
    EXPECT_FALSE(bench.has("t.h5.journal"));
  }
}

// No file may grow beyond a limit, as on a full disk: the rows wait in memory, but the record has no room at the end.
TEST(RecordFiles, SayHowToGoOnWhenTheDiskIsFull) {
  const Bench bench;
  constexpr std::size_t kMaxFile_bytes = 200'000;  // less than a row: 9600 samples of 3 channels
  const auto full = test::run_percuss({"record", "-o", "t.h5", "--device", "sim:aluminium-bat", "--fast"},
                                      {.folder = bench.folder.path(), .limits = {{RLIMIT_FSIZE, kMaxFile_bytes}}});
  EXPECT_EQ(full.code, 3);
  EXPECT_THAT(full.err, HasSubstr("percuss record --resume t.h5"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5"}).code, 0);
  EXPECT_EQ(bench.marks().size(), 5U);
}

// The disk is full from the second blow to the fourth, at four times real time. The file equals the file of a session
// with enough room.
TEST(RecordFiles, LoseNothingWhileTheDiskIsFull) {
  const std::string record = "percuss record -o t.h5 --device sim:aluminium-bat,speed=4,end=12";
  const Bench whole, bench;
  ASSERT_EQ(whole.shell(record + " >out 2>err"), 0);
  EXPECT_EQ(
      bench.run_and_act("(" + record + ")", "grep -q 'Blow 1' out",
                        "prlimit --pid $! --fsize=300000:; for i in $(seq 500); do grep -q 'Blow 4' out && break; "
                        "sleep 0.02; done; prlimit --pid $! --fsize=unlimited:"),
      0)
      << bench.bytes("err");
  EXPECT_THAT(bench.bytes("out"), HasSubstr("the journal cannot be written"));
  EXPECT_TRUE(bench.bytes("t.h5") == whole.bytes("t.h5"));
}

TEST(RecordFiles, NamesAnUnfinishedSessionBeforeItIsOverwritten) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=5").code, 6);
  const std::string journal = bench.bytes("t.h5.journal");
  for (const bool with_file : {true, false}) {
    if (!with_file) fs::remove(bench.folder.file("t.h5"));
    const auto refused = bench.record("sim:aluminium-bat");
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("a session was not finished after 2 blows (t.h5.journal); resume it, or "
                                       "overwrite it (--resume, --force)"));
    EXPECT_TRUE(bench.bytes("t.h5.journal") == journal);
  }
  const auto forced = bench.record("sim:aluminium-bat", {"--force"});
  EXPECT_EQ(forced.code, 0);
  EXPECT_THAT(forced.err, HasSubstr("the unfinished session of t.h5 is overwritten; lost: the 2 blows of its journal"));
}

TEST(RecordFiles, TakesAnySpellingOfTheFileToResume) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"t.h5.journal"}, {"./t.h5", "-o", "t.h5"}, {"t.h5", "-o", "./t.h5"}, {"t.h5.journal", "-o", "t.h5"}}) {
    const Bench bench;
    bench.run_and_act("percuss record -o t.h5 --device sim:aluminium-bat", "grep -q 'Blow 1' out", "kill -9 $!");
    ASSERT_TRUE(bench.has("t.h5.journal"));
    std::vector<std::string> command{"record", "--resume"};
    command.insert(command.end(), words.begin(), words.end());
    command.emplace_back("--fast");
    const auto resumed = bench.run(command);
    EXPECT_EQ(resumed.code, 0) << words.back() << resumed.err;
    EXPECT_EQ(bench.marks().size(), 5U);
  }
}

// A session in the folder "begun", with its files named by relative paths.
void begin_in_a_folder(const Bench& bench) {
  fs::create_directory(bench.folder.file("begun"));
  test::write_bytes(bench.folder.file("begun/g.csv"), "point,x_m,y_m,z_m\n0,0,0,0\n1,0.1,0,0\n");
  test::write_bytes(bench.folder.file("begun/s.json"), R"([{"name":"1","role":"force"},{"name":"2"},{"name":"3"}])");
  ASSERT_EQ(bench.run({"synth", "aluminium-bat", "-o", "begun/r.h5"}).code, 0);
  bench.shell(
      "cd begun\n"
      "percuss record -o t.h5 --hits 2 --device file:r.h5 --geometry g.csv --setup s.json --report r.html >out &\n"
      "for i in $(seq 500); do grep -q 'blow 1' out && break; sleep 0.02; done\nkill -9 $!\nwait $!");
  ASSERT_TRUE(bench.has("begun/t.h5.journal"));
}

TEST(RecordFiles, AreFoundFromAnotherFolder) {
  const Bench bench;
  begin_in_a_folder(bench);
  fs::copy(bench.folder.file("begun/t.h5.journal"), bench.folder.file("journal"));
  EXPECT_EQ(bench.run({"record", "--resume", "begun/t.h5", "--fast"}).code, 0);
  EXPECT_TRUE(bench.has("begun/r.html"));
  const std::string expected = bench.bytes("begun/t.h5");
  fs::remove(bench.folder.file("begun/t.h5"));
  // The same files may be named by other paths.
  fs::copy(bench.folder.file("journal"), bench.folder.file("begun/t.h5.journal"));
  const auto named = bench.run({"record", "--resume", "begun/t.h5", "--fast", "--geometry", "begun/g.csv", "--setup",
                                bench.folder.file("begun/s.json"), "--device", "file:./begun/r.h5"});
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_TRUE(bench.bytes("begun/t.h5") == expected);
  fs::remove(bench.folder.file("begun/t.h5"));
  // The folder was moved, and a file renamed.
  fs::copy(bench.folder.file("journal"), bench.folder.file("begun/t.h5.journal"));
  fs::rename(bench.folder.file("begun"), bench.folder.file("moved"));
  fs::rename(bench.folder.file("moved/g.csv"), bench.folder.file("moved/grid.csv"));
  const auto missing = bench.run({"record", "--resume", "moved/t.h5", "--fast"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("a file of the session is missing (g.csv); state where it is now (--geometry)"));
  const auto other = bench.run({"record", "--resume", "moved/t.h5", "--fast", "--geometry", "moved/s.json"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("--geometry contradicts the session, which began with \"g.csv\""));
  EXPECT_EQ(bench.run({"record", "--resume", "moved/t.h5", "--fast", "--geometry", "moved/grid.csv"}).code, 0);
  EXPECT_TRUE(bench.bytes("moved/t.h5") == expected);
}

}  // namespace percuss::record_files_test
