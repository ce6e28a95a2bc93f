#include "acquire/channels/stored_frfs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "acquire/channels/named_channels.hpp"
#include "acquire/channels/signal_overrides.hpp"
#include "acquire/record/note_codes.hpp"
#include "acquire/record/note_on_rounding.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

void refuse_inapplicable_options(const ReadOptions& options, const std::string& where) {
  if (options.fs_Hz) {
    throw InputError("a sampling rate does not apply to FRFs, whose frequencies are stored", where, "leave it out",
                     {"fs"});
  }
  if (options.force_sensitivity_V_per_N || !options.accel_sensitivity_V_per_mps2.empty() ||
      !options.pressure_sensitivity_V_per_Pa.empty()) {
    throw InputError("a sensitivity does not apply to FRFs, which are not in volts", where, "give scales instead",
                     {"accel_scale", "force_scale"});
  }
}

// Takes the spacing that the user states, within the limits of the file's frequencies.
void apply_spacing(const StoredFrfs& stored, const std::optional<double>& df_Hz, const std::string& where,
                   FrfRecord& record) {
  if (!df_Hz && !stored.spacing_note.empty()) {
    const double df_now_Hz = record.lines.df_Hz();
    const double error_Hz =
        stored.spacing ? std::max(df_now_Hz - stored.spacing->lowest_Hz, stored.spacing->highest_Hz - df_now_Hz)
                       : df_now_Hz;
    record.notes.push_back(note_on_rounding(stored.spacing_note, error_Hz / df_now_Hz, "df"));
  }
  if (!df_Hz || !stored.spacing) return;
  if (!(*df_Hz >= stored.spacing->lowest_Hz && *df_Hz <= stored.spacing->highest_Hz)) {
    throw InputError(
        fmt::format("a spacing of {:.10g} Hz contradicts the frequencies of the file, which are {:.10g} Hz apart",
                    *df_Hz, record.lines.df_Hz()),
        where, "leave it out", {"df"});
  }
  record.lines.fs_Hz = *df_Hz * static_cast<double>(record.lines.samples);
}

// SI units of the response (m/s², m/s or m) per stored unit.
double response_factor(const SignalOverrides& choice, const StoredFrfs& stored, FrfKind kind,
                       const std::string& where) {
  if (choice.scale) return *choice.scale;
  if (!choice.unit.empty()) {
    if (kind != FrfKind::accelerance) {
      throw InputError(fmt::format("a unit of acceleration does not apply to the responses of a {}", name_of(kind)),
                       where, "state their scale instead", {"accel_scale"});
    }
    return require_unit(choice.unit, Quantity::acceleration, where).to_SI;
  }
  return stored.unit && stored.unit->kind == kind ? stored.unit->response_to_SI : 1;
}

// N per stored unit of the force.
double force_factor(const SignalOverrides& choice, const StoredFrfs& stored, const std::string& where) {
  if (choice.scale) return *choice.scale;
  if (!choice.unit.empty()) return require_unit(choice.unit, Quantity::force, where).to_SI;
  return stored.unit ? stored.unit->force_to_SI : 1;
}

// "(m/s^2)/N", or the units that the options state for all channels.
std::string assumed_unit(const ReadOptions& options) {
  const std::string response = options.accel_unit.empty() ? "m/s^2" : options.accel_unit;
  const std::string force = options.force_unit.empty() ? "N" : options.force_unit;
  return response.find('/') == std::string::npos ? response + "/" + force : "(" + response + ")/" + force;
}

FrfKind frf_kind_of(const StoredFrfs& stored, const FrfReadOptions& options, std::vector<Message>& notes) {
  const std::optional<FrfKind> stated = stored.unit ? std::optional(stored.unit->kind) : stored.kind;
  if (options.kind) {
    if (stated && *stated != *options.kind) {
      notes.emplace_back(
          fmt::format("the file states {}; read as {}, as requested", name_of(*stated), name_of(*options.kind)),
          std::vector<OptionId>{"frf_kind"});
    }
    return *options.kind;
  }
  if (stated) return *stated;
  notes.emplace_back("the kind of the FRFs is not stated: taken as accelerance in " + assumed_unit(options.read),
                     std::vector<OptionId>{"frf_kind", "unit"});
  return FrfKind::accelerance;
}

// Takes the number of averages that the user states. The coherence of a single average is 1.
void apply_averages(const std::optional<std::size_t>& averages, const std::string& where, std::vector<StoredFrf>& frfs,
                    std::vector<Message>& notes) {
  if (!averages) return;
  constexpr double kRoundedOne = 1 - 1e-5;  // of a program that computes in single precision
  bool spread_known = false;
  for (StoredFrf& frf : frfs) {
    if (frf.averages != 0 && frf.averages != *averages) {
      throw InputError(
          fmt::format("a number of averages of {} contradicts the file, which states {}", *averages, frf.averages),
          where, "leave it out", {"averages"});
    }
    const auto below_one = [](double coherence) { return coherence < kRoundedOne; };
    if (*averages == 1 && std::any_of(frf.coherence.begin(), frf.coherence.end(), below_one)) {
      throw InputError("1 average contradicts the coherence of the file, which is below 1", where,
                       "state the number of hits or records behind each FRF", {"averages"});
    }
    frf.averages = *averages;
    spread_known = spread_known || !frf.std.empty() || !frf.coherence.empty();
  }
  if (!spread_known) {
    notes.emplace_back(
        "the FRFs have neither a coherence nor a standard deviation: the stated number of averages does not change the "
        "±",
        std::vector<OptionId>{"averages"});
  }
}

