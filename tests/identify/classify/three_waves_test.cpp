#include "identify/classify/three_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/units.hpp"
#include "model/shell/shell.hpp"

namespace percuss::identify::three_waves_test {

// An aluminium bat: bending orders 1 to 7, and the lowest hoop mode.
const std::vector<double> kBending_Hz{175, 661, 1322, 2217, 3384, 4781, 6420};
constexpr double kHoop_Hz = 1985;

struct Tube {
  std::vector<Mode> modes;
  std::vector<ModeClassification> types;

  // To be called in ascending order of frequency.
  void add(double freq_Hz, ModeType type, int order, double confidence = 0.9995) {
    modes.push_back({.pole = {freq_Hz, 0.004}});
    types.push_back({.type = type, .order = order, .confidence = confidence});
  }
};

// Bending orders from `first` to `last`, the hoop mode, and a mode of three waves that was taken for bending.
Tube tube_with(double three_waves_Hz, int last, int first = 1, double hoop_Hz = kHoop_Hz) {
  Tube tube;
  int order = 0;
  auto add_others_below = [&, hoop = hoop_Hz, three = three_waves_Hz](double freq_Hz) mutable {
    if (hoop > 0 && hoop < freq_Hz) {
      tube.add(hoop, ModeType::hoop, 1);
      hoop = 0;
    }
    if (three > 0 && three < freq_Hz) {
      tube.add(three, ModeType::bending, ++order);
      three = 0;
    }
  };
  for (int i = first; i <= last; ++i) {
    const double freq_Hz = kBending_Hz[static_cast<std::size_t>(i - 1)];
    add_others_below(freq_Hz);
    tube.add(freq_Hz, ModeType::bending, ++order);
  }
  add_others_below(1e9);
  return tube;
}

std::string names_of(const Tube& tube) {
  std::string out;
  for (const ModeClassification& type : tube.types) {
    out += name_of(type.type)[0];
    if (type.order > 0) out += std::to_string(type.order);
    out += type.possible_three_waves ? "* " : " ";
  }
  return out;
}

Tube allowed(Tube tube, const LowerTubeModes& lower = {}) {
  allow_three_waves(tube.modes, tube.types, std::vector<double>(tube.modes.size(), 1), lower);
  return tube;
}

TEST(ThreeWaves, LieAboveTwiceTheLowestHoopMode) {
  for (const double length_m : {0.2, 0.33, 0.45}) {
    for (const double wall_m : {0.001, 0.0025, 0.004}) {
      const model::TubeShell shell{.wall_m = wall_m, .length_m = length_m};
      EXPECT_GT(model::flugge_Hz(shell, 3, 1), 2 * model::ring_Hz(shell, 2));
      EXPECT_NEAR(model::ring_Hz(shell, 3) / model::ring_Hz(shell, 2), 2.83, 0.01);
    }
  }
}

TEST(ThreeWaves, AreNotNamedBendingBesideTheNextOrder) {
  for (const double freq_Hz : {4120.0, 4300.0, 4500.0}) {
    const Tube found = allowed(tube_with(freq_Hz, 6));
    EXPECT_EQ(names_of(found), "b1 b2 b3 h1 b4 b5 u* b6* ") << freq_Hz;
    EXPECT_EQ(found.types[6].alternative, ModeType::bending);
    EXPECT_LT(found.types[7].confidence, 0.97) << freq_Hz;
    EXPECT_FALSE(found.types[7].order_uncertain);  // its frequency is that of the sixth order
  }
}

TEST(ThreeWaves, DoNotChangeModesBelowTheirRange) {
  const Tube before = tube_with(4300, 7), found = allowed(before);
  for (std::size_t m = 0; m < before.modes.size() && before.modes[m].pole.freq_Hz < 2 * kHoop_Hz; ++m) {
    EXPECT_EQ(found.types[m].type, before.types[m].type);
    EXPECT_EQ(found.types[m].order, before.types[m].order);
    EXPECT_EQ(found.types[m].confidence, before.types[m].confidence);
    EXPECT_FALSE(found.types[m].possible_three_waves || found.types[m].order_uncertain);
  }
}

TEST(ThreeWaves, AreExcludedWhereEveryBendingOrderIsInItsPlace) {
  const Tube found = allowed(tube_with(0, 7));
  EXPECT_EQ(names_of(found).substr(0, 21), "b1 b2 b3 h1 b4 b5 b6 ");
  EXPECT_GT(found.types[6].confidence, 0.97);
  EXPECT_EQ(found.types[7].type, ModeType::bending);  // the last: the next order may lie above the band
  EXPECT_EQ(found.types[7].order, 7);
  EXPECT_GT(found.types[7].confidence, 0.9);
}

// At most one of two modes near one forecast is the next order.
TEST(ThreeWaves, LeaveOpenWhichOfTwoNearModesIsTheNextOrder) {
  const Tube found = allowed(tube_with(4760, 6));
  EXPECT_EQ(names_of(found), "b1 b2 b3 h1 b4 b5 u* u* ");
}

TEST(ThreeWaves, AreUnknownWithoutAHoopMode) {
  const Tube before = tube_with(4300, 7, 1, 0), found = allowed(before);
  EXPECT_EQ(names_of(found), names_of(before));
  for (std::size_t m = 0; m < before.modes.size(); ++m)
    EXPECT_EQ(found.types[m].confidence, before.types[m].confidence);
  Tube unsure = tube_with(4300, 7);
  for (ModeClassification& type : unsure.types) {
    if (type.type == ModeType::hoop) type.confidence = 0.8;
  }
  EXPECT_EQ(names_of(allowed(unsure)), names_of(unsure));
}

// Two orders below give no forecast: bending and three waves are then equally probable.
TEST(ThreeWaves, AreAsProbableAsBendingWithoutAForecast) {
  const Tube found = allowed(tube_with(0, 6, 4));
  EXPECT_EQ(names_of(found), "h1 b1 b2 u* ");
  EXPECT_NEAR(found.types[3].confidence, 0.5, 1e-3);
}

TEST(ThreeWaves, ContinueOrdersAndTheHoopModeBelowTheBand) {
  Tube tube = tube_with(4300, 6, 5, 0);
  for (ModeClassification& type : tube.types) type.order += 4;
  const Tube found = allowed(tube, {.lowest_hoop_Hz = kHoop_Hz, .bending_Hz = {661, 1322, 2217}});
  EXPECT_EQ(names_of(found), "b5 u* b6* ");
}

// The sixth bending order is missing, but a mode of three waves lies near its frequency. So the last mode may be the
// sixth or the seventh order.
TEST(ThreeWaves, LeaveTheNumberOfALaterOrderOpen) {
  Tube tube = tube_with(0, 5);
  tube.add(4500, ModeType::bending, 6);
  tube.add(6420, ModeType::bending, 7);
  const Tube found = allowed(tube);
  EXPECT_EQ(names_of(found), "b1 b2 b3 h1 b4 b5 u* b6* ");
  EXPECT_TRUE(found.types[7].order_uncertain);
  EXPECT_LT(found.types[7].confidence, 0.9);
}

// At other angles the ratio distinguishes the types: sensors 60° apart see three waves with the ratio −1.
TEST(ThreeWaves, AreToldByTheRatioAtOtherAngles) {
  const auto mode = [](double first, double second) {
    return Mode{
        .pole = {4300, 0.004},
        .residues = {{.channel = 0, .value = first, .std = 1e-3}, {.channel = 1, .value = second, .std = 1e-3}}};
  };
  const auto ratio_of = [&](double second_deg, int n, double turn_deg) {
    const auto at = [&](double angle_deg) { return std::cos(n * (angle_deg - turn_deg) * kDegree_rad); };
    return three_over_bending({mode(at(0), at(second_deg))},
                              {.first = 0, .second = 1, .first_rad = 0, .second_rad = second_deg * kDegree_rad}, {})[0];
  };
  for (const double turn_deg : {5.0, 20.0, 40.0, 77.0}) {
    EXPECT_GT(ratio_of(60, 3, turn_deg), 3) << turn_deg;
    EXPECT_LT(ratio_of(60, 1, turn_deg), 0.5) << turn_deg;
    EXPECT_NEAR(ratio_of(90, 3, turn_deg), 1, 0.1) << turn_deg;
    EXPECT_NEAR(ratio_of(90, 1, turn_deg), 1, 0.1) << turn_deg;
  }
}

}  // namespace percuss::identify::three_waves_test
