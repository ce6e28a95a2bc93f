#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "support/live/record_bench.hpp"
#include "support/scratch_folder.hpp"

// percuss record with simulated devices.
namespace percuss::record_command_test {

using acquire::RowMark;
using Bench = test::RecordBench;
using testing::ElementsAre, testing::HasSubstr, testing::Not;

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

// The last screen and the document are those of an analysis with the same object.
TEST(RecordCommand, AppliesTheObjectOption) {
  const Bench bench;
  const auto tube = bench.record("sim:aluminium-bat", {"--hits", "2"});
  EXPECT_THAT(tube.out, HasSubstr("bending 1"));
  const auto other = bench.record("sim:aluminium-bat", {"--hits", "2", "--object", "other", "--force", "--json"});
  EXPECT_THAT(other.err, Not(HasSubstr("bending 1")));
  EXPECT_EQ(other.out, bench.run({"analyze", "t.h5", "--object", "other", "--json"}).out);
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

TEST(RecordCommand, StopsWhenTheGoalIsMet) {
  const Bench bench;
  const auto met = bench.record("sim:aluminium-bat,hits=9", {"--hits", "9", "--until", "mode 1<50Hz"});
  EXPECT_EQ(met.code, 0);
  EXPECT_THAT(met.out, HasSubstr("the goal mode 1 < 50 Hz is met"));
  EXPECT_LT(bench.marks().size(), 9U);
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--until", "mode 1<1e-9Hz", "--force"}).out,
              HasSubstr("the goal mode 1 < 1e-09 Hz is not met"));
  const auto wrong = bench.record("sim:aluminium-bat", {"--until", "hoop<1Hz", "--force"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--until is not understood: 'hoop<1Hz'"));
  EXPECT_EQ(bench.record("sim:aluminium-bat", {"--until", "", "--force"}).code, 2);
}

// The message comes while more blows may still be struck, not only at the end.
TEST(RecordCommand, NamesAGoalForAModeThatTheTestLacks) {
  const Bench bench;
  const std::string record = "percuss record -o t.h5 --device sim:aluminium-bat,hits=99 --hits 99 --until 'hoop 7<1Hz'";
  EXPECT_EQ(bench.run_and_act(record, "grep -q 'hoop 7' out", "kill $!"), 6);
  EXPECT_THAT(bench.bytes("out"),
              HasSubstr("! the goal hoop 7 < 1 Hz names none of the modes found so far: bending 1, "));
}

TEST(RecordCommand, GuidesThroughAGeometry) {
  const Bench bench;
  test::write_bytes(bench.folder.file("g.csv"), "point,x_m,y_m,z_m\n0,0,0,0\n1,0.1,0,0\n2,0.2,0,0\n");
  const auto recorded =
      bench.record("sim:aluminium-bat,hits=6", {"--geometry", "g.csv", "--hits", "2", "--report", "r.html"});
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_THAT(recorded.out, HasSubstr("Point 1 (2 of 3), blow 1 of 2 (hit 3): accepted"));
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
  // The windows differ by some samples, so the frequencies agree only to about their relative standard deviation, 1e-6.
  for (std::size_t m = 0; m < original.size(); ++m) EXPECT_NEAR(replayed[m], original[m], 2e-6 * original[m]);
}

// The pipe has no row ends and no names of files; the forces are those of the file.
TEST(RecordCommand, ReadsTheScaleOfAWavFromAPipe) {
  const Bench bench;
  ASSERT_EQ(bench.run({"synth", "aluminium-bat", "-o", "r.wav"}).code, 0);
  ASSERT_EQ(bench.shell("percuss record -o t.h5 --device stdin: <r.wav >piped"), 0);
  ASSERT_EQ(bench.shell("percuss record -o t.h5 --force --fast --device file:r.wav >replayed"), 0);
  const auto first_blow = [&](const char* file) {
    const std::string text = bench.bytes(file);
    const std::size_t at = text.find("Blow 1 of 5: accepted, ");
    return at == std::string::npos ? "none" : text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_THAT(first_blow("piped"), HasSubstr(" N up to "));
  EXPECT_EQ(first_blow("piped"), first_blow("replayed"));
}

TEST(RecordCommand, TakesRangesOfChannels) {
  const Bench bench;
  ASSERT_EQ(bench.record("sim:aluminium-bat", {"--hits", "1"}).code, 0);
  const std::string expected = bench.bytes("t.h5");
  ASSERT_EQ(bench.record("sim:aluminium-bat", {"--hits", "1", "--channels", "1-3", "--force"}).code, 0);
  EXPECT_TRUE(bench.bytes("t.h5") == expected);
  const auto swapped = bench.record("sim:aluminium-bat", {"--hits", "1", "--channels", "1,3,2", "--force"});
  ASSERT_EQ(swapped.code, 0) << swapped.err;
  EXPECT_FALSE(bench.bytes("t.h5") == expected);
}

// The file states neither which column is the force nor the sensitivity of the hammer.
TEST(RecordCommand, ReplaysAFileWithTheSetUp) {
  const Bench bench;
  ASSERT_EQ(bench.run({"synth", "aluminium-bat", "-o", "r.csv"}).code, 0);
  std::string text = bench.bytes("r.csv");
  text.replace(0, text.find('\n'), "hit,time (s),CH1 (V),CH2 (cm/s2),CH3 (cm/s2)");
  test::write_bytes(bench.folder.file("r.csv"), text);
  const auto refused = bench.record("file:r.csv");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("name the hammer's channel in the set-up (--setup)"));
  test::write_bytes(bench.folder.file("s.json"),
                    R"([{"name": "CH1", "role": "force", "sensitivity": 500, "sensitivity_unit": "mV/N"},
                        {"name": "CH2", "angle_deg": 90}, {"name": "CH3", "sign": -1}])");
  const auto recorded = bench.record("file:r.csv", {"--setup", "s.json", "--channels", "1,3,2"});
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_EQ(bench.marks().size(), 5U);
  const auto original = acquire::open_record(bench.folder.file("r.csv"), {.force_channel = "CH1", .force_scale = {2}});
  const auto written = acquire::open_hdf5(bench.folder.file("t.h5"), {});
  EXPECT_FALSE(written.accel[0].angle_rad);
  ASSERT_TRUE(written.accel[1].angle_rad);
  const auto peak = [](const acquire::Record& record, int channel) {
    std::vector<double> x(record.rows[0].samples);
    if (channel < 0) record.read_force_N(0, 0, x);
    if (channel >= 0) record.read_accel_mps2(0, static_cast<std::size_t>(channel), 0, x);
    return *std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  };
  EXPECT_DOUBLE_EQ(peak(written, -1), peak(original, -1));
  EXPECT_DOUBLE_EQ(peak(written, 0), -peak(original, 1));
  EXPECT_DOUBLE_EQ(peak(written, 1), peak(original, 0));
}

TEST(RecordCommand, GoesOnWithoutAReaderOfItsLines) {
  const Bench bench;
  EXPECT_EQ(bench.shell("percuss record -o t.h5 --device sim:aluminium-bat --fast | head -1 >out"), 0);
  EXPECT_EQ(bench.marks().size(), 5U);
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
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--channels", "1,1"}).err, HasSubstr("channel 1 is named twice"));
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--channels", "1-2,2"}).err, HasSubstr("channel 2 is named twice"));
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--channels", "x"}).err,
              HasSubstr("give whole numbers from 1 up, or ranges such as 1-3"));
  test::write_bytes(bench.folder.file("wrong.json"), R"([{"name": "no such channel", "role": "force"}])");
  EXPECT_NE(bench.record("sim:aluminium-bat", {"--setup", "wrong.json"}).code, 0);
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--band", "60:12800"}).err,
              HasSubstr("half the sampling rate is 12800 Hz"));
  EXPECT_THAT(bench.record("sim:aluminium-bat", {"--length", "0.3", "--pretrigger", "0.3"}).err,
              HasSubstr("of which 0.3 s come before its peak"));
  EXPECT_EQ(bench.record("sim:aluminium-bat", {"--pretrigger", "0"}).code, 3);
  const auto encoding = bench.run({"record", "-o", "t.h5", "--device", "stdin:raw:s20:1000:2"});
  EXPECT_EQ(encoding.code, 2);
  EXPECT_THAT(encoding.err, HasSubstr("--device is not understood: an unknown encoding of samples (s20); use s16,"));
  EXPECT_EQ(bench.run({"record", "-o", "t.h5", "--device", "stdin:raw:s24"}).code, 2);
  EXPECT_EQ(bench.run({"record", "-o", "t.h5", "--device", "stdin:"}).code, 3);  // an empty pipe
  const auto fast = bench.record("stdin:raw:s24:1000:2");
  EXPECT_EQ(fast.code, 2);
  EXPECT_THAT(fast.err, HasSubstr("--fast is for simulated and replayed devices; leave it out"));
  EXPECT_FALSE(bench.has("t.h5"));
  EXPECT_FALSE(bench.has("t.h5.journal"));
}

}  // namespace percuss::record_command_test
