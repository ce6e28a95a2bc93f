#include "acquire/formats/hdf5/read_hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "acquire/channels/named_channels.hpp"
#include "acquire/channels/signal_overrides.hpp"
#include "acquire/channels/unit_notes.hpp"
#include "acquire/formats/hdf5/hdf5_layout.hpp"
#include "acquire/formats/hdf5/hdf5_points.hpp"
#include "acquire/formats/hdf5/hdf5_rate.hpp"
#include "acquire/formats/hdf5/hdf5_set_names.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using hdf5::InputDataSet;
using hdf5::InputHdf5;

constexpr std::size_t kMaxChannels = 100'000;
constexpr std::array kKnownNames{"force",       "accel",       "point",    "run",   "geometry",
                                 "trace_lines", "trace_faces", "rejected", "faults"};

// The data shared by the read functions of a record.
struct OpenRecord {
  InputHdf5 file;
  hdf5::SetNames names;
  std::optional<InputDataSet> force;  // the set called force; its samples may be an acceleration
  InputDataSet accel;
  hdf5::Layout layout;
  NamedRoles roles;
  double force_to_N = 1;
  std::vector<double> to_mps2;  // of the accelerations

  const InputDataSet& set_of(const NamedSignal& signal) const { return signal.is_force ? *force : accel; }
};

// An attribute of /accel with one number per channel; NaN: not known.
std::vector<std::optional<double>> per_channel(const OpenRecord& open, const std::string& name) {
  std::vector<std::optional<double>> out(open.layout.channels);
  const std::string where = open.accel.where();
  const auto values = hdf5::number_attribute(open.accel.id(), name, where, kMaxChannels);
  if (!values) return out;
  if (values->size() != out.size()) {
    throw InputError("attribute " + name + " holds " + std::to_string(values->size()) + " numbers for " +
                         std::to_string(out.size()) + " channels",
                     where, "store one per channel");
  }
  for (std::size_t c = 0; c < out.size(); ++c) {
    const double value = (*values)[c];
    if (std::isinf(value)) throw InputError("attribute " + name + " is infinite", where, "store a finite number");
    if (!std::isnan(value)) out[c] = value;
  }
  return out;
}

SignalInfo stored_signal(const OpenRecord& open, const NamedSignal& signal) {
  const InputDataSet& set = open.set_of(signal);
  return {.name = signal.is_force ? "force" : channel_name(signal.channel),
          .unit = hdf5::text_attribute(set.id(), "unit_str", set.where()).value_or("")};
}

const ChannelSetup* setup_of(const OpenRecord& open, const NamedSignal& signal, const ReadOptions& options) {
  return signal.is_force ? force_setup(options) : accel_setup(options, signal.channel, open.layout.channels);
}

// The channel of /accel whose stated angle and position apply to an acceleration: usually its own. The file states no
// place for the signal called force. If this signal is an acceleration, it takes the place of the channel that is the
// force, or no place if no channel is the force.
std::optional<std::size_t> channel_of_place(const OpenRecord& open, const NamedSignal& signal) {
  if (!signal.is_force) return signal.channel;
  const auto& force = open.roles.force;
  return force && !force->is_force ? std::optional(force->channel) : std::nullopt;
}

void describe_force(OpenRecord& open, const NamedSignal& signal, const ReadOptions& options, Record& record) {
  record.force = stored_signal(open, signal);
  const SignalOverrides choice = force_overrides(options, setup_of(open, signal, options));
  const bool assumed = !states_scale(record.force, choice);
  const std::string where = open.set_of(signal).where();
  apply_force_overrides(record.force, choice, signal.is_force ? where : where + ", " + record.force.name, record.notes);
  if (assumed) mark_unit_assumed(record.force);
  open.force_to_N = record.force.to_SI;
}

