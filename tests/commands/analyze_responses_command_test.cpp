#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/files/csv_columns.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/ping_file.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// percuss analyze of a microphone or of accelerometers alone.
namespace percuss::analyze_responses_command_test {

using nlohmann::json;
using test::run_percuss;
using testing::HasSubstr;
using testing::IsEmpty;

class AnalyzeResponses : public testing::Test {
 protected:
  AnalyzeResponses() { test::write_bytes(folder_.file("ping.wav"), test::wav_of(test::ping(1e-3))); }
  test::ScratchFolder folder_;
};

TEST_F(AnalyzeResponses, FindsTheModesOfAPing) {
  const auto outcome = run_percuss({"analyze", folder_.file("ping.wav"), "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = test::parse_json(outcome.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
  EXPECT_EQ(document["input"], "response");
  EXPECT_EQ(document["excitation"], "unknown");
  ASSERT_EQ(document["hits"].size(), 1U);
  EXPECT_NEAR(document["hits"][0]["time_s"].get<double>(), test::kBlow_s, 1e-3);
  ASSERT_EQ(document["modes"].size(), test::kPing.size());
  for (std::size_t m = 0; m < test::kPing.size(); ++m) {
    const json& mode = document["modes"][m];
    EXPECT_GT(mode["frequency_std_hz"].get<double>(), 0);
    // The pole's frequency is the undamped one.
    const double true_Hz =
        test::kPing[m].freq_Hz * std::sqrt(1 + test::kPing[m].damping_ratio * test::kPing[m].damping_ratio);
    EXPECT_NEAR(mode["frequency_hz"].get<double>(), true_Hz, 4 * mode["frequency_std_hz"].get<double>()) << m;
    EXPECT_NEAR(mode["damping_ratio"].get<double>(), test::kPing[m].damping_ratio,
                4 * mode["damping_ratio_std"].get<double>());
    EXPECT_LT(mode["frequency_std_hz"].get<double>(), 0.1);  // the fit may begin some ms late
  }
}

TEST_F(AnalyzeResponses, SaysWhatNeedsAForceAndWritesFiles) {
  const auto outcome =
      run_percuss({"analyze", "ping.wav", "-o", "m.csv", "-o", "m.html", "-o", "m.json"}, {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no force was recorded"));
  EXPECT_THAT(outcome.out, HasSubstr("±"));
  EXPECT_EQ(test::lines_of(test::bytes_of(folder_.file("m.csv"))).size(), 1 + test::kPing.size());
  EXPECT_THAT(test::bytes_of(folder_.file("m.html")), HasSubstr("1732"));
}

// Picture and page show the spectrum of the decays and its fit. The page has one section "Provenance".
TEST_F(AnalyzeResponses, DrawsTheDecaysWithTheirFit) {
  const auto outcome = run_percuss({"analyze", "ping.wav", "-o", "m.svg", "-o", "m.html"}, {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"m.svg", "m.html"}) {
    EXPECT_THAT(test::bytes_of(folder_.file(file)),
                testing::AllOf(HasSubstr("Free decays of "), HasSubstr("measured"), HasSubstr("fit")));
  }
  const std::string page = test::bytes_of(folder_.file("m.html"));
  const std::size_t heading = page.find(">Provenance</h2>");
  ASSERT_NE(heading, std::string::npos);
  EXPECT_EQ(page.find(">Provenance</h2>", heading + 1), std::string::npos);
}

// A microphone measures a pressure. It shows the modes, but gives no deflection and no FRF in percuss's units.
TEST_F(AnalyzeResponses, TakesSoundPressures) {
  const auto document_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "analyze");
    arguments.emplace_back("--json");
    const auto outcome = run_percuss(arguments, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty());
    return document;
  };
  const json pressure = document_of({"ping.wav", "--unit", "Pa"}), milli = document_of({"ping.wav", "--unit", "mPa"});
  EXPECT_EQ(pressure["decay"]["unit"], "Pa");
  EXPECT_EQ(document_of({"ping.wav", "--unit", "g"})["decay"]["unit"], "m/s^2");
  const double amplitude_Pa = pressure["modes"][0]["hit_amplitudes"][0]["re"];
  EXPECT_NEAR(milli["modes"][0]["hit_amplitudes"][0]["re"].get<double>(), 1e-3 * amplitude_Pa, 1e-9);
  std::string text = "mic1_Pa,mic2_Pa\n", with_force = "force_N,mic1_Pa\n";
  for (const double x : test::ping(1e-3)) {
    text += std::to_string(x) + "," + std::to_string(0.5 * x) + "\n";
    with_force += "0," + std::to_string(x) + "\n";
  }
  test::write_bytes(folder_.file("mics.csv"), text);
  test::write_bytes(folder_.file("force.csv"), with_force);
  const json both = document_of({"mics.csv", "--fs", "44100"});
  EXPECT_EQ(both["decay"]["unit"], "Pa");
  EXPECT_EQ(both["modes"][0]["residues"].size(), 2U);
  EXPECT_THAT(test::rejection_of({"deflect", folder_.file("mics.csv"), "--fs", "44100"}, {".json"}, "mics.csv"),
              HasSubstr("has no deflection"));
  EXPECT_THAT(run_percuss({"analyze", folder_.file("force.csv"), "--fs", "44100", "--accel-channel", "mic1_Pa"}).err,
              HasSubstr("measures a pressure, not an acceleration"));
}

// Volts and a sensitivity in mV/Pa, as an option or in a set-up, give the same pressures as a record in Pa. The
// option also gives pressures for a sound file, which a sandbox decodes.
TEST_F(AnalyzeResponses, TakesSensitivitiesOfMicrophones) {
  std::string pascals = "mic_Pa\n", volts = "mic_V\n";
  for (const double x : test::ping(1e-3)) {
    pascals += std::to_string(x) + "\n";
    volts += std::to_string(0.05 * x) + "\n";
  }
  test::write_bytes(folder_.file("pa.csv"), pascals);
  test::write_bytes(folder_.file("volts.csv"), volts);
  test::write_bytes(folder_.file("setup.json"),
                    R"([{"name": "mic_V", "role": "acceleration", "sensitivity": 50, "sensitivity_unit": "mV/Pa"}])");
  const auto document_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "analyze");
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    const auto outcome = run_percuss(arguments, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return test::parse_json(outcome.out);
  };
  const json expected = document_of({"pa.csv", "--fs", "44100"});
  ASSERT_EQ(expected["decay"]["unit"], "Pa");
  const double amplitude_Pa = expected["modes"][0]["hit_amplitudes"][0]["re"];
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"volts.csv", "--fs", "44100", "--pressure-sensitivity", "50"},
                                             {"volts.csv", "--fs", "44100", "--setup", "setup.json"}}) {
    const json found = document_of(words);
    EXPECT_EQ(found["decay"]["unit"], "Pa");
    // The texts hold six decimals.
    EXPECT_NEAR(found["modes"][0]["hit_amplitudes"][0]["re"].get<double>(), amplitude_Pa,
                1e-4 * std::abs(amplitude_Pa));
  }
  const json sound = document_of({"ping.wav", "--pressure-sensitivity", "50"});  // full scale taken as 1 V
  EXPECT_EQ(sound["decay"]["unit"], "Pa");
  EXPECT_EQ(document_of({"ping.wav", "--accel-sensitivity", "50"})["decay"]["unit"], "m/s^2");
  EXPECT_THAT(
      test::rejection_of({"deflect", folder_.file("volts.csv"), "--fs", "44100", "--pressure-sensitivity", "50"},
                         {".json"}, "volts.csv"),
      HasSubstr("has no deflection"));
}

