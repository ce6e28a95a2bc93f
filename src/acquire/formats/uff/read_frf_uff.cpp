#include "acquire/formats/uff/read_frf_uff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/uff_directions.hpp"
#include "acquire/formats/uff/uff_frf_grid.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// The factor of the response to SI. Sets `kind` and whether the axis states it (`known`).
double response_factor(const UffAxis& axis, const UffContents& contents, FrfKind& kind, bool& known) {
  if (axis.quantity == Uff58::acceleration) kind = FrfKind::accelerance;
  if (axis.quantity == Uff58::velocity) kind = FrfKind::mobility;
  if (axis.quantity == Uff58::displacement) kind = FrfKind::receptance;
  known =
      axis.quantity == Uff58::acceleration || axis.quantity == Uff58::velocity || axis.quantity == Uff58::displacement;
  // The text of the unit may name the response only ("m/s^2") or the quotient ("m/s^2/N").
  for (const std::string& text : {axis.unit, axis.unit + "/N"}) {
    const auto parsed = parse_frf_unit(text);
    if (!parsed) continue;
    kind = parsed->kind;
    known = true;
    return parsed->response_to_SI;
  }
  return contents.units ? 1 / contents.units->length : 1;
}

FrfUnit unit_of_function(const UffFunction& f, const UffContents& contents, bool& known) {
  FrfUnit out;
  out.response_to_SI = response_factor(f.ordinate, contents, out.kind, known);
  const auto denominator = parse_unit(f.denominator.unit);
  if (denominator && denominator->quantity == Quantity::force) {
    out.force_to_SI = denominator->to_SI;
  } else if (const auto quotient = parse_frf_unit(f.ordinate.unit)) {
    out.force_to_SI = quotient->force_to_SI;
  } else if (contents.units) {
    out.force_to_SI = 1 / contents.units->force;
  }
  return out;
}

FrequencyLines lines_of_function(const UffFunction& f, const std::string& where) {
  const double to_Hz = Hz_per_unit(f.abscissa.unit).value_or(1);
  std::vector<double> numbers(f.count);
  if (!f.even) {
    for (std::size_t k = 0; k < f.count; ++k) numbers[k] = f.x(k);
    return frequency_lines(numbers, to_Hz, where);
  }
  UffStepNote note;
  const double step = uff_step(f, true, to_Hz, note);
  const double first = std::round(f.x0 / step);
  const bool fits = step > 0 && first >= 0 && std::abs(f.x0 / step - first) <= kMaxLineOffset;
  if (!fits || f.count < 2) {
    throw InputError(fmt::format("{} lines from {} Hz in steps of {} Hz", f.count, f.x0 * to_Hz, f.dx * to_Hz), where,
                     "export lines that are multiples of their spacing");
  }
  for (std::size_t k = 0; k < f.count; ++k) numbers[k] = (first + static_cast<double>(k)) * step * to_Hz;
  FrequencyLines out = frequency_lines(numbers, 1, where);
  const double half_unit = 0.5 * std::pow(10.0, -decimals_of(f.dx_text, false));
  out.spacing.lowest_Hz = std::min(out.spacing.lowest_Hz, (f.dx - half_unit) * to_Hz);
  out.spacing.highest_Hz = std::max(out.spacing.highest_Hz, (f.dx + half_unit) * to_Hz);
  out.note = std::move(note.text);
  return out;
}

bool have_same_lines(const UffFunction& a, const UffFunction& b) {
  if (a.count != b.count || a.even != b.even) return false;
  if (a.even) return a.dx == b.dx && a.x0 == b.x0;
  for (std::size_t k = 0; k < a.count; ++k) {
    if (a.x(k) != b.x(k)) return false;
  }
  return true;
}

void require_same_lines(const UffFrfs& frfs, const FileBytes& file) {
  for (const UffFunction* f : frfs) {
    const bool same = have_same_lines(*f, *frfs.front());
    if (same && f->complex) continue;
    throw InputError(same ? "an FRF that is not complex" : "FRFs with other lines than the first one",
                     uff_location(file, f->at), "export them with the same lines, as complex numbers");
  }
}

