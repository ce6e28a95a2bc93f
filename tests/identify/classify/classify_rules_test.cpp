// The rules of the classification apart from the ratio of the residues: overlay, split modes, order numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "identify/classify/classify.hpp"

namespace percuss::identify::classify_rules_test {

Mode mode_at(double freq_Hz, double first, double second) {
  return {.pole = {freq_Hz, 0.003},
          .residues = {{.channel = 0, .value = first, .std = 1e-3}, {.channel = 1, .value = second, .std = 1e-3}}};
}
Mode hoop(double freq_Hz) { return mode_at(freq_Hz, 1, -1); }
Mode bending(double freq_Hz, double ratio = 0.4) { return mode_at(freq_Hz, 1, ratio); }

std::vector<ModeClassification> classifications(const std::vector<Mode>& modes, const ClassifyOptions& options = {}) {
  const SensorPair sensors{.first = 0, .second = 1, .first_rad = 0, .second_rad = std::numbers::pi / 2};
  return classify(modes, sensors, std::vector<std::optional<double>>(modes.size()), options);
}

std::vector<int> orders_of(const std::vector<ModeClassification>& found) {
  std::vector<int> orders;
  orders.reserve(found.size());
  for (const ModeClassification& classification : found) orders.push_back(classification.order);
  return orders;
}

TEST(Overlay, HoldsForLevelsWithinTheThreshold) {
  const std::vector<std::optional<double>> differences{0.0, 1.0, -1.0, 1.01, -1.01, 1.7, std::nullopt};
  const std::vector<Mode> modes(differences.size(), bending(500));
  const auto found = classify(modes, std::nullopt, differences);
  const std::vector<bool> overlaid{true, true, true, false, false, false, false};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    EXPECT_EQ(found[m].overlaid, overlaid[m]) << m;
    EXPECT_EQ(found[m].overlay_dB, differences[m]);
  }
}

TEST(Overlay, HasAnAdjustableThreshold) {
  EXPECT_TRUE(classify({bending(500)}, std::nullopt, {1.7}, {.overlay_dB = 2})[0].overlaid);
  EXPECT_FALSE(classify({bending(500)}, std::nullopt, {0.5}, {.overlay_dB = 0.4})[0].overlaid);
}

TEST(Overlay, DoesNotDecideTheType) {
  // Equal levels in phase: overlaid like a hoop mode, but bending at 45°.
  const SensorPair sensors{.first = 0, .second = 1, .first_rad = 0, .second_rad = std::numbers::pi / 2};
  const ModeClassification classification = classify({mode_at(169, 1, 1)}, sensors, {0.0})[0];
  EXPECT_TRUE(classification.overlaid);
  EXPECT_EQ(classification.type, ModeType::bending);
}

// Modes 25 Hz apart are a split mode, even if noise makes the measured separation larger.
TEST(SplitMode, AllowsForTheErrorOfTheSeparation) {
  std::vector<Mode> modes{hoop(1900), hoop(1925.01)};
  EXPECT_FALSE(classifications(modes)[0].split_mode);
  for (Mode& mode : modes) mode.freq_std_Hz = 0.01;
  EXPECT_TRUE(classifications(modes)[0].split_mode);
  modes[1].pole.freq_Hz = 1925.03;
  EXPECT_FALSE(classifications(modes)[0].split_mode);
}

TEST(SplitMode, IsTwoModesOfOneTypeWithin25Hertz) {
  const auto found = classifications({hoop(1900), hoop(1925)});
  ASSERT_TRUE(found[0].split_mode && found[1].split_mode);
  EXPECT_EQ(found[0].split_mode->partner, 1U);
  EXPECT_EQ(found[1].split_mode->partner, 0U);
  EXPECT_DOUBLE_EQ(found[0].split_mode->separation_Hz, 25);
  EXPECT_DOUBLE_EQ(found[1].split_mode->separation_Hz, 25);
  EXPECT_TRUE(found[0].split_mode->first);  // the lower one
  EXPECT_FALSE(found[1].split_mode->first);
}

