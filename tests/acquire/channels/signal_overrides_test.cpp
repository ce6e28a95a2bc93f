#include "acquire/channels/signal_overrides.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/input_error.hpp"
#include "support/messages.hpp"

namespace percuss::acquire::signal_overrides_test {

using test::input_error_of;
using testing::HasSubstr;

SignalInfo applied(const SignalOverrides& choice, Quantity measures = Quantity::acceleration, const char* unit = "") {
  SignalInfo signal{.name = "x", .unit = unit};
  apply_overrides(signal, choice, measures, "here");
  return signal;
}

TEST(SignalOverrides, AssumesSIWithoutAStatedUnit) {
  EXPECT_EQ(applied({}).to_SI, 1);
  EXPECT_EQ(applied({.sign = -1}).to_SI, -1);
}

TEST(SignalOverrides, ConvertsByTheUnitTheUserGivesOrTheFileStates) {
  EXPECT_EQ(applied({}, Quantity::force, "lbf").to_SI, kPoundForce_N);
  const SignalInfo signal = applied({.unit = "g", .sign = -1}, Quantity::acceleration, "m/s^2");
  EXPECT_EQ(signal.to_SI, -kStandardGravity_mps2);
  EXPECT_EQ(signal.unit, "g");
}

TEST(SignalOverrides, DividesVoltsBySensitivity) {
  EXPECT_DOUBLE_EQ(applied({.sensitivity_V_per_SI = 0.01}).to_SI, 100);
  EXPECT_DOUBLE_EQ(applied({.sensitivity_V_per_SI = 0.01}, Quantity::force, "mV").to_SI, 0.1);
  EXPECT_THAT(input_error_of([] { applied({.sensitivity_V_per_SI = 0.01}, Quantity::force, "N"); }),
              HasSubstr("sensitivity"));
  EXPECT_THAT(input_error_of([] { applied({}, Quantity::force, "V"); }), HasSubstr("sensitivity"));
}

TEST(SignalOverrides, KeepsAForceInVoltsWithANote) {
  const auto force_of = [](const SignalOverrides& choice, const char* unit, std::size_t notes_expected) {
    SignalInfo signal{.name = "hammer", .unit = unit};
    std::vector<Message> notes;
    apply_force_overrides(signal, choice, "here", notes);
    EXPECT_EQ(notes.size(), notes_expected);
    if (!notes.empty()) {
      EXPECT_THAT(notes[0].text, HasSubstr("hammer"));
      EXPECT_THAT(notes[0].text, HasSubstr("per volt"));
      EXPECT_THAT(notes[0].options, testing::ElementsAre("force_scale", "force_sensitivity"));
    }
    return signal.to_SI;
  };
  EXPECT_EQ(force_of({}, "V", 1), 1);
  EXPECT_EQ(force_of({.sign = -1}, "mV", 1), -1e-3);
  EXPECT_EQ(force_of({.unit = "mV"}, "N", 1), 1e-3);
  EXPECT_EQ(force_of({.scale = 5}, "V", 0), 5);
  EXPECT_EQ(force_of({.sensitivity_V_per_SI = 0.5}, "V", 0), 2);
  EXPECT_EQ(force_of({}, "N", 0), 1);
}

// 50 mV/Pa: 1 V is 20 Pa. Beside a force, a response cannot be a pressure.
TEST(SignalOverrides, TakesPressuresFromSensitivities) {
  const SignalOverrides choice{.sensitivity_V_per_SI = 0.05, .sensitivity_to = Quantity::pressure};
  const SignalInfo volts{.name = "mic", .unit = "V"};
  EXPECT_EQ(response_quantity(volts, choice, false), Quantity::pressure);
  EXPECT_EQ(response_quantity(volts, choice, true), Quantity::acceleration);
  EXPECT_DOUBLE_EQ(applied(choice, Quantity::pressure, "mV").to_SI, 0.02);
  EXPECT_EQ(applied(choice, Quantity::pressure, "V").measures, Quantity::pressure);
  EXPECT_EQ(applied({}).measures, Quantity::acceleration);
  EXPECT_THAT(input_error_of([&] { applied(choice, Quantity::acceleration, "V"); }),
              HasSubstr("a sensitivity to pressure"));
  EXPECT_THAT(input_error_of([] { applied({.sensitivity_V_per_SI = 0.01}, Quantity::pressure, "Pa"); }),
              HasSubstr("sensitivity"));
  EXPECT_EQ(accel_overrides({.pressure_sensitivity_V_per_Pa = {0.05}}, nullptr, 1, 2, "f").sensitivity_to,
            Quantity::pressure);
  EXPECT_THAT(input_error_of([] {
                accel_overrides({.accel_sensitivity_V_per_mps2 = {1}, .pressure_sensitivity_V_per_Pa = {1}}, nullptr, 0,
                                1, "x.csv");
              }),
              HasSubstr("both given (x.csv)"));
}

TEST(SignalOverrides, PrefersAScaleToUnitAndSensitivity) {
  EXPECT_EQ(applied({.scale = 3, .sensitivity_V_per_SI = 0.01}, Quantity::force, "no unit").to_SI, 3);
}

TEST(SignalOverrides, RefusesFactorsThatAreZeroOrNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double factor : {0.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(input_error_of([&] { applied({.scale = factor}); }), HasSubstr("scale"));
    EXPECT_THAT(input_error_of([&] { applied({.sensitivity_V_per_SI = factor}); }), HasSubstr("sensitivity"));
  }
}

TEST(SignalOverrides, PrefersOptionsToTheSetup) {
  const ChannelSetup setup{.sign = -1, .angle_rad = 0.5, .sensitivity_V_per_SI = 2, .unit = "V"};
  const ReadOptions options{
      .accel_sensitivity_V_per_mps2 = {3, 4}, .accel_unit = "mV", .angle_rad = {1, 2}, .position_m = {0.25}};
  const SignalOverrides choice = accel_overrides(options, &setup, 1, 2, "f");
  EXPECT_EQ(choice.sensitivity_V_per_SI, 4);
  EXPECT_EQ(choice.unit, "mV");
  EXPECT_EQ(choice.sign, -1);
  EXPECT_EQ(choice.angle_rad, 2);
  EXPECT_EQ(choice.position_m, 0.25);
  EXPECT_EQ(accel_overrides({}, &setup, 1, 2, "f").angle_rad, 0.5);
  EXPECT_EQ(force_overrides({.force_unit = "lbf"}, &setup).unit, "lbf");
  EXPECT_EQ(force_overrides({}, nullptr).sign, 1);
}

// A pulse is positive along its stated direction, so a direction along −z does not change the sign of the force. It
// reverses the sign of the responses, which then belong to a blow along +z.
TEST(SignalOverrides, KeepTheSignOfAForceAlongANegativeDirection) {
  const ChannelSetup down{.sign = -1, .axis = Direction{0, 0, 1}}, up{.axis = Direction{0, 0, 1}}, reversed{.sign = -1};
  EXPECT_EQ(force_overrides({}, &down).sign, 1);
  EXPECT_EQ(force_overrides({}, &down).axis, down.axis);
  EXPECT_EQ(response_sign(&down), -1);
  EXPECT_EQ(response_sign(&up), 1);
  EXPECT_EQ(force_overrides({}, &reversed).sign, -1);
  EXPECT_EQ(response_sign(&reversed), 1);
  EXPECT_EQ(response_sign(nullptr), 1);
}

TEST(SignalOverrides, RefusesListsOfAnotherLength) {
  EXPECT_THAT(input_error_of([] {
                accel_overrides({.accel_scale = {1, 2, 3}}, nullptr, 0, 2, "x.csv");
              }),
              HasSubstr("3 values for 2 acceleration channels (x.csv)"));
  EXPECT_THAT(input_error_of([] { accel_overrides({.angle_rad = {1}}, nullptr, 0, 2, "f"); }),
              HasSubstr("1 values for 2 acceleration channels (f); give one per channel"));
}

}  // namespace percuss::acquire::signal_overrides_test
