#include "cli/read_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "acquire/channels/channel_setup.hpp"
#include "acquire/channels/frf_unit.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr double kMilli = 1e-3;

// `pressures`: a unit of pressure is accepted as well.
void require_unit_or_volts(const std::string& name, Quantity wanted, const OptionId& option, bool pressures = false) {
  const auto unit = parse_unit(name);
  const bool other =
      unit && (unit->quantity == Quantity::voltage || (pressures && unit->quantity == Quantity::pressure));
  if (name.empty() || other) return;
  try {
    require_unit(name, wanted, "options");
  } catch (const InputError& error) {
    throw InputError(error.problem(), error.where(), error.remedy(), {option});
  }
}

acquire::FileGrouping grouping_named(const std::string& text) {
  if (text == "hits") return acquire::FileGrouping::hits;
  return text == "points" ? acquire::FileGrouping::points : acquire::FileGrouping::tests;
}

// A number in Hz, or the name of a variable.
void set_rate(const std::string& text, acquire::ReadOptions& options) {
  const ParsedNumber number = parse_number(text, false);
  if (number.problem == NumberProblem::none || number.problem == NumberProblem::not_finite) {
    options.fs_Hz = number.problem == NumberProblem::none ? number.value : 0;
  } else {
    options.fs_variable = text;
  }
}

// Joins names of columns of MAT variables, such as "data(:,2)", which the list split at their comma.
std::vector<std::string> rejoined_names(const std::vector<std::string>& pieces) {
  std::vector<std::string> names;
  bool open = false;
  for (const std::string& piece : pieces) {
    if (open) {
      names.back() += "," + piece;
    } else {
      names.push_back(piece);
    }
    open = names.back().find('(') != std::string::npos && names.back().find(')') == std::string::npos;
  }
  return names;
}

}  // namespace

void add_reading_options(Command& command, ReadFlags& flags) {
  acquire::ReadOptions& options = flags.options;
  const std::string previous = command.heading(kReadingHeading);
  command
      .value(
          "--fs", [&options](const std::string& text) { set_rate(text, options); },
          "Set the sampling rate in place of the file's: a number, or for a MAT file the name of a variable")
      .type("HZ");
  command
      .value("--df", options.df_Hz,
             "Set the frequency spacing of FRFs, for files that round frequencies or state none (MAT)")
      .above_zero()
      .type("HZ");
  command.value("--force-channel", options.force_channel, "Select the force by column name or number, counted from 1")
      .type("NAME");
  command
      .list("--accel-channel", options.accel_channels,
            "Select the accelerations, in this order, by name or number (repeatable, or a list)")
      .type("NAME,...");
  command
      .value("--unit", options.accel_unit,
             "Set the unit of the stored accelerations: m/s^2, g, cm/s^2, V, ...; without a force also Pa")
      .type("UNIT");
  command.value("--force-unit", options.force_unit, "Set the unit of the stored forces: N, lbf, V, ...").type("UNIT");
  command.list("--force-scale", options.force_scale, "Set the force in N per stored unit; one value, or one per file")
      .type("N,...");
  command
      .list("--accel-scale", options.accel_scale,
            "Set the acceleration in m/s^2 per stored unit; one value, or one per channel")
      .type("X,...");
  command
      .value("--force-sensitivity", flags.force_sensitivity_mV_per_N,
             "Set the sensitivity of the hammer, for forces stored in volts")
      .type("mV/N");
  command
      .list(
          "--accel-sensitivity", flags.accel_sensitivity_mV_per_g,
          "Set the sensitivity of the accelerometers, for accelerations stored in volts; one value, or one per channel")
      .type("mV/g,...");
  command
      .list(
          "--pressure-sensitivity", flags.pressure_sensitivity_mV_per_Pa,
          "Set the sensitivity of the microphones, for sound pressures stored in volts, without a force; one value, or "
          "one per channel")
      .type("mV/Pa,...");
  command.list("--angle", flags.angle_deg, "Set the angle of each accelerometer around the barrel")
      .type("DEG,...")
      .finite();
  command.list("--position", flags.position_m, "Set the distance of each accelerometer from the end of the barrel")
      .type("M,...")
      .finite();
  command
      .value(
          "--frf-kind", [&flags](const std::string& text) { flags.frf_kind = acquire::parse_frf_kind(text); },
          "Set the kind of the FRFs, in place of the file's")
      .one_of({"accelerance", "mobility", "receptance"});
  command
      .value("--averages", flags.averages,
             "Set the number of averages of the FRFs, for files that do not state it: with a coherence, it gives their "
             "standard deviation")
      .within(1, acquire::kMaxAverages);
  command.heading(previous);
}