StoredFrf stored_frf(const UffFunction& f, int point, std::size_t channel, double sign) {
  StoredFrf out{.point = point, .channel = channel};
  std::vector<double> real(f.count), imaginary(f.count);
  f.read(0, 0, real);
  f.read(1, 0, imaginary);
  out.value.reserve(f.count);
  for (std::size_t k = 0; k < f.count; ++k) out.value.emplace_back(sign * real[k], sign * imaginary[k]);
  out.averages = uff_annotation(f).averages;
  return out;
}

void add_coherence(const UffFunction& coherence, const std::string& where, StoredFrf& frf) {
  if (coherence.count != frf.value.size() || coherence.complex) return;
  frf.coherence.resize(coherence.count);
  coherence.read(0, 0, frf.coherence);
  if (!std::all_of(frf.coherence.begin(), frf.coherence.end(), [](double x) { return std::isfinite(x); }))
    throw InputError("a coherence that is not a finite number", where, "correct or leave out the value");
}

using FrfDofs = std::tuple<UffDofKey, UffDofKey>;  // reference, response
std::map<FrfDofs, const UffFunction*> coherences_of(const UffContents& contents) {
  std::map<FrfDofs, const UffFunction*> out;
  for (const UffFunction& f : contents.functions) {
    if (f.type == Uff58::coherence) out.emplace(FrfDofs{uff_dof_key(f.reference), uff_dof_key(f.response)}, &f);
  }
  return out;
}

void require_grid(const StoredFrfs& out, const std::string& file) {
  std::set<std::pair<int, std::size_t>> seen;
  std::set<int> points;
  for (const StoredFrf& frf : out.frfs) {
    points.insert(frf.point);
    if (!seen.emplace(frf.point, frf.channel).second) {
      throw InputError(fmt::format("two FRFs of channel {} at point {}", frf.channel + 1, frf.point), file,
                       "keep one of them");
    }
  }
  if (points.size() * out.record.accel.size() != out.frfs.size()) {
    throw InputError(fmt::format("{} FRFs, but {} channels at {} points need {}", out.frfs.size(),
                                 out.record.accel.size(), points.size(), points.size() * out.record.accel.size()),
                     file, "export the same channels for every point");
  }
}

// Data that the readers of all FRFs of the file share.
struct FrfLayout {
  const FileBytes& file;
  const UffContents& contents;
  UffAnnotation stated;  // of the first function
  UffFrfGrid grid;
  UffStruckPoints points;
};

// The degree of freedom that gives the point: of the roving sensor, or else of the hammer.
const UffDof& point_dof(const UffFunction& f, const FrfLayout& layout) {
  return layout.grid.sensor_roves ? f.response : f.reference;
}

int point_of(const UffFunction& f, const FrfLayout& layout) {
  const int offset = layout.stated.node_offset;
  const std::int64_t number = (layout.grid.sensor_roves ? f.response.node : layout.points.point(f.reference)) - offset;
  require_point_number(point_dof(f, layout).node - offset, uff_location(layout.file, f.at));
  require_point_number(number, uff_location(layout.file, f.at));
  return static_cast<int>(number);
}

void describe_channel(const UffFunction& f, std::size_t channel, SignalInfo& signal) {
  const UffAnnotation annotation = uff_annotation(f);
  signal.name = "accel " + std::to_string(channel + 1);
  if (annotation.angle_deg) signal.angle_rad = *annotation.angle_deg * kDegree_rad;
  signal.position_m = annotation.position_m;
}

