#include "acquire/channels/channel_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"
#include "core/io/json_text.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxSetup_bytes = std::uint64_t{1} << 20U;
constexpr int kMaxDepth = 16;
constexpr std::size_t kMaxChannels = 4096;

constexpr std::array<std::string_view, 10> kSetupKeys = {"name",      "role",       "sign",        "direction",
                                                         "angle_deg", "position_m", "sensitivity", "sensitivity_unit",
                                                         "unit",      "instrument"};

Json entries_of(std::string_view text, const std::string& where) {
  if (text.size() > kMaxSetup_bytes) throw InputError("longer than 1 MiB", where, "keep only the channels' entries");
  return parse_json<nlohmann::json>({.text = text,
                                     .where = where,
                                     .remedy = "compare it with a valid example",
                                     .options = {"info.example"},
                                     .max_depth = kMaxDepth});
}

// One entry, and its place in messages: "[2].sign".
class Entry {
 public:
  Entry(const Json& json, std::size_t index, const std::string& file)
      : json_(json), place_(fmt::format("{}: [{}]", file, index)) {}

  std::string where(std::string_view key = {}) const { return key.empty() ? place_ : place_ + "." + std::string(key); }
  bool has(const char* key) const { return json_.contains(key); }

  std::optional<std::string> text(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) return std::nullopt;
    if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
      throw InputError("no text", where(key), "put a text in double quotes");
    }
    return found->get<std::string>();
  }

  // A name, or the number of a channel.
  std::string name() const {
    const auto found = json_.find("name");
    if (found == json_.end()) throw InputError("no name", where(), "give the column's name or number as \"name\"");
    return found->is_number_unsigned() ? found->dump() : *text("name");
  }

  std::optional<double> number(const char* key, double lowest, double highest) const {
    const auto found = json_.find(key);
    if (found == json_.end()) return std::nullopt;
    if (!found->is_number()) throw InputError("not a number", where(key), "write it without quotes");
    const double value = found->get<double>();
    if (value >= lowest && value <= highest) return value;
    throw InputError(fmt::format("{:g} is out of range", value), where(key),
                     fmt::format("give {:g} to {:g}", lowest, highest));
  }

 private:
  const Json& json_;
  std::string place_;
};

void require_known_keys(const Json& json, const Entry& entry) {
  if (!json.is_object()) throw InputError("not an object", entry.where(), "write {\"name\": ..., ...} per channel");
  for (const auto& item : json.items()) {
    if (std::find(kSetupKeys.begin(), kSetupKeys.end(), item.key()) != kSetupKeys.end()) continue;
    throw InputError("unknown key", entry.where(one_line(item.key(), 40)),
                     fmt::format("use one of {}", fmt::join(kSetupKeys, ", ")));
  }
}

std::string read_role(const Entry& entry) {
  std::string role = entry.text("role").value_or("");
  if (role.empty() || role == "force" || role == "acceleration" || role == "ignore") return role;
  throw InputError("unknown role \"" + one_line(role, 40) + "\"", entry.where("role"),
                   "use force, acceleration or ignore");
}

// Sets the sign, and the axis where a direction states it.
void read_direction(const Entry& entry, ChannelSetup& setup) {
  const auto direction = entry.text("direction");
  if (direction && entry.has("sign")) throw InputError("sign and direction are both given", entry.where(), "keep one");
  if (direction) {
    const bool signed_axis = direction->size() == 2 && (direction->front() == '+' || direction->front() == '-');
    if (!signed_axis || direction->back() < 'x' || direction->back() > 'z') {
      throw InputError("unknown direction \"" + one_line(*direction, 40) + "\"", entry.where("direction"),
                       "use +x, -x, +y, -y, +z or -z");
    }
    setup.sign = direction->front() == '-' ? -1 : 1;
    setup.axis = Direction{};
    setup.axis->at(static_cast<std::size_t>(direction->back() - 'x')) = 1;
    return;
  }
  setup.sign = entry.number("sign", -1, 1).value_or(1);
  if (setup.sign != 1 && setup.sign != -1)
    throw InputError(fmt::format("{:g} is not a sign", setup.sign), entry.where("sign"), "give 1 or -1");
}

// Volts per SI unit, and the quantity of that unit.
struct Sensitivity {
  double V_per_SI = 0;
  Quantity to = Quantity::acceleration;
};

