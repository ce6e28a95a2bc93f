#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "commands/inputs/input_files.hpp"
#include "support/files/mat_builder.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/files/uff_text.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

// Files as users have them: percuss reads them, or one message says what would work.
namespace percuss::inputs_test {

using test::kFrequencyTolerance_Hz;
using test::run_percuss;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class Inputs : public test::InputFiles {};

TEST_F(Inputs, MayBeAFolderOrAQuotedPattern) {
  for (int i : {2, 10, 1}) test::write_small_test(file("hit" + std::to_string(i) + ".h5"), R"("hits": 1)");
  test::write_bytes(file("notes.md"), "no record");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"hit1.h5", "hit2.h5", "hit10.h5"}, {"hit*.h5"}, {"."}}) {
    std::vector<std::string> command{"analyze", "--json", "--only", "hits"};
    command.insert(command.end(), words.begin(), words.end());
    const auto outcome = run_percuss(command, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto document = test::parse_json(outcome.out);
    std::string names;
    for (const auto& input : document["inputs"])
      names += std::filesystem::path(input["path"].get<std::string>()).filename().string() + " ";
    EXPECT_EQ(names, "hit1.h5 hit2.h5 hit10.h5 ") << words.front();
  }
  const auto folder = run_percuss({"analyze", ".", "--only", "hits"}, {.folder = folder_.path()});
  EXPECT_THAT(folder.out + folder.err, HasSubstr("left out, because it has no known extension: notes.md"));
  const auto none = run_percuss({"info", "*.uff"}, {.folder = folder_.path()});
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("no file matches the pattern (*.uff)"));
}

// Three lines are lost. If percuss closed the gap, the later samples would come too early, and the mode would be off by
// many standard deviations.
TEST_F(Inputs, WithLostLinesKeepTheirTime) {
  const auto column = [&](std::vector<double> x) {
    x.erase(x.begin() + 900, x.begin() + 903);
    return x;
  };
  test::write_columns(file("lost.csv"), "time_s,force_N,accel_m_s2",
                      {column(record_.time_s), column(record_.force_N), column(record_.accel_mps2)});
  test::write_columns(file("whole.csv"), "time_s,force_N,accel_m_s2",
                      {record_.time_s, record_.force_N, record_.accel_mps2});
  ASSERT_EQ(run_percuss({"convert", file("lost.csv"), file("lost.h5")}).code, 0);
  EXPECT_THAT(run_percuss({"convert", file("lost.csv"), file("lost.mat")}).err,
              HasSubstr("not kept: which samples were lost"));
  const double whole_Hz = first_mode_Hz(analyze({"whole.csv", "--json"}));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"lost.csv"}, {"lost.csv", "--fs", "4096"}, {"lost.h5"}}) {
    std::vector<std::string> command = words;
    command.emplace_back("--json");
    const auto outcome = analyze(command);
    EXPECT_NEAR(first_mode_Hz(outcome), whole_Hz, 1e-4) << words.back();
    EXPECT_THAT(outcome.out, HasSubstr(R"("code": "lost_samples")")) << words.back();
    EXPECT_THAT(outcome.out, HasSubstr("hit 1 (3 samples, ")) << words.back();
  }
  const std::string path = file("lost.h5");
  const auto twice =
      run_percuss({"analyze", path, "--fs", "8192", "--band", "120:2000", "--effort", "quick", "--json"});
  EXPECT_NEAR(first_mode_Hz(twice), 2 * whole_Hz, 2e-4) << "the place counts samples";
  EXPECT_THAT(run_percuss({"info", file("lost.csv")}).out, HasSubstr("samples are missing: 3 at 0.2197"));
}

