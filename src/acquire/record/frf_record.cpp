#include "frf/formats/frf_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acquire/channels/signal_overrides.hpp"
#include "acquire/formats/hdf5/hdf5_layout.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/formats/text/read_csv.hpp"
#include "acquire/formats/text/read_lvm.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "frf/formats/read_frf_hdf5.hpp"
#include "frf/formats/read_frf_mat.hpp"
#include "frf/formats/read_frf_text.hpp"
#include "frf/formats/read_frf_uff.hpp"
#include "frf/formats/sandbox_measurement.hpp"

namespace percuss::frf {
namespace {

constexpr double kUneven = 0.05;                             // of the spacing: frequencies may be rounded
constexpr double kSameSpacing = 1e-6;                        // relative, between files
constexpr std::size_t kMaxFrfLines = std::size_t{1} << 28U;  // from 0 Hz on, present or not

std::string name_of(const FrfRecord& record) { return input_name(record.source()); }

void refuse_useless(const acquire::ReadOptions& options, const std::string& where) {
  const auto refuse = [&](const char* option, const char* why) {
    throw InputError(fmt::format("{} does not apply to FRFs: {}", option, why), where, "leave it out");
  };
  if (options.fs_Hz) refuse("--fs", "the lines say how long the records were");
  if (options.force_sensitivity_V_per_N || !options.accel_sensitivity_V_per_mps2.empty())
    refuse("a sensitivity", "they are no volts (--accel-scale and --force-scale do)");
}

// Only MAT files have variables that options can name.
void refuse_variable_names(const acquire::ReadOptions& options, const std::string& path) {
  if (options.fs_variable.empty()) return;
  throw InputError("--fs is no number: " + one_line(options.fs_variable, 40), input_name(path),
                   "give it in Hz (in MAT files it may be a variable)");
}

// A variable of FRFs that an option names, or the rate that spaces its lines, has been used up by its reader.
FrfReadOptions without_places(FrfReadOptions options) {
  options.read.fs_Hz.reset();
  options.read.fs_variable.clear();
  std::erase_if(options.read.accel_channels, [](const std::string& name) {
    return name.find_first_not_of("0123456789") != std::string::npos && !name.starts_with("accel");
  });
  return options;
}

// m/s² or its integrals per stored unit of the response; N per stored unit of the force.
double response_factor(const acquire::SignalOverrides& choice, const StoredFrfs& stored, FrfKind kind,
                       const std::string& where) {
  if (choice.scale) return *choice.scale;
  if (!choice.unit.empty()) return require_unit(choice.unit, Quantity::acceleration, where).to_SI;
  return stored.unit && stored.unit->kind == kind ? stored.unit->response_to_SI : 1;
}

double force_factor(const acquire::SignalOverrides& choice, const StoredFrfs& stored, const std::string& where) {
  if (choice.scale) return *choice.scale;
  if (!choice.unit.empty()) return require_unit(choice.unit, Quantity::force, where).to_SI;
  return stored.unit ? stored.unit->force_to_SI : 1;
}

FrfKind kind_of(const StoredFrfs& stored, const FrfReadOptions& options, std::vector<std::string>& notes) {
  const std::optional<FrfKind> stated = stored.unit ? std::optional(stored.unit->kind) : stored.kind;
  if (options.kind) {
    if (stated && *stated != *options.kind) {
      notes.push_back(fmt::format("the file calls itself {}; read as {}, as --frf-kind says", name_of(*stated),
                                  name_of(*options.kind)));
    }
    return *options.kind;
  }
  if (stated) return *stated;
  notes.emplace_back("the kind of the FRFs is not stated: taken as accelerance in (m/s^2)/N (--frf-kind, --unit)");
  return FrfKind::accelerance;
}

// Stored numbers to an accelerance, in place; kind and factor as found.
Frf accelerance_of(StoredFrf stored, const FrfRecord& record, double factor, const std::string& where) {
  Frf frf{.value = std::move(stored.value),
          .std = std::move(stored.std),
          .coherence = std::move(stored.coherence),
          .averages = stored.averages};
  const int order = record.kind == FrfKind::accelerance ? 0 : record.kind == FrfKind::mobility ? 1 : 2;
  for (std::size_t k = 0; k < frf.value.size(); ++k) {
    const Complex s(record.decay_per_s, kTwoPi * record.lines.freq_Hz(k));
    const Complex by = factor * (order == 0 ? Complex(1) : order == 1 ? s : s * s);
    frf.value[k] *= by;
    if (!frf.std.empty()) frf.std[k] *= std::abs(by);
    if (std::abs(frf.value[k]) <= acquire::kMaxSample) continue;
    throw InputError(fmt::format("the FRF at {:.6g} Hz is too large", record.lines.freq_Hz(k)), where,
                     "correct the number or the scale");
  }
  return frf;
}

}  // namespace

FrfRecord to_accelerances(StoredFrfs stored, const FrfReadOptions& options) {
  FrfRecord record = std::move(stored.record);
  const std::string where = name_of(record);
  refuse_useless(options.read, where);
  record.kind = kind_of(stored, options, record.notes);
  const auto channels = acquire::hdf5::chosen_channels(options.read, record.accel.size(), where);
  const acquire::SignalOverrides force =
      acquire::force_overrides(options.read, acquire::hdf5::force_setup(options.read));
  const double below = force.sign * force_factor(force, stored, where);
  std::vector<acquire::SignalInfo> accel;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const acquire::ChannelSetup* setup = acquire::hdf5::accel_setup(options.read, channels[i], record.accel.size());
    const acquire::SignalOverrides choice = acquire::accel_overrides(options.read, setup, i, channels.size());
    acquire::SignalInfo signal = record.accel[channels[i]];
    signal.to_SI = choice.sign * response_factor(choice, stored, record.kind, where) / below;
    if (!std::isfinite(signal.to_SI) || signal.to_SI == 0)
      throw InputError("a scale of zero or beyond any number", where, "give a usable one");
    if (choice.angle_rad) signal.angle_rad = choice.angle_rad;
    if (choice.position_m) signal.position_m = choice.position_m;
    accel.push_back(std::move(signal));
  }
  record.accel = std::move(accel);
  for (StoredFrf& frf : stored.frfs) {
    const auto place = std::find(channels.begin(), channels.end(), frf.channel);
    if (place == channels.end()) continue;
    const auto channel = static_cast<std::size_t>(place - channels.begin());
    record.frfs.push_back({.point = frf.point, .channel = channel, .frf = {}});
    record.frfs.back().frf = accelerance_of(std::move(frf), record, record.accel[channel].to_SI, where);
  }
  std::stable_sort(record.frfs.begin(), record.frfs.end(), [](const PointFrf& a, const PointFrf& b) {
    return a.point != b.point ? a.point < b.point : a.channel < b.channel;
  });
  return record;
}

LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where) {
  const char* const remedy = "save one line per frequency, evenly spaced from 0 Hz or a multiple of the spacing";
  const std::size_t n = freq_Hz.size();
  if (n < 2) throw InputError("fewer than two frequencies", where, remedy);
  const double rough_Hz = (freq_Hz.back() - freq_Hz.front()) / static_cast<double>(n - 1);
  if (!(freq_Hz.front() >= 0) || !(rough_Hz > 0)) throw InputError("frequencies that do not rise", where, remedy);
  const double first = std::round(freq_Hz.front() / rough_Hz);
  if (!(first < static_cast<double>(kMaxFrfLines)))
    throw InputError("frequencies too close together for how high they are", where, remedy);
  const double df_Hz = freq_Hz.back() / (first + static_cast<double>(n - 1));
  for (std::size_t k = 0; k < n; ++k) {
    const double expected_Hz = (first + static_cast<double>(k)) * df_Hz;
    if (std::abs(freq_Hz[k] - expected_Hz) <= kUneven * df_Hz) continue;
    throw InputError(
        fmt::format("the frequency {:.8g} Hz is not a multiple of the spacing of {:.6g} Hz", freq_Hz[k], df_Hz), where,
        remedy);
  }
  LineRange lines{.first = static_cast<std::size_t>(first), .count = n};
  lines.samples = 2 * (lines.first + n - 1);
  lines.fs_Hz = df_Hz * static_cast<double>(lines.samples);
  return lines;
}

