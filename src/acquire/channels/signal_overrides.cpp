#include "acquire/channels/signal_overrides.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

// The place of a channel in the list of channels to read, and the name of the file.
struct ListPlace {
  std::size_t index, count;
  const std::string& where;
};

[[noreturn]] void refuse_list(const std::vector<double>& list, const ListPlace& at, const char* remedy,
                              const OptionId& option) {
  throw InputError(std::to_string(list.size()) + " values for " + std::to_string(at.count) + " acceleration channels",
                   at.where, remedy, {option});
}

// The entry of a list with one value for all channels or one value per channel.
std::optional<double> entry(const std::vector<double>& list, const ListPlace& at, const OptionId& option) {
  if (list.empty()) return std::nullopt;
  if (list.size() == 1) return list.front();
  if (list.size() == at.count) return list[at.index];
  refuse_list(list, at, "give one for all or one per channel", option);
}

// As entry, for a quantity that differs between channels.
std::optional<double> entry_of_each(const std::vector<double>& list, const ListPlace& at, const OptionId& option) {
  if (list.empty()) return std::nullopt;
  if (list.size() == at.count) return list[at.index];
  refuse_list(list, at, "give one per channel", option);
}

SignalOverrides from_setup(const ChannelSetup* setup) {
  if (setup == nullptr) return {};
  return {.scale = std::nullopt,
          .sensitivity_V_per_SI = setup->sensitivity_V_per_SI,
          .sensitivity_to = setup->sensitivity_to,
          .unit = setup->unit.value_or(""),
          .sign = setup->sign,
          .axis = setup->axis,
          .angle_rad = setup->angle_rad,
          .position_m = setup->position_m};
}

void override_value(std::optional<double>& value, const std::optional<double>& by) {
  if (by) value = by;
}

double usable_factor(double factor, const char* what, const std::string& where) {
  if (std::isfinite(factor) && factor != 0) return factor;
  throw InputError(std::string(what) + " is zero or not finite", where, "give a number other than zero");
}

double volts_to_SI(const std::string& unit, double sensitivity_V_per_SI, const std::string& where) {
  const double sensitivity = usable_factor(sensitivity_V_per_SI, "sensitivity", where);
  if (unit.empty()) return 1 / sensitivity;
  const auto stored = parse_unit(unit);
  if (!stored || stored->quantity != Quantity::voltage) {
    throw InputError("a sensitivity is given, yet the numbers are in " + unit, where,
                     "drop the sensitivity, or give the unit as V or mV");
  }
  return stored->to_SI / sensitivity;
}

double unit_to_SI(const std::string& unit, Quantity measures, const std::string& where) {
  if (unit.empty()) return 1;
  const auto stored = parse_unit(unit);
  if (stored && stored->quantity == Quantity::voltage) {
    using Ids = std::vector<OptionId>;
    throw InputError("the numbers are in " + unit, where, "give the sensitivity or the scale",
                     measures == Quantity::force ? Ids{"force_sensitivity", "force_scale"}
                                                 : Ids{"accel_sensitivity", "accel_scale"});
  }
  return require_unit(unit, measures, where, {measures == Quantity::force ? "force_unit" : "unit"}).to_SI;
}

}  // namespace

SignalOverrides force_overrides(const ReadOptions& options, const ChannelSetup* setup) {
  SignalOverrides choice = from_setup(setup);
  if (choice.axis) choice.sign = 1;
  if (!options.force_scale.empty()) choice.scale = options.force_scale.front();
  override_value(choice.sensitivity_V_per_SI, options.force_sensitivity_V_per_N);
  if (!options.force_unit.empty()) choice.unit = options.force_unit;
  return choice;
}

