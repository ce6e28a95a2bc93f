#include <gtest/gtest.h>

#include "support/files/synthetic_files.hpp"
#include "support/json_schema.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_records.hpp"

// Options take numbers with a unit.
namespace percuss::option_units_test {

using test::run_percuss;

nlohmann::json document_of(std::vector<std::string> words) {
  words.emplace_back("--json");
  const auto outcome = run_percuss(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.code == 0 ? test::parse_json(outcome.out) : nlohmann::json();
}

TEST(OptionUnits, ConvertToTheUnitOfTheOption) {
  const auto si =
      document_of({"model", "rigid", "--ball-speed", "60.79744", "--bat-mass", "0.85048569375", "--at", "0:0.1:0.2"});
  const auto lab = document_of({"model", "rigid", "--ball-speed", "136mph", "--bat-mass", "30oz", "--at", "0:0.1:0.2"});
  ASSERT_EQ(si["curve"].size(), lab["curve"].size());
  EXPECT_NEAR(si["best"]["exit_speed_mps"].get<double>(), lab["best"]["exit_speed_mps"].get<double>(), 1e-9);
  const auto inches = document_of({"metrics", "--length-in", "34", "--weight-oz", "31"});
  const auto metric = document_of({"metrics", "--length-in", "86.36 cm", "--weight-oz", "878.835216875g"});
  EXPECT_NEAR(inches["drop"].get<double>(), metric["drop"].get<double>(), 1e-9);
  EXPECT_EQ(document_of({"metrics", "--length-in", "34in", "--weight-oz", "31oz"})["drop"], inches["drop"]);
}

TEST(OptionUnits, HoldForEachValueOfAListAndForARange) {
  const auto rings = document_of({"metrics", "--diameter-in", "63.5mm,2.5,6.35 cm"})["profile"]["rings"];
  for (const auto& ring : rings) EXPECT_NEAR(ring["diameter_in"].get<double>(), 2.5, 1e-12);
  EXPECT_EQ(rings.size(), 3U);
  const auto in = document_of({"model", "rigid", "--at", "0:1:12in"})["curve"];
  const auto m = document_of({"model", "rigid", "--at", "0:0.0254:0.3048"})["curve"];
  ASSERT_EQ(in.size(), m.size());
  for (std::size_t i = 0; i < m.size(); ++i) EXPECT_NEAR(in[i]["z_m"].get<double>(), m[i]["z_m"].get<double>(), 1e-12);
  const auto sweep =
      document_of({"model", "impact", "--sweep", "at=10:5:20in", "--sweep", "speed=10:10:20mph"})["sweep"];
  ASSERT_EQ(sweep.size(), 5U);
  EXPECT_NEAR(sweep[0]["at"].get<double>(), 0.254, 1e-12);
  EXPECT_NEAR(sweep[4]["speed"].get<double>(), 20 * 0.44704, 1e-12);
  const std::vector<std::string> pendulum{"metrics", "--length-in", "34",         "--weight-oz", "31",
                                          "--cg-in", "12.5",        "--period-s", "1.42"};
  std::vector<std::string> standard = pendulum, inches = pendulum;
  standard.insert(standard.end(), {"--gravity-in-s2", "9.80665 m/s2"});
  inches.insert(inches.end(), {"--gravity-in-s2", "386.08858267716535"});
  EXPECT_NEAR(document_of(standard)["moi_oz_in2"].get<double>(), document_of(inches)["moi_oz_in2"].get<double>(), 1e-8);
}

TEST(OptionUnits, HoldForTheBand) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  const auto band = [&](const std::string& text) {
    return document_of({"analyze", folder.file("bat.h5"), "--band", text, "--effort", "quick"})["modes"];
  };
  const auto modes = band("60:1000");
  EXPECT_FALSE(modes.empty());
  EXPECT_EQ(band("60Hz:1kHz"), modes);
  EXPECT_EQ(band("60:1 kHz"), modes);
}

TEST(OptionUnits, HoldForFrequencies) {
  const test::ScratchFolder folder;
  const test::SmallRecord small = test::small_record();
  test::write_columns(folder.file("n.csv"), "force (N),acc (m/s^2)", {small.force_N, small.accel_mps2});
  const auto rate_Hz = [&](const std::string& fs) {
    return document_of({"info", folder.file("n.csv"), "--fs", fs})["files"][0]["fs_hz"].get<double>();
  };
  EXPECT_EQ(rate_Hz("10.24kHz"), 10240);
  EXPECT_EQ(rate_Hz("1.001 KHZ"), 1001) << "1.001 times 1000 is 1000.9999999999999 in doubles";
  EXPECT_EQ(rate_Hz("0.1MHz"), 100000);
  EXPECT_EQ(rate_Hz("10240hz"), 10240);
  for (const char* const other : {"10mHz", "10m", "10s"}) {
    EXPECT_NE(run_percuss({"info", folder.file("n.csv"), "--fs", other}).code, 0) << other;
  }
}

TEST(OptionUnits, HoldForSensitivities) {
  const test::ScratchFolder folder;
  const test::SmallRecord small = test::small_record();
  test::write_columns(folder.file("v.csv"), "time_s,hammer (V),acc (V)",
                      {small.time_s, small.force_N, small.accel_mps2});
  const auto amplitudes = [&](const std::string& force, const std::string& accel) {
    return document_of({"info", folder.file("v.csv"), "--force-sensitivity", force, "--accel-sensitivity",
                        accel})["files"][0]["channels"];
  };
  const auto plain = amplitudes("2.25", "98.0665");
  EXPECT_EQ(amplitudes("2.25mV/N", "98.0665 mV/g"), plain);
  for (std::size_t c = 0; c < plain.size(); ++c) {
    const double expected = plain[c]["to_si"].get<double>();
    const double found = amplitudes("0.00225V/N", "10mV/(m/s^2)")[c]["to_si"].get<double>();
    EXPECT_NEAR(found / expected, 1, 1e-12) << c;
  }
  EXPECT_EQ(run_percuss({"info", folder.file("v.csv"), "--accel-sensitivity", "100mV/N"}).code, 2);
}

TEST(OptionUnits, HoldForTheSpeedsOfMeasuredCcor) {
  const auto of_speeds = [](const std::string& speeds) {
    return document_of({"model", "trampoline", "--hoop", "1000:500:2000", "--hold", "a=0.6495", "--fit-ccor", speeds});
  };
  const auto mph = of_speeds("60mph:0.519:0.004,100mph:0.497:0.004");
  const auto si = of_speeds("26.8224:0.519:0.004,44.704:0.497:0.004");
  EXPECT_NEAR(mph["fit"]["b"].get<double>(), si["fit"]["b"].get<double>(), 1e-9);
}

TEST(OptionUnits, RefuseUnitsOfAnotherKindAndValuesOutsideTheLimits) {
  for (const char* length : {"34kg", "34 furlongs", "-34cm", "cm", "34in ch", "in2"})
    EXPECT_EQ(run_percuss({"metrics", "--length-in", length}).code, 2) << length;
  for (const char* range : {"0:1:12kg", "0:1:12 furlongs", "0in:1in:12in"})
    EXPECT_EQ(run_percuss({"model", "rigid", "--at", range}).code, 2) << range;
  for (const char* hoop : {"100:100:1000in", "1000:500:2000.0.5", "100:100:300d1", "100:100:1000 "})
    EXPECT_EQ(run_percuss({"model", "trampoline", "--hoop", hoop}).code, 2) << hoop;
}

}  // namespace percuss::option_units_test
