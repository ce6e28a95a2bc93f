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
#include "acquire/formats/hdf5/hdf5_layout.hpp"
#include "acquire/formats/hdf5/hdf5_points.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/sample_limits.hpp"
#include "acquire/record/sampling_rate.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using hdf5::InputDataSet;
using hdf5::InputHdf5;

constexpr std::size_t kMaxChannels = 100'000;
constexpr std::size_t kNamesShown = 12, kNameBytesShown = 40;
constexpr std::array kKnownNames{"force",       "accel",       "point",    "run",   "geometry",
                                 "trace_lines", "trace_faces", "rejected", "faults"};

// The data sets of a record, as paths without the first slash.
struct SetNames {
  std::string force = "force", accel = "accel";
};

// The data shared by the read functions of a record.
struct OpenRecord {
  InputHdf5 file;
  SetNames names;
  std::optional<InputDataSet> force;
  InputDataSet accel;
  hdf5::Layout layout;
  double force_to_N = 1;
  std::vector<std::size_t> channels;  // the chosen channels of /accel
  std::vector<double> to_mps2;        // of the chosen channels
};

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + one_line(name, kNameBytesShown);
  return text.empty() ? "nothing" : text;
}

InputDataSet open_required(const InputHdf5& file, const std::string& name) {
  if (file.has(name)) return {file, name};
  throw InputError("no data set /" + one_line(name, kNameBytesShown) + " among: " + list(file.data_paths(kNamesShown)),
                   file.path(),
                   "store force [hits, samples] and accel [hits, channels, samples], or name the data sets",
                   {"force_channel", "accel_channel"});
}

std::string without_slash(const std::string& name) { return name.starts_with('/') ? name.substr(1) : name; }

// "accel", "accel 2", "2": channels of the accelerations, whose names are numbers.
bool is_channel_name(std::string name) {
  if (name.starts_with("accel")) name.erase(0, 5);
  if (name.starts_with(' ')) name.erase(0, 1);
  return std::all_of(name.begin(), name.end(), is_digit);
}

// Takes the names of data sets out of the options: the rest applies to the channels of these sets.
SetNames take_set_names(const InputHdf5& file, ReadOptions& options) {
  SetNames names;
  if (!without_slash(options.force_channel).empty()) names.force = without_slash(options.force_channel);
  options.force_channel.clear();
  const auto& accel = options.accel_channels;
  const bool sets = std::any_of(accel.begin(), accel.end(),
                                [](const std::string& name) { return !is_channel_name(without_slash(name)); });
  if (!sets) return names;
  if (accel.size() > 1) {
    throw InputError("several data sets named for the accelerations", file.path(),
                     "name one that holds [hits, channels, samples]", {"accel_channel"});
  }
  names.accel = without_slash(accel.front());
  options.accel_channels.clear();
  return names;
}