// The table of several tests names the test of each mode. A test with fewer channels leaves fields empty.
TEST_F(AnalyzeResponses, WritesATableOfSeveralTests) {
  std::string two = "mic1_Pa,mic2_Pa\n";
  for (const double x : test::ping(1e-3)) two += std::to_string(x) + "," + std::to_string(0.5 * x) + "\n";
  test::write_bytes(folder_.file("two.csv"), two);
  const auto outcome = run_percuss(
      {"analyze", "two.csv", "ping.wav", "--fs", "44100", "--files", "tests", "-o", "m.csv", "-o", "m.json"},
      {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto table = test::csv_columns(folder_.file("m.csv"));
  const json runs = test::parse_json(test::bytes_of(folder_.file("m.json")))["runs"];
  ASSERT_EQ(runs.size(), 2U);
  std::size_t row = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const json& modes = runs[run]["modes"];
    ASSERT_GE(table["test"].size(), row + modes.size());
    for (std::size_t m = 0; m < modes.size(); ++m, ++row) {
      EXPECT_EQ(table["test"][row], static_cast<double>(run));
      EXPECT_EQ(table["mode"][row], static_cast<double>(m));
      EXPECT_EQ(table["frequency_hz"][row], modes[m]["frequency_hz"].get<double>());
      EXPECT_EQ(std::isnan(table["channel_1_re"][row]), run == 1);
    }
  }
  EXPECT_EQ(table["test"].size(), row);
  EXPECT_GE(row, 2 * test::kPing.size());
}

// --modes-file writes the same table as for a test with a force: a row per mode, point and channel.
TEST_F(AnalyzeResponses, WritesTheModesThatAreAskedFor) {
  const auto outcome = run_percuss(
      {"analyze", "ping.wav", "--modes-file", "found.csv", "-o", "ping.modes.csv", "-o", "m.json", "--quiet"},
      {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string bytes = test::bytes_of(folder_.file("found.csv"));
  EXPECT_EQ(test::lines_of(bytes).front(),
            "mode,frequency_hz,frequency_std_hz,damping_ratio,damping_ratio_std,family,order,point,channel,residue_re,"
            "residue_im,residue_std");
  EXPECT_EQ(test::bytes_of(folder_.file("ping.modes.csv")), bytes);
  auto table = test::csv_columns(folder_.file("found.csv"));
  const json modes = test::parse_json(test::bytes_of(folder_.file("m.json")))["modes"];
  ASSERT_EQ(table["mode"].size(), test::kPing.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    EXPECT_EQ(table["frequency_hz"][m], modes[m]["frequency_hz"].get<double>());
    EXPECT_EQ(table["channel"][m], 0);
    EXPECT_EQ(table["residue_re"][m], modes[m]["residues"][0]["re"].get<double>());
  }
  const auto shapes = run_percuss({"analyze", "ping.wav", "--modes-file", "m.uff"}, {.folder = folder_.path()});
  EXPECT_EQ(shapes.code, 2);
  EXPECT_THAT(shapes.err, HasSubstr("--modes-file needs a force"));
  const auto both = run_percuss(
      {"analyze", "ping.wav", "--modes-file", "again.csv", "--modes-file", "again.json", "-o", "o.json", "--quiet"},
      {.folder = folder_.path()});
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_EQ(test::bytes_of(folder_.file("again.csv")), bytes);
  EXPECT_EQ(test::bytes_of(folder_.file("again.json")), test::bytes_of(folder_.file("o.json")));
}

// A recording of a dead microphone, and one without a blow.
TEST_F(AnalyzeResponses, SaysWhyThereIsNoResult) {
  test::write_bytes(folder_.file("dead.wav"), test::wav_of(std::vector<double>(44100, 0.25)));
  std::vector<double> noise = test::ping(1e-2);
  noise.resize(static_cast<std::size_t>(0.2 * 44100));
  test::write_bytes(folder_.file("noise.wav"), test::wav_of(noise));
  const auto dead = run_percuss({"analyze", folder_.file("dead.wav")});
  EXPECT_EQ(dead.code, 4);
  EXPECT_THAT(dead.out, HasSubstr("! channel 1 is constant"));
  EXPECT_THAT(dead.out, testing::Not(HasSubstr("verdict"))) << "an empty table of hits";
  EXPECT_THAT(dead.out, testing::Not(HasSubstr("record longer")));
  const auto blow = run_percuss({"analyze", folder_.file("noise.wav")});
  EXPECT_EQ(blow.code, 4);
  EXPECT_THAT(blow.out, HasSubstr("no impact found"));
  EXPECT_THAT(blow.out, HasSubstr("! no impact was found: no signal rises above the noise"));
  EXPECT_THAT(blow.out, testing::Not(HasSubstr("1 impact")));
  for (const char* file : {"dead.wav", "noise.wav"}) {
    const auto outcome = run_percuss({"analyze", folder_.file(file), "--json"});
    EXPECT_EQ(outcome.code, 4) << file;
    const json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty()) << file;
    EXPECT_THAT(document["modes"], IsEmpty()) << file;
    for (const json& hit : document["hits"]) EXPECT_FALSE(hit["accepted"]) << file;
  }
}

// One plain line in place of the notes on units and scales, which no result needs.
TEST_F(AnalyzeResponses, AsksForNoScale) {
  const auto outcome = run_percuss({"analyze", folder_.file("ping.wav"), "--json"});
  std::vector<std::string> said;
  const json document = test::parse_json(outcome.out);
  for (const json& warning : document["warnings"]) {
    if (warning["code"] != "input") continue;
    said.push_back(warning["message"]);
    EXPECT_EQ(warning["severity"], "info");
  }
  EXPECT_THAT(said,
              testing::ElementsAre("no unit is stated, so amplitudes are relative. Frequencies and damping ratios "
                                   "do not depend on it"));
}

TEST_F(AnalyzeResponses, ReportsTheChosenSections) {
  const auto document_of = [&](const std::string& section) {
    const auto outcome = run_percuss({"analyze", folder_.file("ping.wav"), "--only", section, "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json document = test::parse_json(outcome.out);
    EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), IsEmpty()) << section;
    return document;
  };
  const json hits = document_of("hits"), modes = document_of("modes"), classes = document_of("classes");
  EXPECT_EQ(hits["hits"].size(), 1U);
  EXPECT_FALSE(hits.contains("modes"));
  EXPECT_FALSE(hits.contains("decay"));
  for (const json* document : {&modes, &classes}) {
    EXPECT_FALSE(document->contains("hits"));
    EXPECT_EQ((*document)["modes"].size(), test::kPing.size());
  }
  EXPECT_FALSE(modes["modes"][0].contains("family"));
  EXPECT_EQ(classes["modes"][0]["family"], "unknown");
  const auto text_of = [&](const std::string& section) {
    return run_percuss({"analyze", folder_.file("ping.wav"), "--only", section}).out;
  };
  EXPECT_THAT(text_of("hits"), testing::AllOf(HasSubstr("verdict"), testing::Not(HasSubstr("damping  note"))));
  EXPECT_THAT(text_of("modes"), testing::AllOf(HasSubstr("damping  note"), testing::Not(HasSubstr("verdict"))));
  // A table needs the modes, whatever the printed sections.
  const auto table = run_percuss({"analyze", "ping.wav", "--only", "hits", "-o", "t.csv", "-o", "t.modes.csv"},
                                 {.folder = folder_.path()});
  EXPECT_EQ(table.code, 0) << table.err;
  for (const char* file : {"t.csv", "t.modes.csv"})
    EXPECT_EQ(test::lines_of(test::bytes_of(folder_.file(file))).size(), 1 + test::kPing.size()) << file;
}

// Two microphones are no accelerometers on a tube.
TEST_F(AnalyzeResponses, NamesNoBendingOfPressures) {
  std::string text = "mic1_Pa,mic2_Pa\n", other = "a,b\n";
  for (const double x : test::ping(1e-3)) {
    text += std::to_string(x) + "," + std::to_string(0.8 * x) + "\n";
    other += std::to_string(x) + "," + std::to_string(0.8 * x) + "\n";
  }
  test::write_bytes(folder_.file("mics.csv"), text);
  test::write_bytes(folder_.file("other.csv"), other);
  const auto named = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "analyze");
    arguments.insert(arguments.end(), {"--fs", "44100", "--band", "500:6000"});
    const auto outcome = run_percuss(arguments, {.folder = folder_.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out.find("bending") != std::string::npos;
  };
  EXPECT_FALSE(named({"mics.csv"}));
  EXPECT_FALSE(named({"other.csv", "--accel-channel", "1,2", "--unit", "Pa"}));
  EXPECT_TRUE(named({"other.csv", "--accel-channel", "1,2"}));
}

// Files of different parts are no hits of one part.
TEST_F(AnalyzeResponses, SeparatesFilesOfDifferentParts) {
  test::write_bytes(folder_.file("part2.wav"), test::wav_of(test::ping(1e-3, 1.01)));
  test::write_bytes(folder_.file("again.wav"), test::wav_of(test::ping(1e-3)));
  const auto outcome =
      run_percuss({"analyze", "ping.wav", "part2.wav", "--band", "500:6000", "-o", "m.modes.csv", "-o", "m.json"},
                  {.folder = folder_.path()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Each file is a test of its own"));
  const json document = test::parse_json(test::bytes_of(folder_.file("m.json")));
  ASSERT_EQ(document["runs"].size(), 2U);
  for (const json& run : document["runs"]) {
    EXPECT_EQ(run["modes"].size(), test::kPing.size());
    EXPECT_EQ(run["warnings"][0]["code"], "files_disagree");
  }
  const auto lines = test::lines_of(test::bytes_of(folder_.file("m.modes.csv")));
  ASSERT_EQ(lines.size(), 1 + 2 * test::kPing.size());
  EXPECT_TRUE(lines[0].ends_with(",residue_std,file"));
  EXPECT_TRUE(lines[1].ends_with(",ping.wav"));
  EXPECT_TRUE(lines.back().ends_with(",part2.wav"));
  const auto one =
      run_percuss({"analyze", "ping.wav", "again.wav", "--band", "500:6000", "--json"}, {.folder = folder_.path()});
  const json joined = test::parse_json(one.out);
  EXPECT_FALSE(joined.contains("runs"));
  EXPECT_EQ(joined["hits"].size(), 2U);
  EXPECT_EQ(joined["modes"].size(), test::kPing.size());
}

TEST_F(AnalyzeResponses, RefusesWhatNeedsAForce) {
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--estimator", "h2"},
                                                                                    {"--only", "frf"},
                                                                                    {"--per-hit"},
                                                                                    {"--delay", "auto"},
                                                                                    {"--frf", folder_.file("f.csv")}}) {
    std::vector<std::string> arguments{"analyze", folder_.file("ping.wav")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_percuss(arguments).code, 2) << more.front();
  }
  EXPECT_THAT(test::rejection_of({"analyze", folder_.file("ping.wav")}, {".json", ".h5"}, "ping.wav"),
              HasSubstr("without a force channel"));
}

TEST_F(AnalyzeResponses, CompareWithADocument) {
  ASSERT_EQ(run_percuss({"analyze", folder_.file("ping.wav"), "-o", folder_.file("a.json"), "--quiet"}).code, 0);
  const auto outcome = run_percuss({"analyze", folder_.file("ping.wav"), "--compare", folder_.file("a.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("(0.00 ppm, 0.0 σ)"));
}

TEST_F(AnalyzeResponses, RefuseHitsThatDoNotExist) {
  EXPECT_THAT(test::rejection_of({"analyze", folder_.file("ping.wav"), "--reject-hit", "9"}, {".json"}, "ping.wav"),
              HasSubstr("there is no hit 9"));
}

TEST_F(AnalyzeResponses, RefusesFilesWithoutAForceBesideOthers) {
  ASSERT_EQ(run_percuss({"synth", "wood-bat", "-o", folder_.file("bat.h5"), "--quiet"}).code, 0);
  for (const auto& [first, second] : {std::pair{"ping.wav", "bat.h5"}, std::pair{"bat.h5", "ping.wav"}}) {
    test::rejection_of({"analyze", folder_.file(first), folder_.file(second), "--files", "tests"}, {".json"},
                       "ping.wav");
  }
}

TEST_F(AnalyzeResponses, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto one = run_percuss({"analyze", folder_.file("ping.wav"), "--json", "--threads", "1"});
  const auto two = run_percuss({"analyze", folder_.file("ping.wav"), "--json", "--threads", "2"});
  EXPECT_EQ(one.out, two.out);
}

}  // namespace percuss::analyze_responses_command_test
