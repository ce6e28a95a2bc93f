#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"
#include "synth/truth_json.hpp"

namespace percuss::synth::spec_test {

using testing::AllOf;
using testing::HasSubstr;

const std::string kStart = R"({"fs_hz": 1000, "samples": 1000)";

std::string refusal(const std::string& text) {
  return test::input_error_of([&] { parse_synth_spec(text, "spec.json"); });
}

// As refusal(), of a spec with these further keys.
std::string refusal_with(const std::string& keys) { return refusal(kStart + ", " + keys + "}"); }

TEST(SynthSpec, ReadsEveryKey) {
  const SynthSpec spec = parse_synth_spec(synth_example(), "example");
  EXPECT_EQ(spec.samples, 25600U);
  EXPECT_EQ(spec.modes[1].type, SynthModeType::hoop);
  EXPECT_DOUBLE_EQ(spec.modes[1].angle_rad, 12 * std::numbers::pi / 180);
  EXPECT_EQ(spec.modes[2].residue_per_kg, (std::vector{0.8, -0.8}));
  EXPECT_EQ(spec.sensors[1].sign, -1);
  EXPECT_DOUBLE_EQ(spec.points[0].position_m, 0.1524);
  EXPECT_EQ(spec.faults[0].kind, SynthFaultKind::double_hit);
  EXPECT_EQ(spec.recorder.bits, 24);
  EXPECT_DOUBLE_EQ(*spec.recorder.force_clip_N, 1000);
}

TEST(SynthSpec, NamesAnUnknownKey) {
  EXPECT_THAT(refusal_with(R"("modes": [], "sampels": 3)"),
              AllOf(HasSubstr("unknown key"), HasSubstr("sampels"), HasSubstr("spec.json")));
  EXPECT_THAT(refusal_with(R"("modes": [{"frequency_hz": 10, "damping_ratio": 0.1, "zeta": 1}])"),
              HasSubstr("modes[0].zeta"));
  EXPECT_THAT(refusal_with(R"("modes": [], "faults": [{"hit": 0, "kind": "missing", "ratio": 1}])"),
              HasSubstr("faults[0].ratio"));
}

TEST(SynthSpec, RefusesImpossibleValues) {
  EXPECT_THAT(refusal(R"({"fs_hz": 1e300, "samples": 1000, "modes": []})"), HasSubstr("fs_hz"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1000, "samples": 1e12, "modes": []})"), HasSubstr("samples"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1000, "samples": -1, "modes": []})"), HasSubstr("samples"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1000, "duration_s": 1e300, "modes": []})"), HasSubstr("duration_s"));
  EXPECT_THAT(refusal_with(R"("modes": [{"frequency_hz": 10, "damping_ratio": 0.1, "order": 1000001}])"),
              AllOf(HasSubstr("1000001 is out of range"), HasSubstr("give at most 1000000")));
  EXPECT_THAT(refusal(R"({"fs_hz": 1e999, "samples": 1000, "modes": []})"), HasSubstr("too large"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1000, "samples": 1e6, "modes": [], "hits": 10000})"), HasSubstr("would hold"));
  EXPECT_THAT(refusal_with(R"("modes": [], "hits": 18446744073709551615)"), HasSubstr("hits"));
  EXPECT_THAT(refusal_with(R"("modes": [{"frequency_hz": 10, "damping_ratio": 1.5}])"),
              HasSubstr("modes[0].damping_ratio"));
  EXPECT_THAT(refusal_with(R"("modes": [{"frequency_hz": 1e9, "damping_ratio": 0.01}])"),
              HasSubstr("modes[0].frequency_hz"));
  EXPECT_THAT(refusal_with(R"("modes": [], "pulse": {"width_s": 1e9})"), HasSubstr("pulse.width_s"));
  EXPECT_THAT(refusal_with(R"("modes": [], "impact": [])"), HasSubstr("impact"));
  EXPECT_THAT(refusal_with(R"("modes": [], "sensors": [{"sign": 0.5}])"), HasSubstr("sensors[0].sign"));
  EXPECT_THAT(refusal_with(R"("modes": [], "faults": [{"hit": 5, "kind": "missing"}])"), HasSubstr("faults[0].hit"));
  EXPECT_THAT(refusal_with(R"("modes": [], "layout": "spiral")"),
              AllOf(HasSubstr("layout"), HasSubstr("rows, continuous")));
  EXPECT_THAT(refusal_with(R"("modes": [], "hit_times_s": [0.1])"), HasSubstr("hit_times_s"));
}