void describe_signals(OpenRecord& open, const ReadOptions& options, Record& record) {
  record.has_force = open.roles.force.has_value();
  if (open.roles.force) describe_force(open, *open.roles.force, options, record);
  const auto angle_deg = per_channel(open, "angle_deg"), position_m = per_channel(open, "position_m");
  const std::size_t count = open.roles.accel.size();
  for (std::size_t i = 0; i < count; ++i) {
    const NamedSignal& named = open.roles.accel[i];
    SignalInfo signal = stored_signal(open, named);
    const auto place = channel_of_place(open, named);
    if (place) signal.position_m = position_m[*place];
    if (place && angle_deg[*place]) signal.angle_rad = *angle_deg[*place] * kDegree_rad;
    const bool placed = named.is_force && (signal.position_m || signal.angle_rad);
    SignalOverrides choice = accel_overrides(options, setup_of(open, named, options), i, count, open.file.path());
    if (open.roles.force) choice.sign *= response_sign(setup_of(open, *open.roles.force, options));
    const bool assumed = !states_scale(signal, choice);
    apply_overrides(signal, choice, response_quantity(signal, choice, record.has_force),
                    open.set_of(named).where() + ", " + signal.name);
    if (assumed) mark_unit_assumed(signal);
    if (placed && !(choice.angle_rad || choice.position_m)) {
      record.notes.emplace_back(
          fmt::format("force has the angle and the position that the file states for {}, which is the force here",
                      channel_name(*place)),
          std::vector<OptionId>{"angle", "position"});
    }
    open.to_mps2.push_back(signal.to_SI);
    record.accel.push_back(std::move(signal));
  }
  note_assumed_units(record);
}

void describe_rows(const OpenRecord& open, Record& record) {
  const InputHdf5& file = open.file;
  const std::vector<int> point = hdf5::numbers_per_row(file, "point", open.layout.rows);
  const std::vector<int> run = hdf5::numbers_per_row(file, "run", open.layout.rows);
  const std::vector<RowMark> marks = hdf5::read_marks(file, open.layout.rows);
  for (std::size_t row = 0; row < open.layout.rows; ++row) {
    require_point_number(point[row], file.where("point"));
    record.rows.push_back({.samples = open.layout.samples, .point = point[row], .run = run[row], .mark = marks[row]});
  }
  record.faults = hdf5::read_faults(file, open.layout.rows);
  const auto continuous = hdf5::number_attribute(file.id(), "continuous", file.path(), 1);
  record.continuous =
      continuous ? continuous->front() != 0 : !(open.force ? open.layout.force_has_rows : open.layout.accel_has_rows);
}

void note_unused(const InputHdf5& file, const hdf5::SetNames& used, bool with_force, Record& record) {
  // A group counts as used if it holds a used set.
  const auto holds = [](const std::string& path, const std::string& name) {
    return path == name || path.starts_with(name + "/");
  };
  std::vector<std::string> unused;
  for (const std::string& name : file.names(hdf5::kNamesShown)) {
    const bool signal = name == "force" || name == "accel";
    const bool known = !signal && std::find(kKnownNames.begin(), kKnownNames.end(), name) != kKnownNames.end();
    const bool read = (with_force && holds(used.force, name)) || holds(used.accel, name);
    if (!known && !read) unused.push_back("/" + name);
  }
  if (!unused.empty()) record.notes.emplace_back("not used: " + hdf5::list_of_names(unused));
}

// Scales in place.
// errors  InputError: names the first sample that is too large or not finite, with its index as in h5py.
void to_SI(std::span<double> samples, double factor, const std::string& where, std::span<const std::size_t> at,
           std::size_t first) {
  for (double& sample : samples) {
    sample *= factor;
    if (std::abs(sample) <= kMaxSample) continue;
    std::vector<std::size_t> index(at.begin(), at.end());
    index.push_back(first + static_cast<std::size_t>(&sample - samples.data()));
    const char* is = std::isfinite(sample) ? "sample is too large" : "sample is not a finite number";
    throw InputError(is, where + hdf5::shape_text(index), "repair or leave out this hit");
  }
}

void read_signal(const OpenRecord& open, const NamedSignal& signal, double factor, std::size_t row, std::size_t first,
                 std::span<double> out) {
  assert(row < open.layout.rows && first + out.size() <= open.layout.samples);
  std::vector<std::size_t> index;
  if (signal.is_force ? open.layout.force_has_rows : open.layout.accel_has_rows) index.push_back(row);
  if (!signal.is_force && open.layout.accel_has_channels) index.push_back(signal.channel);
  const InputDataSet& set = open.set_of(signal);
  {
    const hdf5::Lock lock;
    set.read(index, first, out);
  }
  to_SI(out, factor, set.where(), index, first);
}

