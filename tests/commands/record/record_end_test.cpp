#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/live/capture_finding.hpp"
#include "acquire/live/journal_format.hpp"
#include "acquire/live/journal_reader.hpp"
#include "acquire/live/journal_writer.hpp"
#include "acquire/record/stated_date.hpp"
#include "support/live/record_bench.hpp"

// percuss record when a session ends early, goes on or meets faults.
namespace percuss::record_end_test {

namespace fs = std::filesystem;
using Bench = test::RecordBench;
using testing::HasSubstr;

// A fault is reported after the blows that precede it, whatever the load of the machine.
TEST(RecordEnd, TellsFaultsInTheOrderOfSamples) {
  const Bench bench;
  const auto first = bench.record("sim:aluminium-bat,gap=2.5:0.05,unplug=6");
  const std::size_t gap = first.out.find("a gap of"), end = first.out.find("the device was unplugged");
  ASSERT_NE(gap, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  EXPECT_LT(first.out.find("Blow 1 of 5: accepted"), gap);
  EXPECT_GT(first.out.find("Blow 2 of 5: accepted"), gap);
  EXPECT_LT(first.out.find("Blow 3 of 5: accepted"), end);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(bench.record("sim:aluminium-bat,gap=2.5:0.05,unplug=6", {"--force"}).out, first.out);
}

TEST(RecordEnd, RefusesOptionsThatContradictTheSession) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=5").code, 6);
  const auto hits = bench.run({"record", "--resume", "t.h5", "--hits", "9"});
  EXPECT_EQ(hits.code, 2);
  EXPECT_THAT(hits.err, HasSubstr("--hits contradicts the session, which began with 5"));
  const auto band = bench.run({"record", "--resume", "t.h5", "--band", "60:3200"});
  EXPECT_EQ(band.code, 2);
  EXPECT_THAT(band.err, HasSubstr("--band contradicts the session, which began without it"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "-o", "u.h5"}).code, 2);
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "--hits", "5", "--report", "r.html"}).code, 6);
  EXPECT_TRUE(bench.has("r.html"));
}

// Otherwise the blows of the first part would get the new places and roles.
TEST(RecordEnd, RefusesFilesThatChangedSinceTheSessionBegan) {
  const Bench bench;
  const std::string grid = bench.folder.file("g.csv"), setup = bench.folder.file("s.json");
  const std::string points = "point,x_m,y_m,z_m\n0,0,0,0\n1,0.1,0,0\n";
  const std::string roles = R"([{"name":"1","role":"force"},{"name":"2"},{"name":"3"}])";
  test::write_bytes(grid, points);
  test::write_bytes(setup, roles);
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=5", {"--geometry", "g.csv", "--setup", "s.json"}).code, 6);
  test::write_bytes(grid, points + "2,0.2,0,0\n");
  const auto moved = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(moved.code, 3);
  EXPECT_THAT(moved.err, HasSubstr("the file has changed since the session began (g.csv); restore it"));
  test::write_bytes(grid, points);
  test::write_bytes(setup, R"([{"name":"1","role":"force"},{"name":"2","sign":-1},{"name":"3"}])");
  const auto turned = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(turned.code, 3);
  EXPECT_THAT(turned.err, HasSubstr("the file has changed since the session began (s.json); restore it"));
  test::write_bytes(setup, roles);
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5"}).code, 6);
}

TEST(RecordEnd, NamesAChannelWithoutNumbers) {
  const Bench bench;
  const auto recorded = bench.record("sim:aluminium-bat,nan=0:100");
  EXPECT_EQ(recorded.code, 4);
  EXPECT_THAT(recorded.out, HasSubstr("delivers values that are no numbers"));
}