// "mV/N" → 1e-3 V/N; "V/(m/s^2)", "mV/g", "mV/Pa". Charge is refused: its amplifier's gain is not in the sensor's data
// sheet.
Sensitivity volts_per_SI(const std::string& unit, const std::string& role, const std::string& where) {
  if (unit.substr(0, 2) == "pC") {
    throw InputError("a sensitivity in charge, but samples are volts", where,
                     "give the sensitivity at the amplifier's output, such as mV/N");
  }
  const std::string shown = "\"" + one_line(unit, 40) + "\"";
  const auto slash = std::min(unit.find('/'), unit.size());
  const Unit none{Quantity::mass, 1};
  const Unit volts = parse_unit(unit.substr(0, slash)).value_or(none);
  const Unit per = parse_unit(unit.substr(std::min(slash + 1, unit.size()))).value_or(none);
  const bool force = per.quantity == Quantity::force;
  const bool response = is_response(per.quantity);
  if (volts.quantity != Quantity::voltage || (!force && !response)) {
    throw InputError("unknown sensitivity unit " + shown, where, "use mV/N, mV/lbf, mV/g, V/(m/s^2) or mV/Pa");
  }
  if ((role == "force" && !force) || (role == "acceleration" && force)) {
    throw InputError(shown + " does not fit the role " + role, where, force ? "use mV/g or mV/Pa" : "use mV/N");
  }
  return {.V_per_SI = volts.to_SI / per.to_SI, .to = per.quantity};
}

std::optional<Sensitivity> read_sensitivity(const Entry& entry, const std::string& role) {
  constexpr double kMaxValue = 1e9;
  const auto value = entry.number("sensitivity", -kMaxValue, kMaxValue);
  const auto unit = entry.text("sensitivity_unit");
  if (!value && !unit) return std::nullopt;
  if (!value || !unit)
    throw InputError("only one of sensitivity and sensitivity_unit is given", entry.where(), "give both");
  if (std::abs(*value) < 1 / kMaxValue)
    throw InputError("a sensitivity of zero", entry.where("sensitivity"), "see the sensor's data sheet");
  Sensitivity out = volts_per_SI(*unit, role, entry.where("sensitivity_unit"));
  out.V_per_SI *= *value;
  return out;
}

ChannelSetup read_entry(const Json& json, std::size_t index, const std::string& file) {
  const Entry entry(json, index, file);
  require_known_keys(json, entry);
  ChannelSetup setup;
  setup.name = entry.name();
  setup.role = read_role(entry);
  read_direction(entry, setup);
  if (const auto angle_deg = entry.number("angle_deg", -360, 360)) setup.angle_rad = *angle_deg * kDegree_rad;
  setup.position_m = entry.number("position_m", -1000, 1000);
  if (const auto sensitivity = read_sensitivity(entry, setup.role)) {
    setup.sensitivity_V_per_SI = sensitivity->V_per_SI;
    setup.sensitivity_to = sensitivity->to;
  }
  setup.unit = entry.text("unit");
  if (setup.unit && !parse_unit(*setup.unit)) {
    throw InputError("unknown unit \"" + one_line(*setup.unit, 40) + "\"", entry.where("unit"),
                     "use N, lbf, m/s^2, g, V or mV, for instance");
  }
  entry.text("instrument");  // only checked here: reports take it from instruments_of_setup
  return setup;
}

}  // namespace

std::vector<ChannelSetup> parse_channel_setup(std::string_view json, const std::string& where) {
  const Json document = entries_of(json, where);
  if (!document.is_array() || document.empty())
    throw InputError("not an array of channels", where, "write [{\"name\": ...}, ...]");
  if (document.size() > kMaxChannels)
    throw InputError("more than 4096 channels", where, "keep only the channels that are used");
  std::vector<ChannelSetup> setup;
  std::set<std::string> names;
  std::size_t forces = 0;
  for (std::size_t i = 0; i < document.size(); ++i) {
    setup.push_back(read_entry(document[i], i, where));
    const auto place = fmt::format("{}: [{}].", where, i);
    if (!names.insert(lower_case(setup.back().name)).second) {
      throw InputError("two entries for \"" + one_line(setup.back().name, 40) + "\"", place + "name", "keep one");
    }
    if (setup.back().role == "force" && ++forces > 1)
      throw InputError("a second force", place + "role", "give the role force to one channel only");
  }
  return setup;
}

std::vector<ChannelSetup> read_channel_setup(const std::string& path) {
  return parse_channel_setup(read_input(path, kMaxSetup_bytes).view(), input_name(path));
}

std::vector<ChannelInstrument> instruments_of_setup(const std::string& path) {
  const Json document = entries_of(read_input(path, kMaxSetup_bytes).view(), input_name(path));
  std::vector<ChannelInstrument> instruments;
  for (std::size_t i = 0; i < document.size(); ++i) {
    const Entry entry(document[i], i, path);
    if (const auto instrument = entry.text("instrument")) instruments.push_back({entry.name(), *instrument});
  }
  return instruments;
}

std::string channel_setup_example() {
  return R"([
  {"name": "CH1", "role": "force", "sensitivity": 2.25, "sensitivity_unit": "mV/N", "unit": "V",
   "instrument": "hammer 086C03, no. 12345"},
  {"name": "CH2", "role": "acceleration", "direction": "+x", "angle_deg": 0, "position_m": 0.15,
   "sensitivity": 10.2, "sensitivity_unit": "mV/g", "unit": "V"},
  {"name": "CH3", "role": "acceleration", "sign": -1, "angle_deg": 90, "position_m": 0.15,
   "sensitivity": 9.8, "sensitivity_unit": "mV/g", "unit": "V"}
]
)";
}

}  // namespace percuss::acquire