// Nothing when a signal is not contiguous in the file.
std::vector<ContiguousSignal> contiguous_signals(const OpenRecord& open) {
  const auto accel = open.accel.contiguous();
  const auto force = open.force ? open.force->contiguous() : accel;
  if (!accel || !force) return {};
  const std::uint64_t samples = open.layout.samples;
  const auto storage_of = [&](const NamedSignal& signal, double factor) -> ContiguousSignal {
    const auto& set = signal.is_force ? force : accel;
    const std::uint64_t channel_bytes = samples * set->number_bytes;
    return {.offset_bytes = set->offset_bytes + signal.channel * channel_bytes,
            .row_step_bytes = (signal.is_force ? 1 : open.layout.channels) * channel_bytes,
            .number_bytes = set->number_bytes,
            .to_SI = factor};
  };
  // Without a force, the first entry is not read.
  std::vector<ContiguousSignal> out{storage_of(open.roles.force.value_or(NamedSignal{}), open.force_to_N)};
  for (std::size_t i = 0; i < open.roles.accel.size(); ++i)
    out.push_back(storage_of(open.roles.accel[i], open.to_mps2[i]));
  return out;
}

std::unique_ptr<OpenRecord> open_sets(const std::string& path, ReadOptions& options) {
  InputHdf5 file(path);
  const hdf5::SetNames names = hdf5::take_set_names(file, options);
  std::optional<InputDataSet> force;
  const bool named = names.force != hdf5::SetNames{}.force;
  const bool optional = options.force_optional || hdf5::gives_force_to_channel(options);
  if (!optional || named || file.has(names.force)) force = hdf5::open_required(file, names.force);
  InputDataSet accel = hdf5::open_required(file, names.accel);
  const hdf5::Layout layout = force ? hdf5::layout_of(*force, accel, file) : hdf5::layout_of(accel);
  NamedRoles roles = named_roles(options, layout.channels, force.has_value(), path);
  return std::make_unique<OpenRecord>(OpenRecord{.file = std::move(file),
                                                 .names = names,
                                                 .force = std::move(force),
                                                 .accel = std::move(accel),
                                                 .layout = layout,
                                                 .roles = std::move(roles),
                                                 .to_mps2 = {}});
}

}  // namespace

Record open_hdf5(const std::string& path, const ReadOptions& stated) {
  const hdf5::Lock lock;
  ReadOptions options = stated;
  auto opened = open_sets(path, options);
  Record record;
  record.files.push_back(
      {.path = path, .bytes = opened->file.bytes(), .date = hdf5::date_attribute(opened->file.id())});
  record.format = "HDF5";
  record.fs_Hz =
      hdf5::read_rate_Hz(opened->file, opened->force ? &*opened->force : nullptr, opened->accel, options, record.notes);
  describe_signals(*opened, options, record);
  describe_rows(*opened, record);
  if (options.fs_Hz) hdf5::convert_missing_times(opened->file, record);
  record.geometry = hdf5::read_geometry(opened->file);
  record.trace_lines = hdf5::read_trace_lines(opened->file, record.geometry.size());
  record.trace_faces = hdf5::read_trace_faces(opened->file, record.geometry.size());
  note_unused(opened->file, opened->names, opened->force.has_value(), record);
  record.contiguous = contiguous_signals(*opened);
  // Closing the data sets uses the library, so the deleter needs a lock.
  const std::shared_ptr<const OpenRecord> open(opened.release(), [](const OpenRecord* last) {
    const hdf5::Lock closing;
    delete last;
  });
  record.read_force_N = [open](std::size_t row, std::size_t first, std::span<double> out) {
    read_signal(*open, *open->roles.force, open->force_to_N, row, first, out);
  };
  if (!record.has_force) record.read_force_N = no_force();
  record.read_accel_mps2 = [open](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    read_signal(*open, open->roles.accel.at(channel), open->to_mps2.at(channel), row, first, out);
  };
  return record;
}

}  // namespace percuss::acquire