// The rate of the file itself, if it states a usable one.
std::optional<double> own_rate_Hz(const InputHdf5& file) {
  try {
    if (const auto own = hdf5::number_attribute(file.id(), "fs", file.path(), 1)) return own->front();
  } catch (const InputError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

double read_rate_Hz(const OpenRecord& open, const ReadOptions& options, std::vector<Message>& notes) {
  const InputHdf5& file = open.file;
  if (options.fs_Hz) {
    if (const auto own_Hz = own_rate_Hz(file)) note_other_rate("the file", *own_Hz, *options.fs_Hz, notes);
    return checked_rate_Hz(*options.fs_Hz, "the rate stated");
  }
  std::vector<std::pair<hdf5::Id, std::string>> places{{file.id(), file.path() + ": attribute fs"},
                                                       {open.accel.id(), open.accel.where() + " attribute fs"}};
  if (open.force) places.insert(places.begin() + 1, {open.force->id(), open.force->where() + " attribute fs"});
  std::optional<double> found_Hz;
  for (const auto& [object, where] : places) {
    const auto values = hdf5::number_attribute(object, "fs", where, 1);
    if (!values) continue;
    const double fs_Hz = checked_rate_Hz(values->front(), where);
    if (found_Hz && *found_Hz != fs_Hz) {
      throw InputError(fmt::format("two sampling rates: {} and {} Hz", *found_Hz, fs_Hz), where, "state the right one",
                       {"fs"});
    }
    found_Hz = fs_Hz;
  }
  if (found_Hz) return *found_Hz;
  throw InputError("no sampling rate: attribute fs is missing", file.path(), "store it, or state the rate, in Hz",
                   {"fs"});
}

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

void describe_signals(OpenRecord& open, const ReadOptions& options, Record& record) {
  const InputHdf5& file = open.file;
  record.has_force = open.force.has_value();
  if (open.force) {
    record.force.name = "force";
    record.force.unit = hdf5::text_attribute(open.force->id(), "unit_str", open.force->where()).value_or("");
    apply_force_overrides(record.force, force_overrides(options, force_setup(options)), open.force->where(),
                          record.notes);
    open.force_to_N = record.force.to_SI;
  }

  const std::string unit = hdf5::text_attribute(open.accel.id(), "unit_str", open.accel.where()).value_or("");
  const auto angle_deg = per_channel(open, "angle_deg"), position_m = per_channel(open, "position_m");
  open.channels = chosen_channels(options, open.layout.channels, file.path());
  for (std::size_t i = 0; i < open.channels.size(); ++i) {
    const std::size_t c = open.channels[i];
    SignalInfo signal{.name = channel_name(c), .unit = unit, .position_m = position_m[c]};
    if (angle_deg[c]) signal.angle_rad = *angle_deg[c] * kDegree_rad;
    const ChannelSetup* const setup = accel_setup(options, c, open.layout.channels);
    const SignalOverrides choice = accel_overrides(options, setup, i, open.channels.size(), file.path());
    apply_overrides(signal, choice, response_quantity(signal, choice, record.has_force),
                    open.accel.where() + ", " + signal.name);
    open.to_mps2.push_back(signal.to_SI);
    record.accel.push_back(std::move(signal));
  }
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

// Missing samples keep their numbers, whatever rate the user states.
void keep_missing_samples(const InputHdf5& file, Record& record) {
  const auto own_Hz = own_rate_Hz(file);
  for (RecordFault& fault : record.faults) {
    if (own_Hz && fault.kind == FaultKind::missing_samples) fault.time_s *= *own_Hz / record.fs_Hz;
  }
}

void note_unused(const InputHdf5& file, const SetNames& used, Record& record) {
  // A group counts as used where it holds a set that is.
  const auto holds = [](const std::string& path, const std::string& name) {
    return path == name || path.starts_with(name + "/");
  };
  std::vector<std::string> unused;
  for (const std::string& name : file.names(kNamesShown)) {
    const bool signal = name == "force" || name == "accel";
    const bool known = !signal && std::find(kKnownNames.begin(), kKnownNames.end(), name) != kKnownNames.end();
    const bool read = (record.has_force && holds(used.force, name)) || holds(used.accel, name);
    if (!known && !read) unused.push_back("/" + name);
  }
  if (!unused.empty()) record.notes.emplace_back("not used: " + list(unused));
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

void read_force(const OpenRecord& open, std::size_t row, std::size_t first, std::span<double> out_N) {
  assert(row < open.layout.rows && first + out_N.size() <= open.layout.samples);
  const std::array at{row};
  const auto index = std::span(at).first(open.layout.force_has_rows ? 1 : 0);
  {
    const hdf5::Lock lock;
    open.force->read(index, first, out_N);
  }
  to_SI(out_N, open.force_to_N, open.force->where(), index, first);
}

void read_accel(const OpenRecord& open, std::size_t row, std::size_t channel, std::size_t first,
                std::span<double> out_mps2) {
  assert(row < open.layout.rows && channel < open.channels.size());
  assert(first + out_mps2.size() <= open.layout.samples);
  std::vector<std::size_t> index;
  if (open.layout.accel_has_rows) index.push_back(row);
  if (open.layout.accel_has_channels) index.push_back(open.channels[channel]);
  {
    const hdf5::Lock lock;
    open.accel.read(index, first, out_mps2);
  }
  to_SI(out_mps2, open.to_mps2[channel], open.accel.where(), index, first);
}

// Nothing when a signal is not contiguous in the file.
std::vector<ContiguousSignal> contiguous_signals(const OpenRecord& open) {
  const auto accel = open.accel.contiguous();
  const auto force = open.force ? open.force->contiguous() : accel;
  if (!accel || !force) return {};
  const std::uint64_t samples = open.layout.samples;
  const std::uint64_t channel_bytes = samples * accel->number_bytes;
  std::vector<ContiguousSignal> out{{.offset_bytes = force->offset_bytes,
                                     .row_step_bytes = samples * force->number_bytes,
                                     .number_bytes = force->number_bytes,
                                     .to_SI = open.force_to_N}};
  for (std::size_t i = 0; i < open.channels.size(); ++i) {
    out.push_back({.offset_bytes = accel->offset_bytes + open.channels[i] * channel_bytes,
                   .row_step_bytes = open.layout.channels * channel_bytes,
                   .number_bytes = accel->number_bytes,
                   .to_SI = open.to_mps2[i]});
  }
  return out;
}

std::unique_ptr<OpenRecord> open_sets(const std::string& path, ReadOptions& options) {
  InputHdf5 file(path);
  const SetNames names = take_set_names(file, options);
  std::optional<InputDataSet> force;
  const bool named = names.force != SetNames{}.force;
  if (!options.force_optional || named || file.has(names.force)) force = open_required(file, names.force);
  InputDataSet accel = open_required(file, names.accel);
  const hdf5::Layout layout = force ? hdf5::layout_of(*force, accel, file) : hdf5::layout_of(accel);
  return std::make_unique<OpenRecord>(OpenRecord{
      .file = std::move(file), .names = names, .force = std::move(force), .accel = std::move(accel), .layout = layout});
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
  record.fs_Hz = read_rate_Hz(*opened, options, record.notes);
  describe_signals(*opened, options, record);
  describe_rows(*opened, record);
  if (options.fs_Hz) keep_missing_samples(opened->file, record);
  record.geometry = hdf5::read_geometry(opened->file);
  record.trace_lines = hdf5::read_trace_lines(opened->file, record.geometry.size());
  record.trace_faces = hdf5::read_trace_faces(opened->file, record.geometry.size());
  note_unused(opened->file, opened->names, record);
  record.contiguous = contiguous_signals(*opened);
  // Closing the data sets uses the library, so the deleter needs a lock.
  const std::shared_ptr<const OpenRecord> open(opened.release(), [](const OpenRecord* last) {
    const hdf5::Lock closing;
    delete last;
  });
  record.read_force_N = [open](std::size_t row, std::size_t first, std::span<double> out) {
    read_force(*open, row, first, out);
  };
  if (!record.has_force) record.read_force_N = no_force();
  record.read_accel_mps2 = [open](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    read_accel(*open, row, channel, first, out);
  };
  return record;
}

}  // namespace percuss::acquire
