#include "cli/read_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "acquire/channels/channel_setup.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr double kMilli = 1e-3;

void require_unit_or_volts(const std::string& name, Quantity wanted, const char* option) {
  const auto unit = parse_unit(name);
  const bool volts = unit && unit->quantity == Quantity::voltage;
  if (!name.empty() && !volts) require_unit(name, wanted, option);
}

acquire::FileGrouping files_mean(const std::string& text) {
  if (text == "hits") return acquire::FileGrouping::hits;
  return text == "points" ? acquire::FileGrouping::points : acquire::FileGrouping::tests;
}

// A number, or else a name.
void take_rate(const std::string& text, acquire::ReadOptions& options) {
  const ParsedNumber number = parse_number(text, false);
  if (number.problem == NumberProblem::none || number.problem == NumberProblem::not_finite) {
    options.fs_Hz = number.problem == NumberProblem::none ? number.value : 0;
  } else {
    options.fs_variable = text;
  }
}

// Commas stand between names, and within a column of a MAT variable: "data(:,2)".
std::vector<std::string> whole_names(const std::vector<std::string>& pieces) {
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
  const std::string others = command.heading(kReadingHeading);
  command
      .value(
          "--fs", [&options](const std::string& text) { take_rate(text, options); },
          "Sampling rate, whatever the file says; or the variable of a MAT file that holds it")
      .type("HZ");
  command.value("--df", options.df_Hz, "Spacing of FRFs, for files that do not state their frequencies (MAT)")
      .above_zero()
      .type("HZ");
  command.value("--force-channel", options.force_channel, "The force: name of its column, or number, counted from 1")
      .type("NAME");
  command
      .list("--accel-channel", options.accel_channels,
            "The accelerations, in this order: names or numbers (repeatable, or a list)")
      .type("NAME,...");
  command.value("--unit", options.accel_unit, "Unit of the stored accelerations: m/s^2, g, cm/s^2, V, ...")
      .type("UNIT");
  command.value("--force-unit", options.force_unit, "Unit of the stored forces: N, lbf, V, ...").type("UNIT");
  command.list("--force-scale", options.force_scale, "N per stored unit; one, or one per file").type("N,...");
  command.list("--accel-scale", options.accel_scale, "m/s^2 per stored unit; one, or one per channel").type("X,...");
  command
      .value("--force-sensitivity", flags.force_sensitivity_mV_per_N,
             "Sensitivity of the hammer, for forces stored in volts")
      .type("mV/N");
  command
      .list("--accel-sensitivity", flags.accel_sensitivity_mV_per_g,
            "Sensitivity of the accelerometers, for accelerations stored in volts; one, or one per channel")
      .type("mV/g,...");
  command.list("--angle", flags.angle_deg, "Angle of each accelerometer around the barrel").type("DEG,...").finite();
  command.list("--position", flags.position_m, "Distance of each accelerometer from the barrel's end")
      .type("M,...")
      .finite();
  command
      .value(
          "--frf-kind", [&flags](const std::string& text) { flags.frf_kind = frf::parse_frf_kind(text); },
          "What files of FRFs hold, whatever they say")
      .one_of({"accelerance", "mobility", "receptance"});
  command.heading(others);
}

void add_setup_option(Command& command, ReadFlags& flags) {
  const std::string others = command.heading(kReadingHeading);
  command.value("--setup", flags.setup_path, "Channel set-up (JSON; percuss info --example prints one)").type("FILE");
  command.heading(others);
}

void add_trust_input_option(Command& command, ReadFlags& flags) {
  const std::string others = command.heading(kReadingHeading);
  command.flag("--trust-input", flags.trust_input,
               "Read MAT and HDF5 files in this process, not in a confined one of their own");
  command.heading(others);
}

void add_read_flags(Command& command, ReadFlags& flags, Reads reads) {
  flags.host = command.host();
  command.words("FILE", flags.paths,
                reads == Reads::records
                    ? "Records to read: HDF5, MAT, UFF, LabVIEW, sound, CSV or text; - is standard input"
                    : "Records to read, or FRFs: HDF5, MAT, UFF, LabVIEW, sound, CSV or text; - is standard input");
  add_reading_options(command, flags);
  add_setup_option(command, flags);
  const std::string others = command.heading(kReadingHeading);
  command
      .value(
          "--files", [&flags](const std::string& text) { flags.files = files_mean(text); },
          "What several files are: hits of one test, one point each, or tests of their own (default: hits where rates "
          "and channels "
          "agree)")
      .one_of({"hits", "points", "tests"});
  command.heading(others);
  add_trust_input_option(command, flags);
}

namespace {

// A rate that is a name is a variable's, which only MAT files have.
void require_rate(const ReadFlags& flags) {
  const bool has_variables = std::any_of(flags.paths.begin(), flags.paths.end(),
                                         [](const auto& path) { return extension_of(path) == ".mat"; });
  if (flags.options.fs_variable.empty() || has_variables) return;
  throw UsageError(fmt::format("--fs cannot be \"{}\"", one_line(flags.options.fs_variable, 40)),
                   "give a number in Hz (with a MAT file also the name of a variable)");
}

acquire::ReadOptions worked_out(const ReadFlags& flags) {
  acquire::ReadOptions options = flags.options;
  options.sandboxed = !flags.trust_input;
  for (const double angle_deg : flags.angle_deg) options.angle_rad.push_back(angle_deg * kDegree_rad);
  options.position_m = flags.position_m;
  if (flags.force_sensitivity_mV_per_N) options.force_sensitivity_V_per_N = *flags.force_sensitivity_mV_per_N * kMilli;
  for (const double mV_per_g : flags.accel_sensitivity_mV_per_g) {
    options.accel_sensitivity_V_per_mps2.push_back(mV_per_g * kMilli / kStandardGravity_mps2);
  }
  require_unit_or_volts(options.accel_unit, Quantity::acceleration, "--unit");
  require_unit_or_volts(options.force_unit, Quantity::force, "--force-unit");
  options.accel_channels = whole_names(options.accel_channels);
  if (!flags.setup_path.empty()) options.setup = acquire::read_channel_setup(flags.setup_path);
  return options;
}

}  // namespace

acquire::ReadOptions resolved_read_options(const ReadFlags& flags) {
  require_rate(flags);
  return worked_out(flags);
}

acquire::ReadOptions read_options_of_file(const acquire::ReadOptions& all, std::size_t index, std::size_t files) {
  acquire::ReadOptions options = all;
  if (options.force_scale.size() > 1) {
    if (options.force_scale.size() != files) {
      throw UsageError(fmt::format("{} values of --force-scale for {} files", options.force_scale.size(), files),
                       "give one for all or one per file");
    }
    options.force_scale = {all.force_scale[index]};
  }
  return options;
}

frf::FrfReadOptions per_file_read_options(const ReadFlags& flags) {
  return {.read = read_options_of_file(worked_out(flags), 0, 1), .kind = flags.frf_kind};
}

}  // namespace percuss::tools
