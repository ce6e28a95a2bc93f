#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

/// What the user says about one signal, from options and set-up together; empty members leave what the file says.
struct SignalOverrides {
  std::optional<double> scale;                 // SI per stored unit: whatever the unit
  std::optional<double> sensitivity_V_per_SI;  // the stored numbers are volts
  std::string unit;                            // of the stored numbers
  double sign = 1;
  std::optional<double> angle_rad, position_m;
};

/// For the force; `setup` is its entry or nullptr. What options say wins over the set-up.
SignalOverrides force_overrides(const ReadOptions& options, const ChannelSetup* setup);

/// For acceleration channel `index` of the `count` that are read. InputError when a list of options has another length
/// than one (for all) or `count`.
SignalOverrides accel_overrides(const ReadOptions& options, const ChannelSetup* setup, std::size_t index,
                                std::size_t count);

/// Applies a choice: sets the signal's unit, to_SI, angle_rad and position_m. The unit is `measures`' SI unit where
/// neither the file (signal.unit) nor the user states one, volts if a sensitivity is given. errors  InputError at
/// `where`: unknown unit, a unit of another quantity, volts without sensitivity, a sensitivity for other
///         than volts, a scale or sensitivity that is zero or not finite.
void apply_overrides(SignalInfo& signal, const SignalOverrides& choice, Quantity measures, const std::string& where);

/// apply_overrides for the force. Volts that nobody gives a sensitivity or scale for are kept: frequencies and damping
/// do not need newtons. A note then says that FRFs are per volt.
void apply_force_overrides(SignalInfo& signal, const SignalOverrides& choice, const std::string& where,
                           std::vector<Message>& notes);

}  // namespace percuss::acquire