TEST(SynthSpec, RefusesOtherDocuments) {
  EXPECT_THAT(refusal(""), HasSubstr("not JSON"));
  EXPECT_THAT(refusal("[]"), HasSubstr("not an object"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1)"), AllOf(HasSubstr("not JSON"), HasSubstr("byte")));
  EXPECT_THAT(refusal(std::string(100000, '[')), HasSubstr("nested"));
  EXPECT_THAT(refusal(std::string(5 << 20, ' ')), HasSubstr("4 MiB"));
  EXPECT_THAT(refusal(R"({"fs_hz": 1, "fs_hz": 2})"), HasSubstr("given twice"));
  EXPECT_THAT(refusal(R"({"schema": "percuss/analysis/1"})"), HasSubstr("schema"));
  EXPECT_THAT(refusal_with(R"("modes": 3)"), HasSubstr("modes"));
  EXPECT_THAT(refusal("{}"), HasSubstr("fs_hz"));
}

TEST(SynthSpec, IsCheckedWhenBuiltByHand) {
  SynthSpec spec;
  spec.fs_Hz = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(synthesise(spec), InputError);
  const SynthSpec empty{};  // a temporary would be "maybe uninitialized" to g++ 12
  spec = empty;
  spec.modes = {{.freq_Hz = 100, .damping_ratio = 0.01, .residue_per_kg = {1, 2, 3}}};
  EXPECT_THROW(synthesise(spec), InputError);
}

TEST(Presets, AreTheFixturesOfTheSourceTree) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PERCUSS_SOURCE_DIR "/fixtures")) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const SynthSpec spec = parse_synth_spec(text.str(), entry.path().string());
    EXPECT_EQ(spec.name, entry.path().stem());
    EXPECT_EQ(synth_preset(spec.name).description, spec.description);
    EXPECT_FALSE(spec.description.empty());
  }
  EXPECT_EQ(files, synth_presets().size());
  EXPECT_GE(files, 11U);
}

TEST(Presets, AreListedWhenTheNameIsWrong) {
  EXPECT_THAT(test::input_error_of([] { synth_preset("steel-bat"); }),
              AllOf(HasSubstr("steel-bat"), HasSubstr("wood-bat"), HasSubstr("composite-bat")));
}

TEST(TruthDocument, HoldsTheTrueModes) {
  const SyntheticTest test = synthesise(synth_preset("composite-bat"));
  const auto truth = test::parse_json(truth_json(test.truth));
  EXPECT_EQ(truth["schema"], "percuss/synth-truth/1");
  EXPECT_EQ(truth["f_hz"].size(), 6U);
  EXPECT_EQ(truth["kind"][3], "hoop");
  EXPECT_EQ(truth["kind"][0], "bend");
  EXPECT_EQ(truth["A"].size(), 2U);
  EXPECT_EQ(truth["A"][1].size(), 6U);
  EXPECT_EQ(truth["rb"].size(), 2U);
  EXPECT_EQ(truth["hits"].size(), 5U);
  EXPECT_EQ(truth["crlb"]["zeta_std_pct"].size(), 6U);
  EXPECT_EQ(truth["noise"]["accel_sigma"].size(), 2U);
  EXPECT_TRUE(truth["in_band"][0].get<bool>());
  EXPECT_EQ(truth["A"][0][3].get<double>(), test.truth.residue_per_kg[0][0][3]);
}

TEST(TruthDocument, ListsResiduesByPointForARovingHammer) {
  SynthSpec spec = synth_preset("roving-barrel");
  spec.samples = 1024;
  const auto truth = test::parse_json(truth_json(synthesise(spec).truth));
  EXPECT_EQ(truth["points"], 24);
  EXPECT_EQ(truth["A"].size(), 24U);
  EXPECT_EQ(truth["A"][0].size(), 5U);
}

}  // namespace percuss::synth::spec_test