TEST(SplitMode, EndsAt25Hertz) {
  for (const ModeClassification& classification : classifications({hoop(1900), hoop(1925.5)}))
    EXPECT_FALSE(classification.split_mode);
  for (const ModeClassification& classification : classifications({hoop(1900), hoop(1925.5)}, {.double_peak_Hz = 26}))
    EXPECT_TRUE(classification.split_mode);
}

TEST(SplitMode, ExcludesABendingAndAHoopMode) {
  const auto found = classifications({bending(1895, 0.0), hoop(1912)});
  ASSERT_EQ(found[0].type, ModeType::bending);
  ASSERT_EQ(found[1].type, ModeType::hoop);
  EXPECT_FALSE(found[0].split_mode);
  EXPECT_FALSE(found[1].split_mode);
}

TEST(SplitMode, OfThreeTakesTheFirstTwo) {
  const auto found = classifications({hoop(1900), hoop(1912), hoop(1924)});
  EXPECT_EQ(found[0].split_mode->partner, 1U);
  EXPECT_EQ(found[1].split_mode->partner, 0U);
  EXPECT_FALSE(found[2].split_mode);
}

TEST(SplitMode, NeedsATube) {
  const std::vector<Mode> modes{hoop(1900), hoop(1912)};
  const std::vector<std::optional<double>> unknown(2);
  EXPECT_FALSE(classify(modes, std::nullopt, unknown)[0].split_mode);
  const auto found = classify(modes, std::nullopt, unknown, {.object = ObjectKind::tube});
  ASSERT_TRUE(found[0].split_mode);
  EXPECT_TRUE(found[0].split_mode->first);
  EXPECT_FALSE(classifications(modes, {.object = ObjectKind::other})[0].split_mode);
}

TEST(Object, OtherHasNoTypes) {
  for (const ModeClassification& one :
       classifications({bending(169), bending(575), hoop(1900)}, {.object = ObjectKind::other})) {
    EXPECT_EQ(one.type, ModeType::unknown);
    EXPECT_EQ(one.order, 0);
    EXPECT_FALSE(one.ratio);
  }
}

// Ratios of a plate: none repeats.
std::vector<Mode> plate() {
  std::vector<Mode> modes;
  for (const double chi_deg : {-80.0, -62.0, 12.0, 70.0, -20.0, 41.0, -8.0, 55.0}) {
    const double chi = chi_deg * std::numbers::pi / 180;
    modes.push_back(mode_at(200 + 150 * static_cast<double>(modes.size()), std::cos(chi), std::sin(chi)));
  }
  return modes;
}

TEST(Object, IsJudgedByTheModesWhereAnglesAreAssumed) {
  const ClassifyOptions assumed{.angles_assumed = true};
  const auto tube = classifications({bending(169), bending(575), hoop(1300), bending(1800), hoop(2650)}, assumed);
  EXPECT_EQ(orders_of(tube), (std::vector<int>{1, 2, 1, 3, 2}));
  for (const ModeClassification& one : classifications(plate(), assumed)) {
    EXPECT_EQ(one.type, ModeType::unknown);
    EXPECT_EQ(one.order, 0);
  }
  EXPECT_TRUE(classifications(plate())[0].ratio) << "stated angles mean a tube";
  EXPECT_TRUE(classifications(plate(), {.object = ObjectKind::tube, .angles_assumed = true})[0].ratio);
}