// [lines] the standard deviation of H1 from its coherence γ² over n averages, |H| √((1 − γ²)/(γ² (n − 1))): √2 times
// the standard deviation of the magnitude (source [3]). Empty without a coherence, or without two averages.
std::vector<double> std_from_coherence(const StoredFrf& frf) {
  constexpr double kMinCoherence = 1e-12;
  const auto finite = [](double value) { return std::isfinite(value); };
  const bool all_finite = std::all_of(frf.coherence.begin(), frf.coherence.end(), finite);
  if (frf.averages < 2 || frf.coherence.size() != frf.value.size() || !all_finite) return {};
  const auto freedom = static_cast<double>(frf.averages - 1);
  std::vector<double> out;
  for (std::size_t k = 0; k < frf.value.size(); ++k) {
    const double known = std::clamp(frf.coherence[k], kMinCoherence, 1.0);
    out.push_back(std::sqrt((1 - known) / known / freedom) * std::abs(frf.value[k]));
  }
  return out;
}

// Turns stored numbers into an accelerance, in place.
Frf accelerance_of(StoredFrf stored, const FrfRecord& record, double factor, const std::string& where) {
  if (stored.std.empty()) stored.std = std_from_coherence(stored);
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
    if (std::abs(frf.value[k]) <= kMaxSample) continue;
    const char* const problem = std::isfinite(std::abs(frf.value[k])) ? "too large" : "not a finite number";
    throw InputError(fmt::format("the FRF at {:.6g} Hz is {}", record.lines.freq_Hz(k), problem), where,
                     "correct the number or the scale");
  }
  return frf;
}

// Whether the phase rises with frequency where the FRFs are large. At a resonance it falls by π for exp(+jωt).
bool phase_rises(const std::vector<PointFrf>& frfs) {
  constexpr double kMinRisingShare = 0.5;
  double turned = 0, all = 0;
  for (const PointFrf& one : frfs) {
    const std::vector<Complex>& frf = one.frf.value;
    for (std::size_t k = 0; k + 1 < frf.size(); ++k) {
      const double step = (std::conj(frf[k]) * frf[k + 1]).imag();
      turned += step;
      all += std::abs(step);
    }
  }
  return turned > kMinRisingShare * all;
}

}  // namespace

void StoredFrfs::set_lines(FrequencyLines frequencies) {
  record.lines = frequencies.lines;
  spacing = frequencies.spacing;
  spacing_note = std::move(frequencies.note);
}

FrfRecord to_accelerances(StoredFrfs stored, const FrfReadOptions& options) {
  FrfRecord record = std::move(stored.record);
  const std::string where = input_name(record.source());
  refuse_inapplicable_options(options.read, where);
  apply_spacing(stored, options.read.df_Hz, where, record);
  record.kind = frf_kind_of(stored, options, record.notes);
  apply_averages(options.averages, where, stored.frfs, record.notes);
  const auto channels = chosen_channels(options.read, record.accel.size(), where);
  const SignalOverrides force = force_overrides(options.read, force_setup(options.read));
  const double force_to_SI = force.sign * response_sign(force_setup(options.read)) * force_factor(force, stored, where);
  std::vector<SignalInfo> accel;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const ChannelSetup* setup = accel_setup(options.read, channels[i], record.accel.size());
    const SignalOverrides choice = accel_overrides(options.read, setup, i, channels.size(), where);
    SignalInfo signal = record.accel[channels[i]];
    signal.to_SI = choice.sign * response_factor(choice, stored, record.kind, where) / force_to_SI;
    if (!std::isfinite(signal.to_SI) || signal.to_SI == 0)
      throw InputError("the scale is zero or not finite", where, "give a finite scale other than zero");
    if (choice.axis) signal.axis = choice.axis;
    if (choice.angle_rad) signal.angle_rad = choice.angle_rad;
    if (choice.position_m) signal.position_m = choice.position_m;
    accel.push_back(std::move(signal));
  }
  record.accel = std::move(accel);
  record.driving = driving_at(record.driving, channels);
  if (record.sensor_roves) record.motions = motions_at(record.motions, channels);
  for (StoredFrf& frf : stored.frfs) {
    const auto place = std::find(channels.begin(), channels.end(), frf.channel);
    if (place == channels.end()) continue;
    const auto channel = static_cast<std::size_t>(place - channels.begin());
    record.frfs.push_back({.point = frf.point, .channel = channel, .frf = {}});
    record.frfs.back().frf = accelerance_of(std::move(frf), record, record.accel[channel].to_SI, where);
  }
  if (phase_rises(record.frfs)) {
    record.notes.push_back(with_code(
        "the phase rises through the resonances: the FRFs may be for exp(−jωt), but percuss needs exp(+jωt); if so, "
        "reverse the sign of their imaginary part (or of their phase) in the program that exported them",
        kReversedPhase));
  }
  if (force.axis && record.motions.empty() && !record.sensor_roves) {
    for (const PointFrf& one : record.frfs)
      record.motions.push_back({.point = one.point, .place = one.point, .along = force.axis});
  }
  sort_motions(record.motions);
  std::stable_sort(record.frfs.begin(), record.frfs.end(), [](const PointFrf& a, const PointFrf& b) {
    return a.point != b.point ? a.point < b.point : a.channel < b.channel;
  });
  return record;
}

}  // namespace percuss::acquire
