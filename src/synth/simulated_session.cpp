#include "synth/simulated_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/parse_number.hpp"
#include "synth/read_spec.hpp"

namespace percuss::synth {
namespace {

constexpr double kMaxTime_s = 1e7, kMaxBlows = 1e6;
constexpr const char* kRemedy = "correct the description of the simulated device";

SynthSpec spec_of(const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored) && name.find('/') == std::string::npos) return synth_preset(name);
  return parse_synth_spec(read_input(name, kMaxSpec_bytes + 1).view(), name);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

// The options by name. Reading an option removes it; options that remain are unknown.
class SessionOptions {
 public:
  explicit SessionOptions(std::string_view text) : parts_(split(text, ',')) {
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const std::size_t equals = parts_[i].find('=');
      const std::string name(parts_[i].substr(0, equals));
      const bool fresh =
          values_.emplace(name, equals == std::string_view::npos ? std::string_view{} : parts_[i].substr(equals + 1))
              .second;
      if (!fresh) throw InputError("an option is given twice", "sim, " + one_line(name), kRemedy);
    }
  }

  std::string spec() const { return std::string(parts_.front()); }

  bool flag(const char* name) {
    const auto at = values_.find(name);
    if (at == values_.end()) return false;
    if (!at->second.empty()) fail(name, "takes no value");
    values_.erase(at);
    return true;
  }

  std::vector<std::string_view> list(const char* name) {
    const auto at = values_.find(name);
    if (at == values_.end()) return {};
    auto items = split(at->second, '+');
    values_.erase(at);
    return items;
  }

  std::optional<double> number(const char* name, double low, double high) {
    const auto items = list(name);
    if (items.empty()) return {};
    if (items.size() > 1) fail(name, "takes one number");
    return number_in(name, items.front(), low, high);
  }

  std::vector<std::size_t> whole_numbers(const char* name, double low, double high) {
    std::vector<std::size_t> out;
    for (const auto item : list(name)) {
      const double value = number_in(name, item, low, high);
      if (value != std::floor(value)) fail(name, "takes whole numbers");
      out.push_back(static_cast<std::size_t>(value));
    }
    return out;
  }

  // "3:0.5+10:1": from 3 s for 0.5 s, and from 10 s for 1 s.
  std::vector<SimulatedPeriod> periods(const char* name, double usual_s) {
    std::vector<SimulatedPeriod> out;
    for (const auto item : list(name)) {
      const auto ends = split(item, ':');
      if (ends.size() > 2) fail(name, "takes times as FROM:SECONDS");
      out.push_back({number_in(name, ends[0], 0, kMaxTime_s),
                     ends.size() > 1 ? number_in(name, ends[1], 0, kMaxTime_s) : usual_s});
    }
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.from_s < b.from_s; });
    return out;
  }

  void finish() const {
    if (!values_.empty()) fail(values_.begin()->first.c_str(), "is no option");
  }

  [[noreturn]] static void fail(const char* name, const char* problem) {
    throw InputError(one_line(name) + " " + problem, "sim", kRemedy);
  }

 private:
  static double number_in(const char* name, std::string_view text, double low, double high) {
    const ParsedNumber parsed = parse_number(text, false);
    if (parsed.problem != NumberProblem::none || parsed.value < low || parsed.value > high)
      fail(name, fmt::format("is no number from {:.6g} to {:.6g}", low, high).c_str());
    return parsed.value;
  }

  std::vector<std::string_view> parts_;
  std::map<std::string, std::string_view> values_;
};

// The faulty blows, by their number from 1.
std::map<std::size_t, BlowKind> faulty_blows(SessionOptions& options) {
  std::map<std::size_t, BlowKind> kinds;
  const auto add = [&](const char* name, BlowKind kind) {
    for (const std::size_t number : options.whole_numbers(name, 1, kMaxBlows)) {
      if (!kinds.emplace(number, kind).second) SessionOptions::fail(name, "names a blow that has another fault");
    }
  };
  add("weak", BlowKind::weak);
  add("double", BlowKind::double_hit);
  add("clipped", BlowKind::clipped);
  add("late", BlowKind::late);
  return kinds;
}

