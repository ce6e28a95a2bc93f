#include "acquire/formats/mat/read_frf_mat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/column_words.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_frf_layout.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "acquire/record/channel_name.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxMatFrfs = 1'000'000;

bool is_frf_name(const std::string& name) { return lower_case(field_name(name)) == "frf"; }

std::vector<const MatVariable*> frf_candidates(const MatFile& file) {
  std::vector<const MatVariable*> out;
  for (const MatVariable& variable : file.variables) {
    const bool fits = variable.is_complex() && variable.size() > 1 && variable.shape.size() <= 3;
    if (!fits) continue;
    if (is_frf_name(variable.name)) return {&variable};
    if (!is_other_spectrum(lower_case(variable.name))) out.push_back(&variable);
  }
  return out;
}

[[noreturn]] void throw_ambiguous(const MatFile& file, const std::string& problem, const std::string& remedy,
                                  const OptionId& option) {
  CsvHeader header{.named = true};
  std::string names;
  for (std::size_t i = 0; i < file.variables.size(); ++i) {
    const MatVariable& variable = file.variables[i];
    const std::string shape =
        variable.is_text ? "text" : shape_name(variable.shape) + (variable.is_complex() ? " complex" : "");
    header.columns.push_back(
        {.index = i, .name = variable.name, .base = variable.name, .unit = shape, .has_numbers = !variable.is_text});
    constexpr std::size_t kNamesInMessage = 12;
    if (i < kNamesInMessage) names += fmt::format("{}{} [{}]", i == 0 ? "" : ", ", one_line(variable.name, 40), shape);
    if (i == kNamesInMessage) names += fmt::format(", … ({} variables)", file.variables.size());
  }
  AmbiguousColumns error(problem + " among " + names, file.path, remedy, header, {option});
  error.format = "MAT";
  throw error;
}

const MatVariable& chosen_frf(const MatFile& file, const std::vector<const MatVariable*>& candidates) {
  if (candidates.size() == 1) return *candidates.front();
  throw_ambiguous(file, fmt::format("{} complex arrays could be the FRFs", candidates.size()), "name one",
                  "accel_channel");
}

// The vector of frequencies, by its usual names, else the only one that begins with "freq"; nullptr without one.
const MatVariable* frequency_vector(const MatFile& file) {
  const auto fits = [](const MatVariable& v) { return is_mat_vector(v) && !v.is_complex() && !v.is_text; };
  for (const char* name :
       {"frequency_hz", "freq_hz", "frequency", "freq", "f", "freqs", "frequencies", "f_hz", "fvec", "omega", "w"}) {
    for (const MatVariable& variable : file.variables) {
      if (lower_case(field_name(variable.name)) == name && fits(variable)) return &variable;
    }
  }
  const MatVariable* only = nullptr;
  for (const MatVariable& variable : file.variables) {
    if (!lower_case(field_name(variable.name)).starts_with("freq") || !fits(variable)) continue;
    if (only != nullptr) return nullptr;
    only = &variable;
  }
  return only;
}

// The unit that the name of a vector of frequencies ends in: freq_kHz, frequency_rad_s. Empty without one.
std::string unit_in_name(const std::string& field) {
  const std::string lower = lower_case(field);
  if (lower.ends_with("_rad_s") || lower.ends_with("_rads")) return "rad/s";
  const std::size_t last = field.rfind('_');
  const std::string ending = last == std::string::npos ? "" : field.substr(last + 1);
  return Hz_per_unit(ending) ? ending : "";
}

struct Frequencies {
  std::vector<double> numbers;  // empty if the file has no vector of them
  double to_Hz = 1;
  std::string note;  // of an assumed unit; may be empty
};

Frequencies frequencies_in(const MatFile& file) {
  const MatVariable* const vector = frequency_vector(file);
  if (vector == nullptr) return {};
  Frequencies out{.numbers = vector->real, .note = {}};
  std::string unit = unit_in(file, vector->name);
  const std::string field(field_name(vector->name)), lower = lower_case(field);
  if (unit.empty() && (lower == "omega" || lower == "w")) {
    unit = "rad/s";
    out.note = one_line(vector->name, 40) + " is taken as the frequencies in rad/s";
  }
  if (unit.empty()) unit = unit_in_name(field);
  out.to_Hz = require_Hz_per_unit(unit, file.path + ": " + one_line(vector->name, 40));
  return out;
}