// One message for all: a user cleans the folder up once.
TEST_F(Inputs, NameAllBadFilesOfAFolderAtOnce) {
  test::write_small_test(file("a.h5"), R"("hits": 1)");
  test::write_bytes(file("readme.txt"), "The bat was hung by two cords.\n");
  test::write_bytes(file("bad1.csv"), "t_s,force_N,acc_g\n0,1,2\n");
  const auto one = analyze({"."});
  EXPECT_EQ(one.code, 3);
  EXPECT_THAT(one.err, HasSubstr("fewer than two samples (./bad1.csv: line 2)"));
  for (int i = 2; i <= 7; ++i) test::write_bytes(file("bad" + std::to_string(i) + ".h5"), "\x89HDF\r\n\x1a\n");
  const auto all = analyze({"."});
  EXPECT_EQ(all.code, 3);
  EXPECT_EQ(test::lines_of(all.err).size(), 1U);
  EXPECT_THAT(all.err, testing::StartsWith("percuss: 7 of 9 files cannot be read: bad1.csv: fewer than two samples; "
                                           "bad2.h5: "));
  EXPECT_THAT(all.err, EndsWith("; and 2 more (.); move them elsewhere, or name the others by a pattern\n"));
  EXPECT_THAT(all.err, Not(HasSubstr("readme")));
  EXPECT_THAT(analyze({"a.h5", "bad1.csv", "bad2.h5"}).err, EndsWith("; leave them out\n"));
  EXPECT_EQ(analyze({"a*.h5"}).code, 0);
}

TEST_F(Inputs, AcceptHitsAsRangesAndAll) {
  test::write_small_test(file("bat.h5"), R"("hits": 4)");
  const auto judged = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command{"analyze", "bat.h5", "--json", "--only", "hits"};
    command.insert(command.end(), options.begin(), options.end());
    const auto outcome = run_percuss(command, {.folder = folder_.path()});
    const auto document = test::parse_json(outcome.out);
    std::string accepted;
    for (const auto& hit : document["hits"]) accepted += hit["accepted"] ? "1" : "0";
    return accepted;
  };
  EXPECT_EQ(judged({"--reject-hit", "1-2,4"}), "0010");
  EXPECT_EQ(judged({"--reject-hit", "all", "--accept-hit", "3"}), "0010");
  EXPECT_EQ(judged({"--accept-hit", "ALL"}), "1111");
  for (const char* wrong : {"3-1", "1-", "0-2", "1-99999999999", "-1", "every"}) {
    const auto outcome = run_percuss({"analyze", file("bat.h5"), "--accept-hit", wrong});
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("--accept-hit")) << wrong;
  }
}

