#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "option_names.hpp"
#include "signal_object.hpp"

namespace percuss::python {
namespace {

const SharedResult& held_by(PyObject* self) { return ResultClass::of(self); }

std::size_t test_in(const Arguments& arguments) { return static_cast<std::size_t>(arguments[0].whole()); }

Object frequencies_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  const pipeline::Analysis& analysis = *analysis_of(held, test_in(arguments));
  return array_of(acquire::frequencies_Hz(compute(held, [&] { return band_of(analysis); })));
}

Object window_decay_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  const pipeline::Analysis& analysis = *analysis_of(held, test_in(arguments));
  return object_of(compute(held, [&] { return analysis.window_decay_per_s(); }));
}

// Views of the FRFs of the analysis; copies for another kind.
Object frfs_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  const auto analysis = analysis_of(held, test_in(arguments));
  const acquire::FrfKind kind = frf_kind_of(arguments[1]);
  const auto& frfs = compute(
      held, [&]() -> const auto& { return analysis->frfs(); });
  const acquire::LineRange band = compute(held, [&] { return band_of(*analysis); });
  const std::size_t first = band.first - analysis->lines().first;
  if (kind == acquire::FrfKind::accelerance) return responses_of(frfs, first, band.count, analysis);
  auto made = std::make_shared<std::vector<acquire::PointFrf>>(frfs);
  for (acquire::PointFrf& one : *made)
    one.frf = acquire::converted(one.frf, analysis->lines(), kind, analysis->window_decay_per_s());
  return responses_of(*made, first, band.count, made);
}

// The accelerations of a test, as Frf.signals.
Object signals_of(PyObject* self, const Arguments& arguments) {
  std::vector<Object> out;
  for (const acquire::SignalInfo& signal : analysis_of(held_by(self), test_in(arguments))->record().accel)
    out.push_back(object_of(signal));
  return object_of(out);
}

// [(hit, channel, point, first_s, velocity, deflection, std or None)]
Object deflections_of(PyObject* self, const Arguments& /*arguments*/) {
  const auto& test = held_by(self)->outcome.deflection;
  if (!test) raise_builtin(PyExc_TypeError, "the result has no deflection");
  std::vector<Object> out;
  for (const pipeline::DeflectedHit& hit : test->hits) {
    const auto view = [&](const std::vector<double>& values) { return view_of(std::span<const double>(values), test); };
    const auto& std = hit.deflection.std_m;
    out.push_back(tuple_of(hit.hit, hit.channel, hit.point, hit.first_s, view(hit.deflection.velocity_mps),
                           view(hit.deflection.deflection_m), std.empty() ? Object::none() : view(std)));
  }
  return object_of(out);
}

Object columns_of(PyObject* self, const Arguments& /*arguments*/) {
  const SharedResult& held = held_by(self);
  Dictionary out;
  for (const report::NumericColumn& column : held->outcome.columns)
    out.set(column.name.c_str(), view_of(std::span<const double>(column.values), held));
  for (const report::WordColumn& column : held->outcome.words) {
    const Object words = call(imported("numpy").attribute("array"), column.values);
    call(words.attribute("setflags"), false);  // write
    out.set(column.name.c_str(), words);
  }
  return out;
}

Object table_csv_of(PyObject* self, const Arguments& /*arguments*/) { return object_of(held_by(self)->outcome.table); }

Object record_of(PyObject* self, const Arguments& /*arguments*/) {
  const auto& test = held_by(self)->outcome.synthetic;
  if (!test) return Object::none();
  return RecordClass::wrap(std::make_shared<RecordHandle>(RecordHandle{.record = test->record}));
}

Object opened_of(PyObject* self, const Arguments& /*arguments*/) {
  std::vector<Object> out;
  for (const auto& one : held_by(self)->outcome.opened) {
    if (const auto* record = std::get_if<acquire::Record>(&one)) {
      out.push_back(RecordClass::wrap(std::make_shared<RecordHandle>(RecordHandle{.record = *record})));
    } else {
      out.push_back(FrfClass::wrap(
          std::make_shared<FrfHandle>(FrfHandle{.record = std::get<acquire::FrfRecord>(one), .arrays = nullptr})));
    }
  }
  return object_of(out);
}

std::size_t tests_of(const ResultHandle& held) { return std::max(held.outcome.tests, held.outcome.analyses.size()); }

