#include <map>

#include "acquire/record/point_number.hpp"
#include "bindings.hpp"
#include "core/error.hpp"
#include "signal_object.hpp"

namespace percuss::python {
namespace {

NumberType type_of(const Object& array, const std::string& type, const std::string& name) {
  static const std::map<std::string, NumberType> known{{"<f8", NumberType::float64}, {"<f4", NumberType::float32},
                                                       {"|i1", NumberType::int8},    {"<i2", NumberType::int16},
                                                       {"<i4", NumberType::int32},   {"<i8", NumberType::int64},
                                                       {"|u1", NumberType::uint8},   {"<u2", NumberType::uint16},
                                                       {"<u4", NumberType::uint32},  {"<u8", NumberType::uint64}};
  const auto found = known.find(type);
  if (found != known.end()) return found->second;
  const Object text = Object::owned(PyObject_Str(array.attribute("dtype").get()));
  throw InputError("numbers of type " + one_line(text.text(), 60) + " cannot be samples", name,
                   "give real numbers, for example array.astype(float); FRFs are percuss.Frf(frequency_hz, H)");
}

StridedSamples strided_samples_of(const Object& array, const std::string& name) {
  const GivenArray given = given_array(array);
  if (given.shape.size() != 1) throw InputError("not a one-dimensional signal", name, "give a row of samples");
  StridedSamples signal{.first = given.first, .samples = given.shape.front(), .type = type_of(array, given.type, name)};
  signal.step_bytes =
      given.strides_bytes.empty() ? static_cast<std::ptrdiff_t>(size_of(signal.type)) : given.strides_bytes.front();
  if (signal.samples > 1 && signal.step_bytes == 0) {
    throw InputError("one number stands for all samples (a broadcast array)", name,
                     "copy the samples, for example with numpy.ascontiguousarray");
  }
  return signal;
}

// Any thread may release a Python object, but only under Python's lock.
std::shared_ptr<void> owner_of(Object object) {
  auto* const held = new Object(std::move(object));
  return {held, [](Object* object_held) {
            const PyGILState_STATE lock = PyGILState_Ensure();
            delete object_held;
            PyGILState_Release(lock);
          }};
}

void require_samples(const ArrayRow& row, const ArrayTest& test, bool has_force, std::size_t r) {
  for (const StridedSamples& signal : row.accel) {
    const std::size_t wanted = has_force ? row.force.samples : row.accel.front().samples;
    if (signal.samples == wanted) continue;
    throw InputError(
        "row " + std::to_string(r) + ": " + std::to_string(signal.samples) + " samples of acceleration for " +
            std::to_string(wanted) + (has_force ? " of force" : " of the first acceleration"),
        "arrays",
        has_force ? "give the same number of samples: force (hits, samples), accel (hits, channels, samples)"
                  : "give the same number of samples: accel (hits, channels, samples)");
  }
  if (has_force != test.has_force || (r > 0 && row.accel.size() != test.rows.front().accel.size()))
    throw InputError("row " + std::to_string(r) + " has other channels than the first", "arrays",
                     "give the same channels in every row");
}

// (rows, points, fs_hz, continuous, names, geometry); each row is a tuple (force or None, [accelerations]).
std::shared_ptr<const ArrayTest> test_of(const Arguments& arguments) {
  auto test = std::make_shared<ArrayTest>();
  const std::vector<Object> rows = arguments[0].items(), points = arguments[1].items();
  test->fs_Hz = arguments[2].number();
  test->continuous = arguments[3].truth();
  for (const Object& name : arguments[4].items()) test->names.push_back(name.text());
  for (const Object& place : arguments[5].items()) {
    test->geometry.emplace_back();
    for (const Object& coordinate : place.items()) test->geometry.back().push_back(coordinate.number());
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    ArrayRow made{.point = points.empty() ? 0 : static_cast<int>(points.at(r).whole())};
    acquire::require_point_number(made.point, "arrays");
    for (const Object& one : rows[r].at(1).items()) made.accel.push_back(strided_samples_of(one, "accel"));
    const Object force = rows[r].at(0);
    if (r == 0) test->has_force = !force.is_none();
    if (!force.is_none()) made.force = strided_samples_of(force, "force");
    require_samples(made, *test, !force.is_none(), r);
    test->rows.push_back(std::move(made));
  }
  test->owner = owner_of(arguments[0]);
  return test;
}

// A view of samples in memory, or a new array of samples from a file.
template <class Look>
Object samples_of(const std::shared_ptr<RecordHandle>& held, std::size_t samples, const Look& view_or_read) {
  std::vector<double> buffer;
  std::span<const double> seen;
  {
    const ReleasedLock released;
    seen = view_or_read(samples, buffer);
  }
  if (seen.data() != buffer.data()) return view_of(seen, held);
  return array_of(std::move(buffer));
}

std::size_t checked_row(const acquire::Record& record, const Object& row) {
  const auto at = static_cast<std::size_t>(row.whole());
  if (at >= record.rows.size())
    raise_builtin(PyExc_IndexError, "there is no row " + std::to_string(at) + ": the record has " +
                                        std::to_string(record.rows.size()) + ", from 0");
  return at;
}

Object force_of(PyObject* self, const Arguments& arguments) {
  const auto& held = RecordClass::of(self);
  const acquire::Record& record = held->record;
  const std::size_t row = checked_row(record, arguments[0]);
  return samples_of(held, record.rows[row].samples, [&](std::size_t count, std::vector<double>& buffer) {
    return record.read_force_N.view_or_read(row, 0, count, buffer);
  });
}

Object accel_of(PyObject* self, const Arguments& arguments) {
  const auto& held = RecordClass::of(self);
  const acquire::Record& record = held->record;
  const std::size_t row = checked_row(record, arguments[0]);
  const auto channel = static_cast<std::size_t>(arguments[1].whole());
  if (channel >= record.accel.size()) {
    raise_builtin(PyExc_IndexError, "there is no channel " + std::to_string(channel) + ": the record has " +
                                        std::to_string(record.accel.size()) + ", from 0");
  }
  return samples_of(held, record.rows[row].samples, [&](std::size_t count, std::vector<double>& buffer) {
    return record.read_accel_mps2.view_or_read(row, channel, 0, count, buffer);
  });
}

Object record_description(PyObject* self, const Arguments& /*arguments*/) {
  const acquire::Record& record = RecordClass::of(self)->record;
  Dictionary out;
  std::vector<Object> rows, accel;
  for (const acquire::RowInfo& row : record.rows) rows.push_back(tuple_of(row.samples, row.point, row.run));
  for (const acquire::SignalInfo& signal : record.accel) accel.push_back(object_of(signal));
  out.set("format", record.format);
  out.set("source", record.source());
  out.set("fs_hz", record.fs_Hz);
  out.set("continuous", record.continuous);
  out.set("force", record.has_force ? object_of(record.force) : Object::none());
  out.set("accel", accel);
  out.set("rows", rows);
  out.set("geometry", record.geometry);
  out.set("notes", notes_of(record.notes));
  return out;
}

PyObject* make_record(PyTypeObject* /*type*/, PyObject* arguments, PyObject* /*keywords*/) {
  try {
    const auto test = test_of(Arguments(arguments));
    acquire::ReadOptions as_given;
    as_given.force_optional = true;
    return RecordClass::wrap(
               std::make_shared<RecordHandle>(RecordHandle{.record = record_of_arrays(test, as_given), .arrays = test}))
        .release();
  } catch (...) {
    set_python_exception();
    return nullptr;
  }
}

}  // namespace

void bind_records(PyObject* module) {
  RecordClass::add(
      module, "percuss._percuss.RecordHandle",
      {method<&force_of>("force"), method<&accel_of>("accel"), method<&record_description>("describe")},
      {property<[](PyObject* self) { return object_of(RecordClass::of(self)->arrays != nullptr); }>("from_arrays")},
      &make_record);
}

}  // namespace percuss::python
