#include <optional>
#include <utility>

#include "acquire/channels/frf_unit.hpp"
#include "acquire/record/point_number.hpp"
#include "bindings.hpp"
#include "signal_object.hpp"

namespace percuss::python {
namespace {

std::optional<double> number_or_none(const Object& one) {
  return one.is_none() ? std::nullopt : std::optional(one.number());
}

// (frequency_hz, values, std or None, coherence or None, kind, points, channels, averages, decay_per_s): the arrays are
// contiguous, (points, channels, lines); a channel is (name, angle_rad or None, position_m or None).
std::shared_ptr<const acquire::StoredFrfs> stored_frfs_of(const Arguments& arguments) {
  auto stored = std::make_shared<acquire::StoredFrfs>();
  stored->record.format = "arrays";
  stored->record.lines = acquire::lines_from_frequencies(copied_values<double>(arguments[0]), "frequency_hz");
  stored->kind = frf_kind_of(arguments[4]);
  const std::vector<Object> points = arguments[5].items(), channels = arguments[6].items();
  stored->record.decay_per_s = arguments[8].number();
  for (const Object& one : channels) {
    stored->record.accel.push_back({.name = one.at(0).text(),
                                    .unit = "",
                                    .angle_rad = number_or_none(one.at(1)),
                                    .position_m = number_or_none(one.at(2))});
  }
  const auto values = copied_values<std::complex<double>>(arguments[1]);
  const auto optional = [&](std::size_t i) {
    return arguments[i].is_none() ? std::vector<double>() : copied_values<double>(arguments[i]);
  };
  const std::vector<double> std = optional(2), coherence = optional(3);
  const std::size_t lines = stored->record.lines.count;
  const auto part = [lines](const auto& all, std::size_t at) {
    if (all.empty()) return all;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(at * lines);
    return std::decay_t<decltype(all)>(first, first + static_cast<std::ptrdiff_t>(lines));
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto point = static_cast<int>(points[p].whole());
    acquire::require_point_number(point, "points");
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const std::size_t at = p * channels.size() + c;
      stored->frfs.push_back({.point = point,
                              .channel = c,
                              .value = part(values, at),
                              .std = part(std, at),
                              .coherence = part(coherence, at),
                              .averages = static_cast<std::size_t>(arguments[7].whole())});
    }
  }
  return stored;
}

PyObject* make_frfs(PyTypeObject* /*type*/, PyObject* arguments, PyObject* /*keywords*/) {
  try {
    const auto stored = stored_frfs_of(Arguments(arguments));
    auto record = acquire::to_accelerances(*stored, {});
    return FrfClass::wrap(std::make_shared<FrfHandle>(FrfHandle{.record = std::move(record), .arrays = stored}))
        .release();
  } catch (...) {
    set_python_exception();
    return nullptr;
  }
}

Object frf_description(PyObject* self, const Arguments& /*arguments*/) {
  const acquire::FrfRecord& record = FrfClass::of(self)->record;
  Dictionary out;
  std::vector<Object> accel;
  for (const acquire::SignalInfo& signal : record.accel) accel.push_back(object_of(signal));
  out.set("format", record.format);
  out.set("source", record.source());
  out.set("kind", acquire::name_of(record.kind));
  out.set("estimator", record.estimator);
  out.set("accel", accel);
  out.set("decay_per_s", record.decay_per_s);
  out.set("notes", notes_of(record.notes));
  out.set("frequency_hz", array_of(acquire::frequencies_Hz(record.lines)));
  return out;
}

Object responses_of_record(PyObject* self, const Arguments& /*arguments*/) {
  const auto& held = FrfClass::of(self);
  return responses_of(held->record.frfs, 0, held->record.lines.count, held);
}

}  // namespace

acquire::FrfKind frf_kind_of(const Object& name) {
  const std::optional<acquire::FrfKind> kind = acquire::parse_frf_kind(name.text());
  if (!kind)
    throw UsageError("no kind of FRF: " + one_line(name.text(), 60), "give accelerance, mobility or receptance");
  return *kind;
}

tools::InMemoryInput in_memory_input(const Object& one) {
  if (FrfClass::is(one)) {
    const std::shared_ptr<const FrfHandle> held = FrfClass::of(one.get());
    return [held](const acquire::FrfReadOptions& options) -> std::variant<acquire::Record, acquire::FrfRecord> {
      return held->arrays ? acquire::to_accelerances(*held->arrays, options) : held->record;
    };
  }
  if (!RecordClass::is(one)) raise_builtin(PyExc_TypeError, "an input is a RecordHandle or a FrfHandle");
  const std::shared_ptr<const RecordHandle> held = RecordClass::of(one.get());
  return [held](const acquire::FrfReadOptions& options) -> std::variant<acquire::Record, acquire::FrfRecord> {
    if (held->arrays) return record_of_arrays(held->arrays, options.read);
    if (!held->record.has_force && !options.read.force_optional)
      throw InputError("no force", held->record.source(), "give a record of force and acceleration");
    return held->record;
  };
}

Object responses_of(const std::vector<acquire::PointFrf>& frfs, std::size_t first, std::size_t count,
                    const std::shared_ptr<const void>& owner) {
  const auto within = [&](const auto& values) { return view_of(std::span(values).subspan(first, count), owner); };
  const auto optional = [&](const std::vector<double>& values) {
    return values.empty() ? Object::none() : within(values);
  };
  std::vector<Object> out;
  for (const acquire::PointFrf& one : frfs) {
    out.push_back(tuple_of(one.point, one.channel, one.frf.averages, within(one.frf.value), optional(one.frf.std),
                           optional(one.frf.coherence)));
  }
  return object_of(out);
}

void bind_frfs(PyObject* module) {
  FrfClass::add(
      module, "percuss._percuss.FrfHandle",
      {method<&frf_description>("describe"), method<&responses_of_record>("responses")},
      {property<[](PyObject* self) { return object_of(FrfClass::of(self)->arrays != nullptr); }>("from_arrays")},
      &make_frfs);
}

}  // namespace percuss::python