// Adds the FRF, its channel and its place. Returns whether the FRF changes its sign.
bool add_frf(const UffFunction& f, const FrfLayout& layout, StoredFrfs& out) {
  const UffFrfGrid& grid = layout.grid;
  const bool by_percuss = layout.stated.by_percuss;
  const std::size_t channel = grid.channels.at(grid.channel_key(f)) - 1;
  SignalInfo& signal = out.record.accel[channel];
  describe_channel(f, channel, signal);
  const int point = point_of(f, layout);
  // In a file that percuss wrote, a direction only states the angle of a sensor: the values need no change of sign.
  const double sign = by_percuss ? 1 : uff_sign(f, f.reference);
  out.frfs.push_back(stored_frf(f, point, channel, sign));
  if (!by_percuss) {
    const UffDof& moved = point_dof(f, layout);
    const std::size_t roving_channel = grid.sensor_roves ? channel : 0;
    add_uff_motion(layout.contents, moved, point, roving_channel, moved.node - layout.stated.node_offset,
                   out.record.motions);
    if (!grid.sensor_roves) signal.axis = uff_axis(layout.contents, f.response);
  }
  if (same_place(f.response, f.reference)) out.record.driving.push_back({point, channel});
  return sign < 0;
}

void add_frfs(const UffFrfs& frfs, const FrfLayout& layout, StoredFrfs& out) {
  out.record.sensor_roves = layout.grid.sensor_roves;
  out.record.accel.resize(layout.grid.channels.size());
  const auto coherences = coherences_of(layout.contents);
  std::size_t changed = 0;
  for (const UffFunction* f : frfs) {
    if (add_frf(*f, layout, out)) ++changed;
    const auto coherence = coherences.find({uff_dof_key(f->reference), uff_dof_key(f->response)});
    if (coherence != coherences.end())
      add_coherence(*coherence->second, uff_location(layout.file, coherence->second->at), out.frfs.back());
  }
  if (changed > 0) out.record.notes.push_back(information(uff_sign_note(changed, frfs.size(), "FRFs")));
  sort_motions(out.record.motions);
}

// Adds the statements of the file about all FRFs: format, lines, unit, estimator, window and geometry.
void add_statements(const UffFunction& first, const FileBytes& file, const UffContents& contents,
                    const UffAnnotation& stated, StoredFrfs& out) {
  out.record.files.push_back({.path = file.path, .bytes = file.size});
  out.record.format = "FRF UFF";
  out.record.notes = uff_notes(contents);
  out.set_lines(lines_of_function(first, uff_location(file, first.at)));
  bool known = false;
  const FrfUnit unit = unit_of_function(first, contents, known);
  if (known) out.unit = unit;
  out.record.estimator = stated.estimator;
  out.record.decay_per_s = std::max(0.0, stated.decay_per_s.value_or(0));
  add_uff_geometry(contents, stated.node_offset, out.record);
}

}  // namespace

std::optional<StoredFrfs> read_frf_uff(const FileBytes& file, const UffContents& contents, bool forced) {
  const auto& all = contents.functions;
  const bool times = std::any_of(all.begin(), all.end(), is_time_record);
  UffFrfs frfs;
  for (const UffFunction& f : all) {
    if (is_uff_frf(f)) frfs.push_back(&f);
  }
  if (frfs.empty() || (times && !forced)) return std::nullopt;
  require_same_lines(frfs, file);
  StoredFrfs out;
  const UffAnnotation stated = uff_annotation(*frfs.front());
  add_statements(*frfs.front(), file, contents, stated, out);
  UffStruckSet struck;
  for (const UffFunction* f : frfs) struck.insert(uff_struck_key(*f));
  const FrfLayout layout{.file = file,
                         .contents = contents,
                         .stated = stated,
                         .grid = uff_frf_grid(frfs, struck),
                         .points = UffStruckPoints(struck, contents)};
  if (layout.points.several_per_node() && !layout.grid.sensor_roves)
    out.record.notes.push_back(information(layout.points.note()));
  add_frfs(frfs, layout, out);
  require_grid(out, input_name(file.path));
  return out;
}

}  // namespace percuss::acquire