// A .json file holds the document, which does not need the arrays any more.
void require_same_arrays(const ResultHandle& held, const std::string& path) {
  if (tools::extension_of(path) == ".json") return;
  for (const auto& [test, sum] : held.arrays) {
    if (sample_checksum(*test) != sum)
      throw InputError("the arrays have changed since the analysis", "save", "save earlier, or analyze them again");
  }
}

// The result of one of several tests, as if it had been given alone.
Object result_of_test(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  const std::size_t test = test_in(arguments);
  if (test >= held->outcome.tests || !held->outcome.of_test)
    raise_builtin(PyExc_IndexError, "there is no test " + std::to_string(test) + ": the result has " +
                                        std::to_string(held->outcome.tests) + ", from 0");
  auto made = std::make_shared<ResultHandle>();
  made->outcome = compute(held, [&] { return held->outcome.of_test(test); });
  made->code = made->outcome.possible ? tools::kOk : tools::kImpossible;
  made->arrays = held->arrays;
  made->mutex = held->mutex;
  return ResultClass::wrap(std::move(made));
}

Object text_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  if (!held->outcome.text) return object_of("");
  const auto width = static_cast<std::size_t>(arguments[0].whole());
  return object_of(compute(held, [&] { return visible_text(held->outcome.text(width, option_in_python)); }));
}

Object html_of(PyObject* self, const Arguments& /*arguments*/) {
  const SharedResult& held = held_by(self);
  return object_of(held->outcome.html ? compute(held, [&] { return held->outcome.html(); }) : std::string());
}

// save(path, force[, ((option of the page, value), ...)]); the path and the values are bytes.
Object save(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  tools::SaveRequest request{.path = arguments[0].bytes(), .force = arguments[1].truth()};
  const std::string& path = request.path;
  if (arguments.size() > 2) {
    for (const Object& option : arguments[2].items()) {
      const std::vector<Object> pair = option.items();
      request.page[pair.at(0).text()] = pair.at(1).bytes();
    }
  }
  if (!held->outcome.save)
    throw UsageError("save() does not write this result: " + one_line(path), "write its json to a file");
  compute(held, [&] {
    require_same_arrays(*held, path);
    held->outcome.save(request);
  });
  return Object::none();
}

Object possible(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = held_by(self);
  if (held->outcome.analyses.empty() && held->outcome.tests > 0) return object_of(held->outcome.possible);
  const auto analysis = analysis_of(held, test_in(arguments));
  return object_of(compute(held, [&] { return analysis->possible(); }));
}

}  // namespace

const std::shared_ptr<const pipeline::Analysis>& analysis_of(const SharedResult& held, std::size_t test) {
  const auto& all = held->outcome.analyses;
  if (all.empty()) {
    throw InputError("the result holds no FRFs", "analysis without a force", "analyse a record with a force",
                     {"force_channel"});
  }
  if (test >= all.size())
    raise_builtin(PyExc_IndexError, "there is no test " + std::to_string(test) + ": the result has " +
                                        std::to_string(all.size()) + ", from 0");
  return all[test];
}

acquire::LineRange band_of(const pipeline::Analysis& analysis) {
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  return frf::lines_in_band(analysis.lines().fs_Hz, analysis.lines().samples, low_Hz, high_Hz);
}

void bind_outcome(PyObject* module) {
  ResultClass::add(
      module, "percuss._percuss.CommandResult",
      {method<&text_of>("text"), method<&html_of>("html"), method<&save>("save"), method<&possible>("possible"),
       method<&frequencies_of>("frequency_hz"), method<&window_decay_of>("window_decay_per_s"),
       method<&frfs_of>("frfs"), method<&modes_of>("modes"), method<&residual_terms_of>("residual_terms"),
       method<&stabilisation_of>("stabilisation"), method<&shapes_of>("shapes"), method<&deflections_of>("deflections"),
       method<&columns_of>("columns"), method<&table_csv_of>("table_csv"), method<&record_of>("record"),
       method<&opened_of>("opened"), method<&result_of_test>("of_test"), method<&signals_of>("signals")},
      {property<[](PyObject* self) { return object_of(held_by(self)->code); }>("code"),
       property<[](PyObject* self) { return object_of(held_by(self)->outcome.document); }>("document"),
       property<[](PyObject* self) { return notes_of(held_by(self)->outcome.notes); }>("notes"),
       property<[](PyObject* self) { return object_of(tests_of(*held_by(self))); }>("tests")});
}

}  // namespace percuss::python