// A faulty blow does not count towards the hits of its point: the tester strikes again. A late blow counts.
void plan_blows(SessionOptions& options, SimulatedSession& session) {
  std::vector<std::size_t> points =
      options.whole_numbers("points", 0, static_cast<double>(session.spec.points.size() - 1));
  if (points.empty()) {
    points.resize(session.spec.points.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
  }
  const auto hits =
      static_cast<std::size_t>(options.number("hits", 1, kMaxBlows).value_or(static_cast<double>(session.spec.hits)));
  if (static_cast<double>(points.size()) * static_cast<double>(hits) > kMaxBlows)
    SessionOptions::fail("hits", "makes more than a million blows");
  const double every_s = options.number("every", 0.01, kMaxTime_s).value_or(2);
  double next_s = options.number("first", 0, kMaxTime_s).value_or(1);
  const std::vector<SimulatedPeriod> silences = options.periods("silence", 60);
  const auto faults = faulty_blows(options);
  for (const std::size_t point : points) {
    for (std::size_t good = 0; good < hits;) {
      for (const auto& silence : silences) {
        if (next_s >= silence.from_s && next_s < silence.from_s + silence.for_s)
          next_s = silence.from_s + silence.for_s;
      }
      const auto fault = faults.find(session.blows.size() + 1);
      const BlowKind kind = fault == faults.end() ? BlowKind::good : fault->second;
      session.blows.push_back({next_s + (kind == BlowKind::late ? every_s / 2 : 0), point, kind});
      if (kind == BlowKind::good || kind == BlowKind::late) ++good;
      next_s += every_s;
    }
  }
  constexpr double kAfterLast_s = 5;
  session.end_s = options.number("end", 0, kMaxTime_s).value_or(next_s - every_s + std::max(kAfterLast_s, every_s));
}

// The band of a spec only marks modes in the truth document. At a lower sampling rate, it ends at half that rate.
void change_rate(SynthSpec& spec, double fs_Hz) {
  if (fs_Hz == spec.fs_Hz) return;
  spec.fs_Hz = fs_Hz;
  spec.band_high_Hz = std::min(spec.band_high_Hz, fs_Hz / 2);
}

}  // namespace

SimulatedSession parse_simulated_session(std::string_view text, const acquire::DeviceOptions& device) {
  SessionOptions options(text);
  SimulatedSession session{.spec = spec_of(options.spec())};
  if (const auto seed = options.number("seed", 0, 1e15)) session.spec.seed = static_cast<std::uint64_t>(*seed);
  const auto rate_Hz = options.number("fs", 100, 1e6);
  change_rate(session.spec, device.fs_Hz.value_or(rate_Hz.value_or(session.spec.fs_Hz)));
  validate(session.spec, "sim");
  plan_blows(options, session);
  session.gaps = options.periods("gap", 2);
  session.overruns = options.periods("overrun", 0.01);
  session.overloads = options.periods("overload", 0.01);
  session.no_numbers = options.periods("nan", 0.001);
  session.dropouts = options.periods("dropout", 0.05);
  session.unplug_s = options.number("unplug", 0, kMaxTime_s);
  session.rate_change_s = options.number("rate", 0, kMaxTime_s);
  session.numbered = options.flag("numbered");
  session.fast = options.flag("fast") || device.fast;
  session.speed = options.number("speed", 0.01, 1000).value_or(1);
  constexpr double kMaxChannels = 256;
  const auto sensors = static_cast<double>(session.spec.sensors.size());
  session.accels = static_cast<std::size_t>(options.number("accels", 1, kMaxChannels).value_or(sensors));
  for (const std::size_t channel : options.whole_numbers("silent", 1, static_cast<double>(session.accels) + 1))
    session.silent_channels.push_back(channel - 1);
  options.finish();
  return session;
}

}  // namespace percuss::synth