TEST(RecordEnd, EndsEarlyWithItsOwnCode) {
  const Bench bench;
  const auto unplugged = bench.record("sim:aluminium-bat,unplug=5");
  EXPECT_EQ(unplugged.code, 6) << unplugged.err;
  EXPECT_THAT(unplugged.out, HasSubstr("percuss record --resume t.h5"));
  EXPECT_TRUE(bench.has("t.h5"));
  EXPECT_TRUE(bench.has("t.h5.journal"));
  const auto journal = bench.run({"info", "t.h5.journal"});
  EXPECT_EQ(journal.code, 3);
  EXPECT_THAT(journal.err, HasSubstr("resume the recording (see percuss record --resume)"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5"}).code, 6);  // still unplugged
  const auto ended = bench.record("sim:aluminium-bat,end=5", {"--force"});
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.out, HasSubstr("the device has no more of them"));
  EXPECT_TRUE(bench.has("t.h5.journal"));
  const auto silent = bench.record("sim:aluminium-bat,first=50,end=2", {"--force"});
  EXPECT_EQ(silent.code, 4);
}

// From the exit code, a script that records several tests in a row learns that the device is unplugged.
TEST(RecordEnd, EndsEarlyBeforeTheFirstBlow) {
  const Bench bench;
  const auto unplugged = bench.record("sim:aluminium-bat,unplug=0.5", {"--report", "r.html"});
  EXPECT_EQ(unplugged.code, 6);
  EXPECT_THAT(unplugged.out, HasSubstr("no blow was recorded, so no file is written"));
  EXPECT_THAT(unplugged.err, HasSubstr("no report is written, because no blow counts"));
  EXPECT_FALSE(bench.has("t.h5"));
  EXPECT_FALSE(bench.has("t.h5.journal"));
  EXPECT_EQ(bench.record("sim:aluminium-bat,unplug=5,silent=3").code, 6);  // rejected blows alone
  EXPECT_TRUE(bench.has("t.h5.journal"));
  const std::string silent = "percuss record -o u.h5 --device sim:aluminium-bat,first=99";
  EXPECT_EQ(bench.run_and_act(silent, "grep -q 'hammer on channel' out", "kill $!"), 6);
}

// The disk was full between two blows.
TEST(RecordEnd, StatesFramesThatTheJournalLacks) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=5").code, 6);
  const acquire::CaptureFinding missing{
      .fault = acquire::CaptureFault::not_in_journal, .frame = 100000, .count = 25600};
  const std::string block = acquire::journal_block(acquire::JournalBlockType::finding, acquire::finding_json(missing));
  test::write_bytes(bench.folder.file("t.h5.journal"), bench.bytes("t.h5.journal") + block);
  const auto resumed = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(resumed.code, 6);
  const std::string stated = "25600 frames (1 s) are not in the journal, because it could not be written";
  const std::size_t first = resumed.out.find(stated), last = resumed.out.rfind(stated);
  ASSERT_NE(first, std::string::npos) << resumed.out;
  EXPECT_LT(first, resumed.out.find("resumed after 2 blows"));
  EXPECT_GT(last, first);
  EXPECT_LT(last, resumed.out.find("go on with: percuss record --resume t.h5"));
}

// The journal is damaged in its middle, and the file of the first part still holds all blows.
TEST(RecordEnd, KeepsTheBlowsThatADamagedJournalHasLost) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=8.5").code, 6);
  ASSERT_EQ(bench.marks().size(), 4U);
  const std::string whole = bench.bytes("t.h5");
  std::string journal = bench.bytes("t.h5.journal");
  journal.replace(journal.size() / 2, 7, "garbage");
  test::write_bytes(bench.folder.file("t.h5.journal"), journal);
  const auto refused = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("the file holds 4 blows, its journal "));
  EXPECT_THAT(refused.err, HasSubstr("move it elsewhere, and resume again"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "--force"}).code, 3);
  EXPECT_TRUE(bench.bytes("t.h5") == whole);
  EXPECT_TRUE(bench.bytes("t.h5.journal") == journal);
  fs::rename(bench.folder.file("t.h5"), bench.folder.file("kept.h5"));
  const auto resumed = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(resumed.code, 6) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr("bytes of the journal are not whole and are left out"));
  EXPECT_TRUE(bench.has("t.h5"));
}

// The journal has the verdicts of all blows, but the samples of the last ones only.
TEST(RecordEnd, KeepsTheBlowsWhoseSamplesTheJournalLacks) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=8.5").code, 6);
  ASSERT_EQ(bench.marks().size(), 4U);
  {
    const acquire::JournalReader journal(bench.folder.file("t.h5.journal"));
    acquire::JournalWriter lacking(bench.folder.file("lacking.journal"), journal.format(), false);
    for (const acquire::JournalEvent& event : journal.events())
      lacking.append(acquire::journal_block(acquire::JournalBlockType::event, event.json));
    const std::uint64_t end = journal.end_frame();
    for (std::uint64_t at = end / 2; at < end; at += 4096) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(4096, end - at));
      std::string block;
      acquire::make_sample_block({.first_frame = at, .frames = count, .values = journal.read(at, count)},
                                 journal.format().channels, block);
      lacking.append(block);
    }
  }
  fs::rename(bench.folder.file("lacking.journal"), bench.folder.file("t.h5.journal"));
  const std::string whole = bench.bytes("t.h5");
  const auto refused = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("the file holds 4 blows, its journal 2"));
  EXPECT_TRUE(bench.bytes("t.h5") == whole);
  EXPECT_TRUE(bench.has("t.h5.journal"));
}

