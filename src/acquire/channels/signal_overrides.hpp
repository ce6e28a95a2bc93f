#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

/// The user's statements about one signal, from options and set-up. Empty members leave what the file states.
struct SignalOverrides {
  std::optional<double> scale;                 // SI value per stored number, whatever its unit
  std::optional<double> sensitivity_V_per_SI;  // the stored numbers are volts
  Quantity sensitivity_to = Quantity::acceleration;
  std::string unit;  // of the stored numbers
  double sign = 1;
  std::optional<Direction> axis{};
  std::optional<double> angle_rad, position_m;
};

/// For the force; `setup` is its entry or nullptr. Options override the set-up. A stated direction does not change the
/// sign of the force, because a pulse is positive along it; it changes the sign of the responses, see response_sign.
SignalOverrides force_overrides(const ReadOptions& options, const ChannelSetup* setup);

/// For acceleration channel `index` of the `count` that are read.
/// errors  InputError at `where`, the name of the file: an option's list has neither one value (for all channels) nor
/// `count` values, or sensitivities to accelerations and to pressures are both given. A list of angles needs `count`
/// values.
SignalOverrides accel_overrides(const ReadOptions& options, const ChannelSetup* setup, std::size_t index,
                                std::size_t count, const std::string& where);

/// −1 for responses to a force whose set-up states a direction along −x, −y or −z, else 1: the responses to the
/// opposite blow have the other sign. `force` is the set-up of the force, or nullptr. Multiplies the sign of each
/// acceleration.
double response_sign(const ChannelSetup* force);

/// Whether the file (signal.unit) or the user states the size of the stored numbers: a unit, scale or sensitivity.
bool states_scale(const SignalInfo& signal, const SignalOverrides& choice);

/// Sets the SI unit of signal.measures, as an assumption.
void mark_unit_assumed(SignalInfo& signal);

/// Notes that the user's sampling rate differs by more than 1 % from the rate of the file (0 or less: none). `source`:
/// what gives the file's rate, "the column t_s".
void note_other_rate(const std::string& source, double file_Hz, double stated_Hz, std::vector<Message>& notes);

/// What a response measures: a pressure, if its unit or its sensitivity says so and no force was recorded (a
/// microphone); else an acceleration. FRFs of a pressure have other units than percuss states.
Quantity response_quantity(const SignalInfo& signal, const SignalOverrides& choice, bool has_force);

/// Applies the statements: sets the signal's unit, to_SI, axis, angle_rad, position_m and measures. Where neither the
/// file (signal.unit) nor the user states a unit, the numbers count as V with a sensitivity, else as the SI unit of
/// `measures`; signal.unit stays empty.
/// errors  InputError at `where`: unknown unit, a unit of another quantity, volts without sensitivity, a sensitivity
/// for another unit than volts or to another quantity, a scale or sensitivity that is zero or not finite.
void apply_overrides(SignalInfo& signal, const SignalOverrides& choice, Quantity measures, const std::string& where);

/// apply_overrides for the force. Volts without sensitivity or scale are kept, with a note that FRFs are per volt:
/// frequencies and damping do not need newtons.
void apply_force_overrides(SignalInfo& signal, const SignalOverrides& choice, const std::string& where,
                           std::vector<Message>& notes);

}  // namespace percuss::acquire
