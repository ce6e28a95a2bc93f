#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "acquire/live/list_devices.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/record/devices_text.hpp"
#include "core/error.hpp"
#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

struct DevicesFlags {
  bool json = false;
  Host* host = nullptr;
};

Json optional_number(double value) { return value > 0 ? Json(value) : Json(nullptr); }

Json front_end_json(const std::optional<acquire::UsbFrontEnd>& front_end) {
  if (!front_end) return nullptr;
  return {{"model", front_end->model},
          {"serial", front_end->serial},
          {"calibrated", front_end->calibrated},
          {"unit", front_end->unit},
          {"full_scale", front_end->full_scales}};
}

bool can_record(const acquire::ListedDevice& device) { return device.problem.empty(); }

std::string document(const std::vector<acquire::ListedDevice>& devices) {
  Json list = Json::array();
  for (const auto& device : devices) {
    list.push_back({{"device", device.spec},
                    {"name", device.name},
                    {"host", device.host},
                    {"channels", device.channels > 0 ? Json(device.channels) : Json(nullptr)},
                    {"default_fs_hz", optional_number(device.default_fs_Hz)},
                    {"rates_hz", device.rates_Hz},
                    {"front_end", front_end_json(device.front_end)},
                    {"problem", can_record(device) ? Json(nullptr) : Json(device.problem)}});
  }
  const bool any = std::any_of(devices.begin(), devices.end(), can_record);
  return Json{{"schema", "percuss/devices/1"},
              {"devices", list},
              {"advice", any ? Json(nullptr) : Json(acquire::advice_without_devices(devices))}}
             .dump(1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

std::string rates_text(const acquire::ListedDevice& device) {
  if (device.rates_Hz.empty()) return "";
  const auto [low, high] = std::minmax_element(device.rates_Hz.begin(), device.rates_Hz.end());
  return *low == *high ? fmt::format("{:.10g}", *low) : fmt::format("{:.10g} to {:.10g}", *low, *high);
}

std::string remark(const acquire::ListedDevice& device) {
  if (!can_record(device)) return device.problem;
  if (!device.front_end) return "";
  return fmt::format("{} {}, full scale {:.4g} {}", one_line(device.front_end->model),
                     one_line(device.front_end->serial), device.front_end->full_scales[0], device.front_end->unit);
}

int run_devices(const DevicesFlags& flags) {
  const auto devices = acquire::list_devices();
  print({.host = flags.host}, flags.json ? document(devices) : devices_text(devices, terminal_width()));
  return kOk;
}

}  // namespace

std::string devices_text(const std::vector<acquire::ListedDevice>& devices, std::size_t width) {
  using Align = report::TextTable::Align;
  report::TextTable table({{"device"}, {"channels", Align::right}, {"rates/Hz", Align::right}, {""}});
  for (const auto& device : devices)
    table.add({one_line(device.spec, 80), device.channels > 0 ? fmt::format("{}", device.channels) : "-",
               rates_text(device), remark(device)});
  std::string text = devices.empty() ? "" : table.text(width);
  if (!std::any_of(devices.begin(), devices.end(), can_record)) text += acquire::advice_without_devices(devices) + "\n";
  return text;
}

void add_devices(CommandLine& line) {
  auto flags = line.values<DevicesFlags>();
  Command command =
      line.command("devices", "List the devices that can record", [flags] { return run_devices(*flags); });
  flags->host = command.host();
  command.about(
      "Lists sound cards and USB front ends with their channels and common sampling rates. A front end for IEPE "
      "sensors states its calibration itself. A device that cannot record at present is listed with the reason. The "
      "first column is what percuss record --device takes. docs/guides/recording-devices.md describes other sources of "
      "samples: simulated devices, files, pipes and plug-ins.");
  command.example("percuss devices", "List what can record");
  command.example("percuss devices --json", "Print a document with every rate and the calibration");
  command.flag("--json", flags->json, "Print one JSON document");
}

}  // namespace percuss::tools