TEST(RecordEnd, KeepsAForeignFileWhenItResumes) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat,unplug=5").code, 6);
  test::write_bytes(bench.folder.file("t.h5"), "notes of the day\n");
  const auto refused = bench.run({"record", "--resume", "t.h5"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("the file is no record of the session"));
  EXPECT_EQ(bench.bytes("t.h5"), "notes of the day\n");
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "--force"}).code, 6);
  EXPECT_EQ(bench.marks().size(), 2U);
}

TEST(RecordEnd, FinishesCleanlyOnASignal) {
  const Bench bench;
  EXPECT_EQ(bench.shell("timeout -s INT 3 percuss record -o t.h5 --device sim:aluminium-bat,speed=2 >out"), 124);
  EXPECT_TRUE(bench.has("t.h5"));
  EXPECT_THAT(bench.bytes("out"), HasSubstr("percuss record --resume t.h5"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "--fast"}).code, 0);
  EXPECT_EQ(bench.marks().size(), 5U);
  EXPECT_FALSE(bench.has("t.h5.journal"));
}

// A simulated or replayed session has no date, so its file has the same bytes whenever it is made.
TEST(RecordEnd, DatesASessionByItsBeginning) {
  const Bench bench;
  ASSERT_EQ(bench.run({"synth", "aluminium-bat", "-o", "x.wav"}).code, 0);
  const std::string record =
      "percuss record -o t.h5 --force --hits 1 --device stdin: --channels 1,2 --setup s.json <x.wav";
  test::write_bytes(bench.folder.file("s.json"), R"([{"name":"1","role":"force","unit":"N"},{"name":"2","unit":"g"}])");
  bench.shell("SOURCE_DATE_EPOCH=1764201600 " + record + " >out 2>&1");
  ASSERT_TRUE(bench.has("t.h5")) << bench.bytes("out");
  EXPECT_EQ(acquire::date_of(acquire::open_hdf5(bench.folder.file("t.h5"), {}).files.at(0)), "2025-11-27 00:00 UTC");
  ASSERT_EQ(bench.record("sim:aluminium-bat", {"--force"}).code, 0);
  EXPECT_EQ(acquire::date_of(acquire::open_hdf5(bench.folder.file("t.h5"), {}).files.at(0)), "");
}

// Whenever a session is killed: after --resume, the file has the bytes of an uninterrupted session.
TEST(RecordEnd, ResumesAfterAKillToTheSameBytes) {
  const Bench bench;
  const std::string device = "sim:aluminium-bat,double=2,speed=8";
  ASSERT_EQ(bench.record(device).code, 0);
  const std::string expected = bench.bytes("t.h5");
  int kills = 0;
  for (const char* seconds : {"0.2", "0.45", "0.7", "0.95", "1.2", "1.6"}) {
    fs::remove(bench.folder.file("t.h5"));
    bench.shell(std::string("timeout -s KILL ") + seconds + " percuss record -o t.h5 --device " + device +
                " >out 2>&1");
    if (!bench.has("t.h5.journal")) {  // it was faster, or had not begun
      EXPECT_TRUE(!bench.has("t.h5") || bench.bytes("t.h5") == expected);
      continue;
    }
    const auto resumed = bench.run({"record", "--resume", "t.h5"});
    if (resumed.err.find("no options of a session") != std::string::npos) {  // killed within its first milliseconds
      fs::remove(bench.folder.file("t.h5.journal"));
      continue;
    }
    ++kills;
    EXPECT_EQ(resumed.code, 0) << seconds << resumed.err << resumed.out;
    EXPECT_TRUE(bench.bytes("t.h5") == expected) << seconds;
    EXPECT_FALSE(bench.has("t.h5.journal"));
  }
  EXPECT_GT(kills, 0);
}

}  // namespace percuss::record_end_test
