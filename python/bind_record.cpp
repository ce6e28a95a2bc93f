#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>

#include "acquire/record/point_number.hpp"
#include "bindings.hpp"
#include "core/error.hpp"
#include "numpy_views.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;

NumberType type_of(const py::array& array, const std::string& name) {
  static const std::map<std::string, NumberType> known{
      {"f8", NumberType::float64}, {"f4", NumberType::float32}, {"i1", NumberType::int8},  {"i2", NumberType::int16},
      {"i4", NumberType::int32},   {"i8", NumberType::int64},   {"u1", NumberType::uint8}, {"u2", NumberType::uint16},
      {"u4", NumberType::uint32},  {"u8", NumberType::uint64}};
  const py::dtype type = array.dtype();
  const std::string text = type.kind() + std::to_string(type.itemsize());
  const auto found = known.find(text);
  const bool native = py::cast<bool>(type.attr("isnative"));
  if (found != known.end() && native) return found->second;
  throw InputError(
      "numbers of type " + one_line(py::cast<std::string>(type.attr("__str__")()), 60) + " cannot be samples", name,
      "give real numbers, for example array.astype(float)");
}

StridedSamples strided_samples_of(const py::array& array, const std::string& name) {
  if (array.ndim() != 1) throw InputError("not a one-dimensional signal", name, "give a row of samples");
  StridedSamples signal{.first = static_cast<const std::byte*>(array.data()),
                        .step_bytes = static_cast<std::ptrdiff_t>(array.strides(0)),
                        .samples = static_cast<std::size_t>(array.shape(0)),
                        .type = type_of(array, name)};
  if (signal.samples > 1 && signal.step_bytes == 0) {
    throw InputError("one number stands for all samples (a broadcast array)", name,
                     "copy the samples, for example with numpy.ascontiguousarray");
  }
  return signal;
}

// Any thread may release a Python object, but only under Python's lock.
std::shared_ptr<void> owner_of(py::object object) {
  auto* const held = new py::object(std::move(object));
  return {held, [](py::object* object_held) {
            const py::gil_scoped_acquire lock;
            delete object_held;
          }};
}

/// Each row is a tuple (force or None, [accelerations]) of one-dimensional arrays.
std::shared_ptr<const ArrayTest> test_of(const py::list& rows, const std::vector<int>& points, double fs_Hz,
                                         bool continuous, std::vector<std::string> names,
                                         std::vector<std::vector<double>> geometry) {
  auto test = std::make_shared<ArrayTest>();
  test->fs_Hz = fs_Hz;
  test->continuous = continuous;
  test->names = std::move(names);
  test->geometry = std::move(geometry);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto row = rows[r].cast<py::tuple>();
    ArrayRow made{.point = points.empty() ? 0 : points.at(r)};
    acquire::require_point_number(made.point, "arrays");
    const auto accel = row[1].cast<py::list>();
    for (const auto& one : accel) made.accel.push_back(strided_samples_of(one.cast<py::array>(), "accel"));
    const bool has_force = !row[0].is_none();
    if (r == 0) test->has_force = has_force;
    if (has_force) made.force = strided_samples_of(row[0].cast<py::array>(), "force");
    for (const StridedSamples& signal : made.accel) {
      const std::size_t wanted = has_force ? made.force.samples : made.accel.front().samples;
      if (signal.samples == wanted) continue;
      throw InputError("row " + std::to_string(r) + ": " + std::to_string(signal.samples) +
                           " samples of acceleration for " + std::to_string(wanted) + " of force",
                       "arrays",
                       "give the same number of samples: force (hits, samples), accel (hits, channels, samples)");
    }
    if (has_force != test->has_force || (r > 0 && made.accel.size() != test->rows.front().accel.size()))
      throw InputError("row " + std::to_string(r) + " has other channels than the first", "arrays",
                       "give the same channels in every row");
    test->rows.push_back(std::move(made));
  }
  test->owner = owner_of(rows);
  return test;
}

// A view of samples in memory, or a new array of samples from a file.
template <class Look>
py::array samples_of(const std::shared_ptr<const RecordHandle>& held, std::size_t samples, const Look& view_or_read) {
  py::array_t<double> own(static_cast<py::ssize_t>(0));
  std::vector<double> buffer;
  std::span<const double> seen;
  {
    const py::gil_scoped_release release;
    seen = view_or_read(samples, buffer);
  }
  if (seen.data() != buffer.data()) return view_of(seen, held);
  auto moved = std::make_shared<const std::vector<double>>(std::move(buffer));
  return view_of(std::span<const double>(*moved), moved);
}

std::size_t checked_row(const acquire::Record& record, std::size_t row) {
  if (row >= record.rows.size())
    throw py::index_error("row " + std::to_string(row) + " of " + std::to_string(record.rows.size()));
  return row;
}