void add_setup_option(Command& command, ReadFlags& flags) {
  const std::string previous = command.heading(kReadingHeading);
  command
      .value("--setup", flags.setup_path,
             "Read the channel set-up from this file (JSON; percuss info --example prints one)")
      .type("FILE");
  command.heading(previous);
}

void add_trust_input_option(Command& command, ReadFlags& flags) {
  const std::string previous = command.heading(kReadingHeading);
  command.flag("--trust-input", flags.trust_input, "Read MAT, HDF5 and sound files in this process, without a sandbox");
  command.heading(previous);
}

void add_read_flags(Command& command, ReadFlags& flags, Reads reads) {
  flags.host = command.host();
  command.arguments("FILE", flags.paths,
                    reads == Reads::records
                        ? "Records to read: HDF5, MAT, UFF, LabVIEW, sound, CSV or text; also folders and patterns in "
                          "quotes; - is standard input"
                        : "Records or FRFs to read: HDF5, MAT, UFF, LabVIEW, sound, CSV or text; also folders and "
                          "patterns in quotes; - is standard input");
  add_reading_options(command, flags);
  add_setup_option(command, flags);
  const std::string previous = command.heading(kReadingHeading);
  command
      .value(
          "--files", [&flags](const std::string& text) { flags.files = grouping_named(text); },
          reads == Reads::described ? "Has no effect: each file is described alone"
                                    : "Group several files: as hits of one test, as points of one test, or as separate "
                                      "tests (default: hits if rates and channels agree)")
      .one_of({"hits", "points", "tests"});
  command.heading(previous);
  add_trust_input_option(command, flags);
}

namespace {

// Only a MAT file has variables, which may hold the rate.
void require_rate(const ReadFlags& flags) {
  const bool has_variables = std::any_of(flags.paths.begin(), flags.paths.end(),
                                         [](const auto& path) { return extension_of(path) == ".mat"; });
  if (flags.options.fs_variable.empty() || has_variables) return;
  throw OptionError::wrong_value("fs", flags.options.fs_variable,
                                 "give a number in Hz, or for a MAT file the name of a variable");
}

acquire::ReadOptions options_of(const ReadFlags& flags) {
  acquire::ReadOptions options = flags.options;
  options.sandboxed = !flags.trust_input;
  for (const double angle_deg : flags.angle_deg) options.angle_rad.push_back(angle_deg * kDegree_rad);
  options.position_m = flags.position_m;
  if (flags.force_sensitivity_mV_per_N) options.force_sensitivity_V_per_N = *flags.force_sensitivity_mV_per_N * kMilli;
  for (const double mV_per_g : flags.accel_sensitivity_mV_per_g) {
    options.accel_sensitivity_V_per_mps2.push_back(mV_per_g * kMilli / kStandardGravity_mps2);
  }
  for (const double mV_per_Pa : flags.pressure_sensitivity_mV_per_Pa)
    options.pressure_sensitivity_V_per_Pa.push_back(mV_per_Pa * kMilli);
  require_unit_or_volts(options.accel_unit, Quantity::acceleration, "unit", options.force_optional);
  require_unit_or_volts(options.force_unit, Quantity::force, "force_unit");
  options.accel_channels = rejoined_names(options.accel_channels);
  if (!flags.setup_path.empty()) options.setup = acquire::read_channel_setup(flags.setup_path);
  return options;
}

}  // namespace

acquire::ReadOptions resolved_read_options(const ReadFlags& flags) {
  require_rate(flags);
  return options_of(flags);
}

acquire::ReadOptions read_options_of_file(const acquire::ReadOptions& all, std::size_t index, std::size_t files) {
  acquire::ReadOptions options = all;
  if (options.force_scale.size() > 1) {
    if (options.force_scale.size() != files) {
      throw OptionError({"force_scale"}, fmt::format("has {} values for {} files", options.force_scale.size(), files),
                        "give one value, or one per file");
    }
    options.force_scale = {all.force_scale[index]};
  }
  return options;
}

acquire::FrfReadOptions frf_read_options(const ReadFlags& flags, const acquire::ReadOptions& options) {
  return {.read = options, .kind = flags.frf_kind, .averages = flags.averages};
}

acquire::FrfReadOptions per_file_read_options(const ReadFlags& flags) {
  return frf_read_options(flags, read_options_of_file(options_of(flags), 0, 1));
}

}  // namespace percuss::tools