SignalOverrides accel_overrides(const ReadOptions& options, const ChannelSetup* setup, std::size_t index,
                                std::size_t count, const std::string& where) {
  SignalOverrides choice = from_setup(setup);
  const ListPlace at{index, count, where};
  choice.scale = entry(options.accel_scale, at, "accel_scale");
  if (!options.accel_sensitivity_V_per_mps2.empty() && !options.pressure_sensitivity_V_per_Pa.empty()) {
    throw InputError("sensitivities to accelerations and to pressures are both given", where,
                     "give one of them, or describe the channels in a set-up file",
                     {"pressure_sensitivity", "accel_sensitivity", "setup"});
  }
  if (const auto accel = entry(options.accel_sensitivity_V_per_mps2, at, "accel_sensitivity")) {
    choice.sensitivity_V_per_SI = accel;
    choice.sensitivity_to = Quantity::acceleration;
  }
  if (const auto pressure = entry(options.pressure_sensitivity_V_per_Pa, at, "pressure_sensitivity")) {
    choice.sensitivity_V_per_SI = pressure;
    choice.sensitivity_to = Quantity::pressure;
  }
  if (!options.accel_unit.empty()) choice.unit = options.accel_unit;
  override_value(choice.angle_rad, entry_of_each(options.angle_rad, at, "angle"));
  override_value(choice.position_m, entry(options.position_m, at, "position"));
  return choice;
}

double response_sign(const ChannelSetup* force) { return force != nullptr && force->axis ? force->sign : 1; }

bool states_scale(const SignalInfo& signal, const SignalOverrides& choice) {
  return !signal.unit.empty() || !choice.unit.empty() || choice.scale || choice.sensitivity_V_per_SI;
}

void mark_unit_assumed(SignalInfo& signal) {
  signal.unit = si_name(signal.measures);
  signal.unit_assumed = true;
}

void note_other_rate(const std::string& source, double file_Hz, double stated_Hz, std::vector<Message>& notes) {
  constexpr double kMaxRateDifference = 0.01;
  if (!(file_Hz > 0) || std::abs(file_Hz / stated_Hz - 1) <= kMaxRateDifference) return;
  notes.emplace_back(fmt::format("{} gives {:.6g} Hz; the stated rate is used", source, file_Hz),
                     std::vector<OptionId>{"fs"});
}

Quantity response_quantity(const SignalInfo& signal, const SignalOverrides& choice, bool has_force) {
  const auto unit = parse_unit(choice.unit.empty() ? signal.unit : choice.unit);
  const bool by_unit = unit && unit->quantity == Quantity::pressure;
  const bool by_sensitivity = choice.sensitivity_V_per_SI && choice.sensitivity_to == Quantity::pressure;
  return !has_force && (by_unit || by_sensitivity) ? Quantity::pressure : Quantity::acceleration;
}

void apply_overrides(SignalInfo& signal, const SignalOverrides& choice, Quantity measures, const std::string& where) {
  if (!choice.unit.empty()) signal.unit = choice.unit;
  if (choice.scale) {
    signal.to_SI = usable_factor(*choice.scale, "scale", where);
  } else if (choice.sensitivity_V_per_SI) {
    if ((choice.sensitivity_to == Quantity::pressure) != (measures == Quantity::pressure)) {
      if (measures == Quantity::pressure) {
        throw InputError("a sensitivity to accelerations, but the signal is a pressure", where,
                         "give the sensitivity in mV/Pa");
      }
      throw InputError("a sensitivity to pressure, but the record has a force: its responses are accelerations", where,
                       "give the sensitivity in mV/g, or read the file without its force");
    }
    signal.to_SI = volts_to_SI(signal.unit, *choice.sensitivity_V_per_SI, where);
  } else {
    signal.to_SI = unit_to_SI(signal.unit, measures, where);
  }
  signal.to_SI *= choice.sign;
  signal.measures = measures;
  if (choice.axis) signal.axis = choice.axis;
  if (choice.angle_rad) signal.angle_rad = choice.angle_rad;
  if (choice.position_m) signal.position_m = choice.position_m;
}

void apply_force_overrides(SignalInfo& signal, const SignalOverrides& choice, const std::string& where,
                           std::vector<Message>& notes) {
  const auto known = parse_unit(choice.unit.empty() ? signal.unit : choice.unit);
  SignalOverrides completed = choice;
  if (known && known->quantity == Quantity::voltage && !choice.scale && !choice.sensitivity_V_per_SI) {
    completed.scale = known->to_SI;
    notes.emplace_back("the force " + one_line(signal.name, 40) +
                           " is in volts and not calibrated: 1 V counts as 1 N, so that FRFs are per volt; give its "
                           "scale or sensitivity",
                       std::vector<OptionId>{"force_scale", "force_sensitivity"});
  }
  apply_overrides(signal, completed, Quantity::force, where);
}

}  // namespace percuss::acquire