py::array force_of(const std::shared_ptr<const RecordHandle>& held, std::size_t row) {
  const acquire::Record& record = held->record;
  const std::size_t samples = record.rows[checked_row(record, row)].samples;
  return samples_of(held, samples, [&](std::size_t count, std::vector<double>& buffer) {
    return record.read_force_N.view_or_read(row, 0, count, buffer);
  });
}

py::array accel_of(const std::shared_ptr<const RecordHandle>& held, std::size_t row, std::size_t channel) {
  const acquire::Record& record = held->record;
  const std::size_t samples = record.rows[checked_row(record, row)].samples;
  if (channel >= record.accel.size())
    throw py::index_error("channel " + std::to_string(channel) + " of " + std::to_string(record.accel.size()));
  return samples_of(held, samples, [&](std::size_t count, std::vector<double>& buffer) {
    return record.read_accel_mps2.view_or_read(row, channel, 0, count, buffer);
  });
}

py::dict signal_of(const acquire::SignalInfo& signal) {
  py::dict out;
  out["name"] = decoded(signal.name);
  out["unit"] = decoded(signal.unit);
  out["to_si"] = signal.to_SI;
  out["angle_rad"] = signal.angle_rad;
  out["position_m"] = signal.position_m;
  return out;
}

py::dict description_of(const RecordHandle& held) {
  const acquire::Record& record = held.record;
  py::dict out;
  py::list rows, accel;
  for (const acquire::RowInfo& row : record.rows) rows.append(py::make_tuple(row.samples, row.point, row.run));
  for (const acquire::SignalInfo& signal : record.accel) accel.append(signal_of(signal));
  out["format"] = record.format;
  out["source"] = decoded(record.source());
  out["fs_hz"] = record.fs_Hz;
  out["continuous"] = record.continuous;
  out["force"] = record.has_force ? py::object(signal_of(record.force)) : py::none();
  out["accel"] = accel;
  out["rows"] = rows;
  out["geometry"] = record.geometry;
  out["notes"] = notes_of(record.notes);
  return out;
}

py::dict description_of(const acquire::FrfRecord& record) {
  py::dict out;
  py::list accel;
  for (const acquire::SignalInfo& signal : record.accel) accel.append(signal_of(signal));
  out["format"] = record.format;
  out["source"] = decoded(record.source());
  out["kind"] = name_of(record.kind);
  out["estimator"] = record.estimator;
  out["accel"] = accel;
  out["notes"] = notes_of(record.notes);
  std::vector<double> freq_Hz(record.lines.count);
  for (std::size_t i = 0; i < freq_Hz.size(); ++i) freq_Hz[i] = record.lines.freq_Hz(i);
  out["frequency_hz"] = copy_of(std::span<const double>(freq_Hz));
  return out;
}

}  // namespace

RecordHandle record_handle(const std::shared_ptr<const ArrayTest>& test) {
  acquire::ReadOptions as_given;
  as_given.force_optional = true;
  return {.record = record_of_arrays(test, as_given), .arrays = test};
}

tools::InMemoryInput in_memory_input(const std::shared_ptr<const RecordHandle>& held) {
  return [held](const acquire::FrfReadOptions& options) -> std::variant<acquire::Record, acquire::FrfRecord> {
    if (held->arrays) return record_of_arrays(held->arrays, options.read);
    if (!held->record.has_force && !options.read.force_optional)
      throw InputError("no force", held->record.source(), "give a record of force and acceleration");
    return held->record;
  };
}

void bind_records(py::module_& module) {
  py::class_<RecordHandle, std::shared_ptr<RecordHandle>>(module, "RecordHandle")
      .def(py::init([](const py::list& rows, const std::vector<int>& points, double fs_Hz, bool continuous,
                       const std::vector<std::string>& names, const std::vector<std::vector<double>>& geometry) {
        return std::make_shared<RecordHandle>(record_handle(test_of(rows, points, fs_Hz, continuous, names, geometry)));
      }))
      .def("force", &force_of)
      .def("accel", &accel_of)
      .def_property_readonly("from_arrays", [](const RecordHandle& held) { return held.arrays != nullptr; })
      .def("describe", [](const RecordHandle& held) { return description_of(held); });
  py::class_<acquire::FrfRecord, std::shared_ptr<acquire::FrfRecord>>(module, "FrfHandle")
      .def("describe", [](const acquire::FrfRecord& record) { return description_of(record); })
      .def("responses", [](const std::shared_ptr<const acquire::FrfRecord>& record) {
        return responses_of(record->frfs, 0, record->lines.count, record);
      });
}

}  // namespace percuss::python
