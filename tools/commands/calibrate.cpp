#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "acquire/calibrate.hpp"
#include "cli/open_files.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/units.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

struct CalibrateFlags {
  ReadFlags read;
  OutputFlags output;
  double mass_kg = 0;
  std::optional<double> trigger;
};

nlohmann::ordered_json json_of(const CalibrateFlags& flags, const acquire::Record& record,
                               const acquire::Calibration& calibration) {
  nlohmann::ordered_json json{
      {"schema", "percuss/calibration/1"}, {"version", report::version()}, {"inputs", nlohmann::ordered_json::array()}};
  for (const acquire::InputFile& file : record.files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  json["mass_kg"] = flags.mass_kg;
  json["n_per_unit"] = std::abs(calibration.scale);
  json["polarity"] = calibration.scale < 0 ? -1 : 1;
  json["force_scale"] = calibration.scale;
  json["force_scale_std"] = calibration.scale_std;
  json["hits"] = nlohmann::ordered_json::array();
  for (const acquire::CalibrationHit& hit : calibration.hits) {
    nlohmann::ordered_json row{{"index", hit.index},
                               {"time_s", hit.time_s},
                               {"peak_force", hit.peak_force},
                               {"peak_acceleration_mps2", hit.peak_accel_mps2},
                               {"samples", hit.samples},
                               {"scale", hit.scale},
                               {"scale_std", hit.scale_std},
                               {"ringing", hit.ringing},
                               {"used", hit.used}};
    json["hits"].push_back(std::move(row));
  }
  return json;
}

std::string text_of(const CalibrateFlags& flags, const acquire::Record& record,
                    const acquire::Calibration& calibration) {
  const acquire::SignalInfo& force = record.force;
  const std::string unit = force.unit.empty() || force.unit_assumed ? "unit" : one_line(force.unit, 20);
  report::TextTable table({{"hit", report::TextTable::Align::right},
                           {"time", report::TextTable::Align::right},
                           {"force peak, " + unit, report::TextTable::Align::right},
                           {"acceleration", report::TextTable::Align::right},
                           {"N per " + unit, report::TextTable::Align::right},
                           {""}});
  for (const acquire::CalibrationHit& hit : calibration.hits) {
    table.add({fmt::format("{}", hit.index + 1), fmt::format("{:.3f} s", hit.time_s),
               fmt::format("{:.5g}", hit.peak_force), fmt::format("{:.4g} m/s²", hit.peak_accel_mps2),
               report::value_with_std(hit.scale, hit.scale_std), hit.used ? "" : "not used: too weak"});
  }
  return fmt::format("{}   {} kg free mass\n\n", record.source(), flags.mass_kg) + table.text(terminal_width()) +
         fmt::format("\n1 {} of the force channel is {} N{}: use --force-scale {:.8g}\n", unit,
                     report::value_with_std(std::abs(calibration.scale), calibration.scale_std),
                     calibration.scale < 0 ? ", and it reads pushes as negative" : "", calibration.scale);
}

// Converts the scale to N per unit of the stored numbers, as --force-scale takes it. The calibration used SI units: a
// record stored in mV is read in V.
void convert_to_stored_unit(acquire::Calibration& calibration, double to_SI) {
  calibration.scale *= to_SI;
  calibration.scale_std *= std::abs(to_SI);
  for (acquire::CalibrationHit& hit : calibration.hits) {
    hit.peak_force /= to_SI;
    hit.scale *= to_SI;
    hit.scale_std *= std::abs(to_SI);
  }
}

// A record in N is already scaled. A further scale would multiply the first.
void require_uncalibrated(const CalibrateFlags& flags, const acquire::Record& record,
                          const acquire::Calibration& calibration) {
  const auto unit = parse_unit(record.force.unit);
  const bool stated = !flags.read.options.force_unit.empty() || !flags.read.options.force_scale.empty() ||
                      flags.read.force_sensitivity_mV_per_N.has_value() || !flags.read.setup_path.empty();
  if (stated || record.force.unit_assumed || !unit || unit->quantity != Quantity::force) return;
  throw InputError(fmt::format("the force channel {} is in {} already; by this mass, 1 N of the file is {} N",
                               one_line(record.force.name, 40), record.force.unit,
                               report::value_with_std(std::abs(calibration.scale), calibration.scale_std)),
                   record.source(), "state the unit of the force if the file's is wrong", {"force_unit"});
}

int calibrate_file(const CalibrateFlags& flags) {
  check_outputs(flags.output, {".json"});
  const acquire::Record record = acquire::join_records(open_records(flags.read), flags.read.files);
  const double to_SI = record.force.to_SI;
  std::optional<double> trigger = flags.trigger;
  if (trigger) *trigger *= std::abs(to_SI);
  acquire::Calibration calibration = acquire::calibrate(record, flags.mass_kg, {.trigger_N = trigger});
  require_uncalibrated(flags, record, calibration);
  convert_to_stored_unit(calibration, to_SI);
  const std::string document =
      json_of(flags, record, calibration).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  OutputGroup outputs;
  for (const std::string& path : flags.output.paths) write_file(path, document, flags.output.force);
  outputs.commit();
  print(flags.output, flags.output.json ? document : text_of(flags, record, calibration));
  return kOk;
}

}  // namespace

void add_calibrate(CommandLine& line) {
  auto flags = line.values<CalibrateFlags>();
  Command command = line.command("calibrate", "Calibrate the force channel from hits on a free mass",
                                 [flags] { return calibrate_file(*flags); });
  command.about(
      "A freely hanging mass accelerates by force / mass under a hit. Computes the N per unit of the force channel "
      "from the measured acceleration, with its standard deviation. The unit is the one of the stored numbers, such as "
      "mV. The last line of the printed text states the --force-scale to use. The force may be stored in any unit; the "
      "options under Reading set the unit of the acceleration.");
  command.example("percuss calibrate hits.csv --mass 1.25 --force-channel CH8",
                  "Calibrate with a mass of 1.25 kg; the hammer is in column CH8");
  command.example("percuss calibrate hits.csv --mass 1.25 --force-channel CH8 -o hammer.json",
                  "Write the result as a document");
  add_read_flags(command, flags->read, Reads::records);
  add_output_flags(command, flags->output, {".json"});
  command.value("--mass", flags->mass_kg, "Set the free mass, including its accelerometer")
      .type("KG")
      .required()
      .above_zero();
  command
      .value("--trigger", flags->trigger,
             "Detect a hit above this reading, in the unit of the force channel (default: from the noise)")
      .above_zero()
      .type("READING");
}

}  // namespace percuss::tools