// Commands with a band read "--band 60 1500" as 60:1500. "convert" has no band, so its error must not suggest 60:1500.
TEST_F(Inputs, TakeTwoNumbersForABandOfTheChosenCommand) {
  test::write_small_test(file("bat.h5"));
  EXPECT_EQ(run_percuss({"analyze", "--band", "60", "1500", file("bat.h5"), "--only", "hits"}).code, 0);
  const auto outcome = run_percuss({"convert", "--band", "60", "1500"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--band"), Not(HasSubstr("60:1500"))));
}

TEST_F(Inputs, WithoutNamesGetTheCommandThatWorks) {
  test::write_columns(file("plain.csv"), "", {record_.time_s, record_.force_N, record_.accel_mps2});
  test::write_columns(file("ch.csv"), "Time,CH1,CH2", {record_.time_s, record_.accel_mps2, record_.force_N});
  for (const auto& [name, roles] :
       {std::pair<const char*, const char*>{"plain.csv", "--force-channel 2 --accel-channel 3"},
        {"ch.csv", "--force-channel CH2 --accel-channel CH1"}}) {
    const auto outcome = analyze({name, "--json"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(test::lines_of(outcome.err).size(), 1U);
    EXPECT_THAT(outcome.err, EndsWith(std::string(roles) + "\n"));
    EXPECT_NEAR(first_mode_Hz(run_suggestion(outcome.err)), 200, kFrequencyTolerance_Hz) << name;
  }
}

TEST_F(Inputs, WithoutARateSayWhereItGoes) {
  test::write_columns(file("two.csv"), "", {record_.force_N, record_.accel_mps2});
  EXPECT_THAT(analyze({"two.csv"}).err, EndsWith("--force-channel 1 --accel-channel 2 --fs HZ\n"));
}

TEST_F(Inputs, MayHaveTimeStamps) {
  for (const char* date : {"2024-05-06 ", "2024-05-06T", "", "06.05.2024 "}) {
    std::ofstream out(file("stamp.csv"));
    out << "Timestamp,force_N,accel_m_s2\n";
    for (std::size_t i = 0; i < record_.time_s.size(); ++i) {
      out << date << fmt::format("23:59:{:09.6f}", 59.0 + record_.time_s[i]) << ',' << record_.force_N[i] << ','
          << record_.accel_mps2[i] << '\n';
    }
    out.close();
    EXPECT_NEAR(first_mode_Hz(analyze({"stamp.csv", "--json"})), 200, kFrequencyTolerance_Hz) << date;
  }
}

TEST_F(Inputs, OfOtherKindsAreNamedWithTheirCommand) {
  test::write_small_test(file("bat.h5"));
  test::write_bytes(file("a.json"), analyze({"bat.h5", "--json"}).out);
  test::write_bytes(file("s.json"), run_percuss({"certify", "--example"}).out);
  test::write_bytes(file("any.json"), "{\"a\": 1}");
  EXPECT_THAT(analyze({"a.json"}).err, AllOf(HasSubstr("the modes of an analysis"), HasSubstr("percuss compare")));
  ASSERT_EQ(run_percuss({"synth", "wood-bat", "-o", file("wood.h5")}).code, 0);
  EXPECT_THAT(run_percuss({"info", file("wood.truth.json")}).err, HasSubstr("the truth of a synthetic test"));
  EXPECT_THAT(analyze({"s.json"}).err, HasSubstr("percuss certify reads it"));
  EXPECT_THAT(analyze({"any.json"}).err, HasSubstr("not a record of samples, but JSON"));
}

TEST_F(Inputs, OfPowerSpectraAreNamedSo) {
  test::write_bytes(file("psd.csv"), "Frequency (Hz),PSD (g^2/Hz)\n0,1\n1,2\n2,3\n3,1\n");
  EXPECT_THAT(analyze({"psd.csv"}).err, HasSubstr("power spectral density (PSD)"));
  test::MatBuilder(file("psd.mat"), test::MatLevel::v5)
      .numbers("Pxx", {1, 4}, {1, 2, 3, 4})
      .numbers("f", {1, 4}, {0, 1, 2, 3});
  EXPECT_THAT(analyze({"psd.mat"}).err, HasSubstr("Pxx is a power spectral density (PSD)"));
  test::UffText psd{.type = 9, .values = 4, .abscissa = 18};
  test::write_bytes(file("psd.uff"), psd.text("  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00\n"));
  EXPECT_THAT(analyze({"psd.uff"}).err, HasSubstr("power spectral densities (PSD): 1"));
}

TEST_F(Inputs, WithAWrongRateAreDoubted) {
  test::write_columns(file("x.csv"), "force_N,accel_m_s2", {record_.force_N, record_.accel_mps2});
  EXPECT_THAT(analyze({"x.csv", "--fs", "100"}).err, HasSubstr("the sampling rate looks wrong: 100 Hz"));
  EXPECT_THAT(analyze({"x.csv", "--fs", "4096e3"}).err, HasSubstr("the sampling rate looks wrong"));
  EXPECT_THAT(analyze({"x.csv", "--fs", "1500"}).err, HasSubstr("does not fit a sampling rate of 1500 Hz"));
}

TEST_F(Inputs, WithSwappedChannelsAreNamedWithTheirCure) {
  test::write_columns(file("swapped.csv"), "time_s,force,accel", {record_.time_s, record_.accel_mps2, record_.force_N});
  const auto outcome = analyze({"swapped.csv"});
  EXPECT_EQ(outcome.code, 4);
  std::string text = outcome.out;
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_THAT(text, HasSubstr("accel looks like the hammer and force like a response"));
  EXPECT_THAT(text, HasSubstr("--force-channel"));
  EXPECT_NEAR(first_mode_Hz(analyze({"swapped.csv", "--force-channel", "accel", "--accel-channel", "force", "--json"})),
              200, kFrequencyTolerance_Hz);
}

// The remedy, typed as it is printed, works for every format.
TEST_F(Inputs, WithSwappedChannelsAreReadByTheNamesOfTheWarning) {
  test::write_columns(file("swapped.csv"), "force_N,acc_m_s2", {record_.accel_mps2, record_.force_N});
  for (const char* format : {"csv", "h5", "mat", "uff"}) {
    SCOPED_TRACE(format);
    const std::string name = std::string("s.") + format;
    ASSERT_EQ(run_percuss({"convert", file("swapped.csv"), "--fs", "4096", "-o", file(name)}).code, 0);
    const auto channels = test::parse_json(run_percuss({"info", file(name), "--json"}).out)["files"][0]["channels"];
    const std::string force = channels[0]["name"], accel = channels[1]["name"];
    std::string text = analyze({name}).out;
    std::replace(text.begin(), text.end(), '\n', ' ');
    const auto both_blank = [](char before, char after) { return before == ' ' && after == ' '; };
    text.erase(std::unique(text.begin(), text.end(), both_blank), text.end());
    EXPECT_THAT(text, HasSubstr("name " + accel + " as the force, and " + force + " as the acceleration"));
    EXPECT_THAT(text, HasSubstr("--force-unit"));
    EXPECT_NEAR(first_mode_Hz(analyze({name, "--force-channel", accel, "--accel-channel", force, "--force-unit", "N",
                                       "--unit", "m/s^2", "--json"})),
                200, kFrequencyTolerance_Hz);
    test::write_bytes(file("roles.json"), R"([{"name": ")" + accel + R"(", "role": "force", "unit": "N"}, {"name": ")" +
                                              force + R"(", "role": "acceleration", "unit": "m/s^2"}])");
    EXPECT_NEAR(first_mode_Hz(analyze({name, "--setup", file("roles.json"), "--json"})), 200, kFrequencyTolerance_Hz);
  }
}

TEST_F(Inputs, ShowTheHammerInTheirSamples) {
  std::vector<double> mass;
  for (const double force : record_.force_N) mass.push_back(force / 2);
  test::write_columns(file("mass.csv"), "time_s,force_N,accel_m_s2", {record_.time_s, record_.force_N, mass});
  test::write_columns(file("swapped.csv"), "time_s,force,accel", {record_.time_s, record_.accel_mps2, record_.force_N});
  const auto hammers = [&](const char* name) {
    const auto document = test::parse_json(run_percuss({"info", file(name), "--json"}).out);
    std::string found;
    for (const auto& channel : document["files"][0]["channels"]) found += channel["hammer"] ? "1" : "0";
    return found;
  };
  EXPECT_EQ(hammers("mass.csv"), "10") << "a free mass moves as the force does";
  EXPECT_EQ(hammers("swapped.csv"), "01");
  EXPECT_THAT(run_percuss({"info", file("swapped.csv")}).out, HasSubstr("accel looks like a hammer's pulses"));
  EXPECT_THAT(run_percuss({"info", file("mass.csv")}).out, Not(HasSubstr("looks like a hammer's pulses")));
}

TEST_F(Inputs, WithAReversedSensorAreNamedWithTheirCure) {
  std::string modes;
  for (int i = 1; i <= 5; ++i)
    modes += fmt::format(R"({}{{"frequency_hz": {}, "damping_ratio": 0.005, "residue_per_kg": [{}, {}]}})",
                         i > 1 ? ", " : "", 150 * i, 0.1 * i, -0.1 * i - 0.01);
  test::write_bytes(
      file("spec.json"),
      R"({"schema": "percuss/synth/1", "fs_hz": 4096, "duration_s": 1, "hits": 2, "band_hz": [60, 1000], "modes": [)" +
          modes +
          R"(], "structure": {"rigid_line_per_kg": [0.1, -0.1]},
                           "pulse": {"kind": "haversine", "width_s": 0.0005, "peak_n": 300},
                           "sensors": [{"position_m": 0.05}, {"position_m": 0.06}]})");
  ASSERT_EQ(run_percuss({"synth", file("spec.json"), "-o", file("rev.h5")}).code, 0);
  std::string text = analyze({"rev.h5", "--angle", "0,0"}).out;
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_THAT(text, HasSubstr("accel 2 moves against accel 1 in each of 5 modes"));
  EXPECT_THAT(text, HasSubstr("(--setup, --accel-scale)"));
  EXPECT_THAT(analyze({"rev.h5", "--angle", "0,0", "--accel-scale", "1,-1"}).out, Not(HasSubstr("moves against")));
}

TEST_F(Inputs, MayComeThroughAPipe) {
  test::write_columns(file("x.csv"), "time_s,force_N,accel_m_s2",
                      {record_.time_s, record_.force_N, record_.accel_mps2});
  for (const char* kind : {"x.wav", "x.mat", "x.h5"}) {
    ASSERT_EQ(run_percuss({"convert", file("x.csv"), file(kind), "--force"}).code, 0);
    const auto outcome = analyze({"-", "--json"}, file(kind));
    EXPECT_NEAR(first_mode_Hz(outcome), 200, kFrequencyTolerance_Hz) << kind;
    EXPECT_EQ(test::parse_json(outcome.out)["inputs"][0]["path"], "-");
  }
}

}  // namespace percuss::inputs_test
