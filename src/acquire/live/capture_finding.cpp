#include "acquire/live/capture_finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"

namespace percuss::acquire {
namespace {

using Json = nlohmann::ordered_json;

struct FaultName {
  CaptureFault fault;
  const char* name;
};

constexpr std::array kFaultNames = {
    FaultName{CaptureFault::gap, "gap"},
    FaultName{CaptureFault::overrun, "overrun"},
    FaultName{CaptureFault::dropped, "dropped"},
    FaultName{CaptureFault::not_in_journal, "not_in_journal"},
    FaultName{CaptureFault::journal_failed, "journal_failed"},
    FaultName{CaptureFault::clock_drift, "clock_drift"},
    FaultName{CaptureFault::not_a_number, "not_a_number"},
    FaultName{CaptureFault::overload, "overload"},
    FaultName{CaptureFault::unplugged, "unplugged"},
    FaultName{CaptureFault::rate_changed, "rate_changed"},
    FaultName{CaptureFault::failed, "failed"},
    FaultName{CaptureFault::resumed, "resumed"},
};

std::string channel_text(const CaptureFinding& finding) {
  return finding.channel ? fmt::format("channel {}", *finding.channel + 1) : "the device";
}

std::string samples_text(std::uint64_t count) { return fmt::format("{} sample{}", count, count == 1 ? "" : "s"); }

template <class Value>
Value value_or(const nlohmann::json& json, const char* key, Value absent) {
  const auto at = json.find(key);
  return at == json.end() ? absent : at->get<Value>();
}

}  // namespace

const char* fault_name(CaptureFault fault) {
  return std::find_if(kFaultNames.begin(), kFaultNames.end(), [&](const FaultName& w) { return w.fault == fault; })
      ->name;
}

std::string finding_text(const CaptureFinding& f) {
  switch (f.fault) {
    case CaptureFault::gap:
      return fmt::format("a gap of {} frames", f.count);
    case CaptureFault::overrun:
      return f.count > 0 ? fmt::format("the device lost {} frames", f.count) : "the device lost frames";
    case CaptureFault::dropped:
      return f.count > 0 ? fmt::format("{} frames were dropped: the ring buffer was full", f.count)
                         : "frames were dropped: the ring buffer was full";
    case CaptureFault::not_in_journal:
      return fmt::format("{} frames are not in the journal", f.count);
    case CaptureFault::journal_failed:
      return "the journal cannot be written: " + f.text;
    case CaptureFault::clock_drift:
      return fmt::format("the clock of the device differs by {:.0f} ppm from the computer's", f.value * 1e6);
    case CaptureFault::not_a_number:
      return fmt::format("{}: {} not finite", channel_text(f), samples_text(f.count));
    case CaptureFault::overload:
      return fmt::format("{} has {} at full scale", channel_text(f), samples_text(f.count));
    case CaptureFault::unplugged:
      return "the device was unplugged";
    case CaptureFault::rate_changed:
      return "the device changed its sampling rate";
    case CaptureFault::failed:
      return "the device failed";
    case CaptureFault::resumed:
      return "the session was resumed";
  }
  return {};
}

std::string finding_json(const CaptureFinding& finding) {
  Json json{{"fault", fault_name(finding.fault)}, {"frame", finding.frame}};
  if (finding.count > 0) json["count"] = finding.count;
  if (finding.channel) json["channel"] = *finding.channel;
  if (finding.value != 0) json["value"] = finding.value;
  if (!finding.text.empty()) json["text"] = finding.text;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

CaptureFinding parse_finding(const std::string& text, const std::string& where) {
  const auto json = parse_json<nlohmann::json>(
      {.text = text, .where = where, .remedy = "the file is not a journal of this version", .max_depth = 1});
  try {
    const auto name = json.at("fault").get<std::string>();
    const auto* const found =
        std::find_if(kFaultNames.begin(), kFaultNames.end(), [&](const FaultName& w) { return w.name == name; });
    if (found == kFaultNames.end()) throw InputError("an unknown finding", where, "use a newer version");
    CaptureFinding finding{.fault = found->fault};
    finding.frame = value_or<std::uint64_t>(json, "frame", 0);
    finding.count = value_or<std::uint64_t>(json, "count", 0);
    if (json.contains("channel")) finding.channel = json["channel"].get<std::size_t>();
    finding.value = value_or<double>(json, "value", 0);
    finding.text = value_or<std::string>(json, "text", {});
    return finding;
  } catch (const nlohmann::json::exception&) {
    throw InputError("a damaged finding", where, "the file is not a journal of this version");
  }
}

}  // namespace percuss::acquire