// The lines of a file that does not list their frequencies.
LineRange lines_without_frequencies(const MatFile& file, const FrfReadOptions& options, std::size_t lines) {
  auto df_Hz = options.read.df_Hz;
  if (!df_Hz) df_Hz = mat_number(file, {"df", "dfhz", "deltaf", "freqspacing", "frequencyresolution"});
  const auto fs_Hz = mat_rate_Hz(file, options.read);
  if (!df_Hz && fs_Hz) df_Hz = *fs_Hz / 2 / static_cast<double>(lines - 1);
  if (!df_Hz)
    throw_ambiguous(file, fmt::format("no frequencies for FRFs of {} lines", lines), "state their spacing in Hz", "df");
  if (!(*df_Hz > 1e-9) || !(*df_Hz < 1e9))
    throw InputError(fmt::format("a spacing of {} Hz is not usable", *df_Hz), file.path, "state it in Hz", {"df"});
  LineRange out{.first = 0, .count = lines};
  out.samples = 2 * (lines - 1);
  out.fs_Hz = *df_Hz * static_cast<double>(out.samples);
  return out;
}

// Real numbers in the order of the FRFs: an array of the same shape, or vectors of one length.
bool has_layout_of(const MatVariable& frf, const MatVariable& other) {
  if (other.is_text || other.is_complex()) return false;
  return other.shape == frf.shape || (is_mat_vector(frf) && is_mat_vector(other) && frf.size() == other.size());
}

// A real array of the FRFs' shape (standard deviations, coherence). nullptr if it is absent or unsuitable; a note names
// an unsuitable one.
const MatVariable* companion_of(const MatFile& file, const MatVariable& frf, const char* name, StoredFrfs& out) {
  const MatVariable* const found = description_variable(file, name, frf.name);
  if (found == nullptr) return nullptr;
  if (has_layout_of(frf, *found)) return found;
  out.record.notes.emplace_back(
      fmt::format("{} is not used: it is not an array of {} real numbers", name, shape_name(frf.shape)));
  return nullptr;
}

// The coherence of the FRFs: percuss's own name, else the only array whose name is a usual one and whose layout fits.
const MatVariable* coherence_of(const MatFile& file, const MatVariable& frf, StoredFrfs& out) {
  if (find_variable(file, "coherence") != nullptr) return companion_of(file, frf, "coherence", out);
  const MatVariable* only = nullptr;
  for (const MatVariable& variable : file.variables) {
    const std::string name = lower_case(field_name(variable.name));
    const bool named = name.starts_with("coh") || name.starts_with("cxy") || name.starts_with("gamma");
    if (!named || !has_layout_of(frf, variable)) continue;
    if (only != nullptr) return nullptr;
    only = &variable;
  }
  if (only != nullptr)
    out.record.notes.push_back(information(one_line(only->name, 40) + " is taken as the coherence of the FRFs"));
  return only;
}

// The values of one point and channel; empty without a companion.
std::vector<double> values_of(const MatFile& file, const MatVariable* companion, const MatFrfLayout& layout,
                              std::size_t point, std::size_t channel) {
  if (companion == nullptr) return {};
  std::vector<double> out(layout.lines);
  for (std::size_t k = 0; k < layout.lines; ++k) {
    out[k] = companion->real[layout.at(point, channel, k)];
    if (std::isfinite(out[k])) continue;
    throw InputError("not a finite number", file.path + ": " + one_line(companion->name, 40), "leave it out");
  }
  return out;
}

// The numbers of the points; from 0 if the file does not number them.
std::vector<int> point_numbers_in(const MatFile& file, const MatVariable& frf, std::size_t count) {
  const MatVariable* const numbers = description_variable(file, "point", frf.name);
  if (numbers != nullptr && numbers->size() == count) {
    const std::string where = file.path + ": point";
    if (numbers->is_complex()) refuse_point_numbers(where);
    return point_numbers(numbers->real, where);
  }
  std::vector<int> points(count);
  std::iota(points.begin(), points.end(), 0);
  return points;
}

void read_frfs(const MatFile& file, const MatVariable& frf, const MatFrfLayout& layout, StoredFrfs& out) {
  const std::vector<int> points = point_numbers_in(file, frf, layout.points);
  const MatVariable* const deviations = companion_of(file, frf, "frf_std", out);
  const MatVariable* const coherence = coherence_of(file, frf, out);
  const auto averages = mat_number(file, {"averages"}).value_or(0);
  for (std::size_t p = 0; p < layout.points; ++p) {
    for (std::size_t c = 0; c < layout.channels; ++c) {
      StoredFrf stored{.point = points[p], .channel = c};
      stored.value.resize(layout.lines);
      for (std::size_t k = 0; k < layout.lines; ++k) {
        const std::size_t at = layout.at(p, c, k);
        stored.value[k] = {frf.real[at], frf.imaginary[at]};
      }
      stored.std = values_of(file, deviations, layout, p, c);
      stored.coherence = values_of(file, coherence, layout, p, c);
      stored.averages = averages > 0 && averages <= kMaxAverages ? static_cast<std::size_t>(averages) : 0;
      out.frfs.push_back(std::move(stored));
    }
  }
}

