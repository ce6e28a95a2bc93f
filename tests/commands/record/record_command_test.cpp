#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// percuss record with simulated devices.
namespace percuss::record_command_test {
namespace {

namespace fs = std::filesystem;
using acquire::RowMark;
using test::lines_of, test::run_percuss, test::ScratchFolder;
using testing::ElementsAre, testing::HasSubstr, testing::Not;

struct Bench {
  ScratchFolder folder;
  test::ProcessOutcome run(std::vector<std::string> arguments) const {
    return run_percuss(arguments, {.folder = folder.path()});
  }
  test::ProcessOutcome record(const std::string& device, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"record", "-o", "t.h5", "--device", device, "--fast"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  std::string bytes(const std::string& name) const { return test::bytes_of(folder.file(name)); }
  bool has(const std::string& name) const { return fs::exists(folder.file(name)); }
  std::vector<RowMark> marks() const {
    std::vector<RowMark> out;
    for (const auto& row : acquire::open_hdf5(folder.file("t.h5"), {}).rows) out.push_back(row.mark);
    return out;
  }
  /// Runs a shell line in the folder, with percuss on the path; returns its exit code.
  int shell(const std::string& line) const {
    const std::string programs = fs::path(PERCUSS_EXECUTABLE).parent_path();
    const std::string command =
        "cd '" + folder.path() + "' && PATH='" + programs + "':$PATH && { " + line + "\n} </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

std::vector<double> frequencies(const std::string& json) {
  std::vector<double> out;
  const auto document = nlohmann::json::parse(json);
  for (const auto& mode : document["modes"]) out.push_back(mode["frequency_hz"]);
  return out;
}

TEST(RecordCommand, WritesARecordWithTheSameAnalysis) {
  const Bench bench;
  const auto recorded = bench.record("sim:aluminium-bat,double=2,weak=4", {"--json"});
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_THAT(recorded.err, HasSubstr("rejected: two contacts"));
  EXPECT_FALSE(bench.has("t.h5.journal"));
  const auto analysed = bench.run({"analyze", "t.h5", "--json"});
  EXPECT_EQ(analysed.code, 0);
  EXPECT_EQ(recorded.out, analysed.out);
  std::vector<bool> accepted;
  const auto document = nlohmann::json::parse(analysed.out);
  for (const auto& hit : document["hits"]) accepted.push_back(hit["accepted"]);
  std::vector<bool> unmarked;
  for (const RowMark mark : bench.marks()) unmarked.push_back(mark == RowMark::none);
  EXPECT_EQ(accepted, unmarked);
  EXPECT_EQ(std::count(accepted.begin(), accepted.end(), true), 5);
}

TEST(RecordCommand, SaysWhatIsWrongWithABlow) {
  const Bench bench;
  const auto recorded = bench.record("sim:aluminium-bat,double=2,weak=4,clipped=6,gap=9.1:0.05,silent=3");
  EXPECT_EQ(recorded.code, 4);
  EXPECT_THAT(recorded.out, HasSubstr("channel 3 (accel 2) is silent; check its cable and its input"));
  const auto others = bench.record("sim:aluminium-bat,double=2,weak=4,clipped=6", {"--force"});
  EXPECT_EQ(others.code, 0);
  EXPECT_THAT(others.out, HasSubstr("rejected: two contacts"));
  EXPECT_THAT(others.out, HasSubstr("rejected: too weak"));
  EXPECT_THAT(others.out, HasSubstr("rejected: the force"));
  EXPECT_THAT(others.out, HasSubstr("Blow 1 of 5: accepted"));
}

TEST(RecordCommand, EndsEarlyWithItsOwnCode) {
  const Bench bench;
  const auto unplugged = bench.record("sim:aluminium-bat,unplug=5");
  EXPECT_EQ(unplugged.code, 6) << unplugged.err;
  EXPECT_THAT(unplugged.out, HasSubstr("percuss record --resume t.h5"));
  EXPECT_TRUE(bench.has("t.h5"));
  EXPECT_TRUE(bench.has("t.h5.journal"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5"}).code, 6);  // still unplugged
  const auto ended = bench.record("sim:aluminium-bat,end=5", {"--force"});
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.out, HasSubstr("percuss record --resume t.h5"));
  EXPECT_TRUE(bench.has("t.h5.journal"));
  const auto silent = bench.record("sim:aluminium-bat,first=50,end=2", {"--force"});
  EXPECT_EQ(silent.code, 4);
}

// A fault is told after the blows before it, at any load of the machine.
TEST(RecordCommand, TellsFaultsInTheOrderOfSamples) {
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

TEST(RecordCommand, NamesAFailedReportAndPrintsTheDocument) {
  const Bench bench;
  test::write_bytes(bench.folder.file("g.csv"), "point,x_m,y_m,z_m\n1,0,0,0\n");
  const auto recorded = bench.record("sim:aluminium-bat", {"--json", "--report", "no-such-folder/r.html"});
  EXPECT_NE(recorded.code, 0);
  EXPECT_THAT(recorded.err, HasSubstr("no-such-folder"));
  EXPECT_EQ(recorded.out, bench.run({"analyze", "t.h5", "--json"}).out);
  const auto none = bench.record("sim:aluminium-bat,first=2,end=8,silent=2", {"--force", "--report", "r.html"});
  EXPECT_EQ(none.code, 4);
  EXPECT_THAT(none.err, HasSubstr("no report is written"));
}

TEST(RecordCommand, RefusesOptionsThatContradictTheSession) {
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

TEST(RecordCommand, NamesADeadChannel) {
  const Bench bench;
  const auto recorded = bench.record("sim:aluminium-bat,nan=0:100");
  EXPECT_EQ(recorded.code, 4);
  EXPECT_THAT(recorded.out, HasSubstr("delivers values that are no numbers"));
}

TEST(RecordCommand, StopsWhenTheGoalIsMet) {
  const Bench bench;
  const auto met = bench.record("sim:aluminium-bat,hits=9", {"--hits", "9", "--until", "mode 1<50Hz"});
  EXPECT_EQ(met.code, 0);
  EXPECT_THAT(met.out, HasSubstr("the goal mode 1 < 50 Hz is met"));
  EXPECT_LT(bench.marks().size(), 9U);
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--until", "mode 1<1e-9Hz", "--force"}).out,
              HasSubstr("the goal mode 1 < 1e-09 Hz is not met"));
  const auto wrong = bench.record("sim:aluminium-bat", {"--until", "hoop<1Hz", "--force"});
  EXPECT_NE(wrong.code, 0);
  EXPECT_THAT(wrong.err, HasSubstr("--until"));
}

TEST(RecordCommand, GuidesThroughAGeometry) {
  const Bench bench;
  test::write_bytes(bench.folder.file("g.csv"), "point,x_m,y_m,z_m\n0,0,0,0\n1,0.1,0,0\n2,0.2,0,0\n");
  const auto recorded =
      bench.record("sim:aluminium-bat,hits=6", {"--geometry", "g.csv", "--hits", "2", "--report", "r.html"});
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_THAT(recorded.out, HasSubstr("Point 1 (2 of 3), blow 1 of 2: accepted"));
  const auto record = acquire::open_hdf5(bench.folder.file("t.h5"), {});
  std::vector<int> points;
  for (const auto& row : record.rows) points.push_back(row.point);
  EXPECT_THAT(points, ElementsAre(0, 0, 1, 1, 2, 2));
  EXPECT_EQ(record.geometry.size(), 3U);
  EXPECT_TRUE(bench.has("r.html"));
}

TEST(RecordCommand, AnalysesAReplayedRecordAlike) {
  const Bench bench;
  ASSERT_EQ(bench.run({"synth", "composite-bat", "-o", "r.h5"}).code, 0);
  ASSERT_EQ(bench.record("file:r.h5").code, 0);
  const auto of = [&](const char* file) {
    return frequencies(bench.run({"analyze", file, "--band", "60:3200", "--json"}).out);
  };
  EXPECT_THAT(bench.run({"analyze", "t.h5", "--band", "60:3200"}).out, Not(HasSubstr("the capture lost")));
  const auto replayed = of("t.h5"), original = of("r.h5");
  ASSERT_EQ(replayed.size(), original.size());
  // The windows differ by some samples: the fits agree far below the ± of 1e-6.
  for (std::size_t m = 0; m < original.size(); ++m) EXPECT_NEAR(replayed[m], original[m], 1e-5 * original[m]);
}

TEST(RecordCommand, FinishesCleanlyOnASignal) {
  const Bench bench;
  EXPECT_EQ(bench.shell("timeout -s INT 3 percuss record -o t.h5 --device sim:aluminium-bat,speed=2 >out"), 124);
  EXPECT_TRUE(bench.has("t.h5"));
  EXPECT_THAT(bench.bytes("out"), HasSubstr("percuss record --resume t.h5"));
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5", "--fast"}).code, 0);
  EXPECT_EQ(bench.marks().size(), 5U);
  EXPECT_FALSE(bench.has("t.h5.journal"));
}

TEST(RecordCommand, GoesOnWithoutAReaderOfItsLines) {
  const Bench bench;
  EXPECT_EQ(bench.shell("percuss record -o t.h5 --device sim:aluminium-bat --fast | head -1 >out"), 0);
  EXPECT_EQ(bench.marks().size(), 5U);
}

// At any moment of a session: the finished file has the bytes of an uninterrupted one.
TEST(RecordCommand, ResumesAfterAKillToTheSameBytes) {
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

TEST(RecordCommand, RefusesWhatItCannotRecord) {
  const Bench bench;
  EXPECT_EQ(bench.run({"record", "--device", "sim:aluminium-bat"}).code, 2);
  EXPECT_EQ(bench.run({"record", "-o", "t.h5"}).code, 2);
  EXPECT_EQ(bench.run({"record", "-o", "t.csv", "--device", "sim:aluminium-bat"}).code, 2);
  EXPECT_EQ(bench.run({"record", "--resume", "t.h5"}).code, 3);
  EXPECT_EQ(bench.record("sim:no-such-bat").code, 3);
  EXPECT_EQ(bench.record("sim:aluminium-bat", {"--channels", "1"}).code, 3);
  EXPECT_EQ(bench.record("sim:aluminium-bat", {"--channels", "0,1"}).code, 2);
  test::write_bytes(bench.folder.file("wrong.json"), R"([{"name": "no such channel", "role": "force"}])");
  EXPECT_NE(bench.record("sim:aluminium-bat", {"--setup", "wrong.json"}).code, 0);
  EXPECT_FALSE(bench.has("t.h5"));
  EXPECT_FALSE(bench.has("t.h5.journal"));
}

}  // namespace
}  // namespace percuss::record_command_test