std::variant<acquire::Record, FrfRecord> open_measurement(const std::string& path, const FrfReadOptions& options) {
  constexpr std::size_t kHead_bytes = 4096;
  const std::string head = path != "-" ? first_bytes(path, kHead_bytes) : "";
  const bool mat = acquire::is_mat(head);
  if (options.read.sandboxed && path != "-" && (mat || acquire::is_hdf5(path))) {
    FrfReadOptions within = options;
    within.read.sandboxed = false;
    return open_measurement_sandboxed(path, [&] { return open_measurement(path, within); });
  }
  if (!mat) refuse_variable_names(options.read, path);
  if (acquire::is_sound(head)) return acquire::open_record(path, options.read);
  if (mat) {
    acquire::MatFile file = acquire::read_mat_file(path);
    if (auto frfs = read_frf_mat(file, options)) return to_accelerances(std::move(*frfs), without_places(options));
    return acquire::open_mat(std::move(file), options.read);
  }
  if (path != "-" && acquire::is_hdf5(path)) {
    if (auto frfs = read_frf_hdf5(path)) return to_accelerances(std::move(*frfs), options);
    return acquire::open_record(path, options.read);
  }
  const FileBytes text = acquire::read_text(path);
  if (acquire::is_universal_file(text.view())) {
    acquire::UffContents contents = acquire::read_uff_contents(text);
    if (auto frfs = read_frf_uff(text, contents, options.kind.has_value()))
      return to_accelerances(std::move(*frfs), options);
    return acquire::open_uff(text, std::move(contents), options.read);
  }
  if (acquire::is_lvm(text.view())) return acquire::open_lvm(text, options.read);
  if (auto frfs = read_frf_text(text, options.kind.has_value())) return to_accelerances(std::move(*frfs), options);
  return acquire::open_csv(text, options.read);
}

FrfRecord join_frfs(std::vector<FrfRecord> records) {
  FrfRecord out = std::move(records.front());
  const std::vector<std::string> said = out.notes;  // what holds for every file is said once
  for (std::size_t r = 1; r < records.size(); ++r) {
    FrfRecord& next = records[r];
    const bool spaced = std::abs(next.lines.df_Hz() / out.lines.df_Hz() - 1) <= kSameSpacing;
    if (!spaced || next.lines.first != out.lines.first || next.lines.count != out.lines.count) {
      throw InputError(fmt::format("{} lines of {:.6g} Hz from {:.6g} Hz where {} has {} of {:.6g} Hz from {:.6g} Hz",
                                   next.lines.count, next.lines.df_Hz(), next.lines.freq_Hz(0), name_of(out),
                                   out.lines.count, out.lines.df_Hz(), out.lines.freq_Hz(0)),
                       name_of(next), "analyse it by itself, or give --files tests");
    }
    if (next.accel.size() != out.accel.size() || next.decay_per_s != out.decay_per_s) {
      throw InputError(fmt::format("other channels or windows than in {}", name_of(out)), name_of(next),
                       "analyse it by itself, or give --files tests");
    }
    const int after = out.frfs.back().point + 1 - std::min(0, next.frfs.front().point);
    for (PointFrf& frf : next.frfs) {
      frf.point += after;
      out.frfs.push_back(std::move(frf));
    }
    for (const std::string& note : next.notes) {
      if (std::find(said.begin(), said.end(), note) == said.end()) out.notes.push_back(name_of(next) + ": " + note);
    }
    out.files.insert(out.files.end(), next.files.begin(), next.files.end());
    if (next.format != out.format) out.format = "several";
  }
  return out;
}

}  // namespace percuss::frf