void describe_mat_channels(const MatFile& file, const MatVariable& frf, std::size_t channels, StoredFrfs& out) {
  const auto angle_deg = per_channel(file, "angle_deg", channels, frf.name);
  const auto position_m = per_channel(file, "position_m", channels, frf.name);
  for (std::size_t c = 0; c < channels; ++c) {
    SignalInfo signal{.name = channel_name(c), .position_m = position_m[c]};
    if (angle_deg[c]) signal.angle_rad = *angle_deg[c] * kDegree_rad;
    out.record.accel.push_back(std::move(signal));
  }
}

// The complex array that options.read names; nullptr without one.
const MatVariable* named_frf(const MatFile& file, const ReadOptions& options) {
  if (options.accel_channels.size() != 1) return nullptr;
  const MatVariable* const named = find_variable(file, options.accel_channels.front());
  return named != nullptr && named->is_complex() ? named : nullptr;
}

void require_frf_size(const MatFile& file, const MatVariable& frf, const MatFrfLayout& layout) {
  if (layout.lines >= 2 && layout.points * layout.channels <= kMaxMatFrfs) return;
  throw InputError("too few lines or too many FRFs: " + shape_name(frf.shape), file.path,
                   fmt::format("store at least 2 lines, and at most {} FRFs in a file", kMaxMatFrfs));
}

// Unit and kind as the file states them, else as the variable's unit and name show them.
void read_unit_and_kind(const MatFile& file, const MatVariable& frf, StoredFrfs& out) {
  out.unit = parse_frf_unit(mat_text(file, "unit"));
  if (!out.unit) out.unit = parse_frf_unit(unit_in(file, frf.name));
  out.kind = parse_frf_kind(mat_text(file, "kind"));
  if (!out.kind) out.kind = parse_frf_kind(field_name(frf.name));
}

// Whether a real array longer than the FRFs could be a time record, so that the file is ambiguous.
bool may_hold_record(const MatFile& file, std::size_t lines) {
  return std::any_of(file.variables.begin(), file.variables.end(), [&](const MatVariable& v) {
    const bool longer = std::any_of(v.shape.begin(), v.shape.end(), [&](std::size_t n) { return n > lines; });
    return !v.is_text && !v.is_complex() && longer;
  });
}

}  // namespace

std::optional<StoredFrfs> read_frf_mat(const MatFile& file, const FrfReadOptions& options) {
  const ReadOptions& read = options.read;
  const bool force_named = !read.force_channel.empty() && read.force_channel != "force";
  const MatVariable* const named = named_frf(file, read);
  const auto candidates = named != nullptr ? std::vector{named} : frf_candidates(file);
  if (candidates.empty() || (force_named && !options.kind)) return std::nullopt;
  const Frequencies frequencies = frequencies_in(file);
  const std::size_t stated_lines = frequencies.numbers.size();
  const bool is_named_frf = is_frf_name(candidates.front()->name);
  const std::size_t lines = frf_layout(*candidates.front(), stated_lines).lines;
  if (named == nullptr && !is_named_frf && !options.kind && may_hold_record(file, lines)) return std::nullopt;
  const MatVariable& frf = chosen_frf(file, candidates);
  const MatFrfLayout layout = frf_layout(frf, stated_lines);
  require_frf_size(file, frf, layout);
  StoredFrfs out;
  out.record.files.push_back({.path = file.path, .bytes = file.bytes});
  out.record.format = "FRF MAT";
  out.record.notes = file.notes;
  if (stated_lines == layout.lines) {
    out.set_lines(frequency_lines(frequencies.numbers, frequencies.to_Hz, file.path));
  } else {
    out.record.lines = lines_without_frequencies(file, options, layout.lines);
  }
  out.record.decay_per_s = std::max(0.0, mat_number(file, {"decaypers"}).value_or(0));
  if (!frequencies.note.empty()) out.record.notes.emplace_back(frequencies.note);
  describe_mat_channels(file, frf, layout.channels, out);
  if (layout.points > 1 && !is_named_frf) {
    out.record.notes.push_back(information(fmt::format(
        "the {} FRFs of {} are taken as points of {}", layout.points * layout.channels, one_line(frf.name, 40),
        layout.channels == 1 ? "one channel" : fmt::format("{} channels", layout.channels))));
  }
  read_unit_and_kind(file, frf, out);
  out.record.estimator = one_line(mat_text(file, "estimator"), 60);
  read_frfs(file, frf, layout, out);
  return out;
}

}  // namespace percuss::acquire