// Ten random ratios, as of two sensors on a frame, may resemble a tube. With a limit of 1/10 for the Bayes factor, 22 %
// of such frames counted as tubes.
TEST(Object, OfManyModesNeedsMoreEvidenceForATube) {
  const ClassifyOptions assumed{.angles_assumed = true};
  const auto mode = [](std::size_t m, double chi) {
    return mode_at(40 * std::pow(1.4, static_cast<double>(m)), std::cos(chi), std::sin(chi));
  };
  constexpr std::size_t kFrames = 400, kModes = 10;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-std::numbers::pi / 2, std::numbers::pi / 2);
  std::size_t named = 0;
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    std::vector<Mode> modes;
    for (std::size_t m = 0; m < kModes; ++m) modes.push_back(mode(m, any(random)));
    named += classifications(modes, assumed)[0].ratio ? 1U : 0U;
  }
  EXPECT_LT(named, kFrames / 10);
  // A tube of ten modes: the planes of bending scatter by 8°, and the ratios of two modes are random.
  constexpr std::size_t kTubes = 100;
  std::normal_distribution<double> plane(0.4, 0.14), hoop_chi(-std::numbers::pi / 4, 0.035);
  std::size_t tubes = 0;
  for (std::size_t tube = 0; tube < kTubes; ++tube) {
    std::vector<Mode> modes;
    for (std::size_t m = 0; m < kModes; ++m)
      modes.push_back(mode(m, m % 5 == 4 ? any(random) : m % 2 == 0 ? plane(random) : hoop_chi(random)));
    tubes += classifications(modes, assumed)[0].ratio ? 1U : 0U;
  }
  EXPECT_EQ(tubes, kTubes);
}

// Counts the modes below the band. Their types come from their ratios.
LowerOrders lower(const std::vector<Mode>& below, const std::vector<Mode>& found) {
  return lower_orders(below, classifications(below), found, classifications(found), {});
}

TEST(LowerOrders, CountModesBelowTheBand) {
  EXPECT_EQ(lower({bending(169)}, {bending(575), bending(1150)}).bending, 1);
  EXPECT_EQ(lower({bending(169), bending(172, -2.5), bending(575)}, {bending(1150), bending(1900)}).bending, 2);
  EXPECT_EQ(lower({bending(169), bending(575), hoop(1300)}, {bending(1900), hoop(2650)}).hoop, 1);
  EXPECT_EQ(lower({}, {bending(575)}).bending, 0);
}

TEST(LowerOrders, LeaveOutMotionOnTheSuspensionAndHum) {
  EXPECT_EQ(lower({bending(12)}, {bending(169), bending(575)}).bending, 0);
  EXPECT_EQ(lower({bending(50)}, {bending(169), bending(575)}).bending, 0);
  EXPECT_EQ(lower({bending(20), bending(169)}, {bending(575), bending(1150)}).bending, 1);
}

TEST(Order, CountsFromOneWithinEachType) {
  EXPECT_EQ(orders_of(classifications({bending(169), bending(575), hoop(1300), bending(1800), hoop(2650)})),
            (std::vector<int>{1, 2, 1, 3, 2}));
}

TEST(Order, IsSharedByASplitMode) {
  EXPECT_EQ(orders_of(classifications({hoop(1900), hoop(1912), hoop(2650)})), (std::vector<int>{1, 1, 2}));
}

TEST(Order, IsSharedByTheTwoPlanesOfABendingMode) {
  // Planes at right angles, with frequencies 1.8 % and 1.0 % apart.
  EXPECT_EQ(orders_of(classifications({bending(169, 0.4), bending(172, -2.5), bending(575), bending(581, -2.5)})),
            (std::vector<int>{1, 1, 2, 2}));
}

TEST(Order, IsSharedByAtMostTwoModes) {
  EXPECT_EQ(orders_of(classifications({hoop(1900), hoop(1912), hoop(1924), hoop(1936)})),
            (std::vector<int>{1, 1, 2, 2}));
}

TEST(ModeType, HasNames) {
  EXPECT_STREQ(name_of(ModeType::bending), "bending");
  EXPECT_STREQ(name_of(ModeType::hoop), "hoop");
  EXPECT_STREQ(name_of(ModeType::unknown), "unknown");
}

}  // namespace percuss::identify::classify_rules_test
