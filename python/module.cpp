#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "acquire/calibrate.hpp"
#include "bindings.hpp"
#include "cli/nearest.hpp"
#include "core/error.hpp"
#include "report/text/version.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;

struct Exceptions {
  py::object input, usage, no_hit;
};

// Kept for as long as the interpreter: exceptions may be translated until its end.
Exceptions& exceptions() {
  static auto* const all = new Exceptions;  // NOLINT(cppcoreguidelines-owning-memory)
  return *all;
}

// Named as the user finds it, and pickled by that name.
py::object add_exception(py::module_& module, const std::string& name, const py::object& base, const char* what) {
  auto made = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(("percuss." + name).c_str(), what, base.ptr(), nullptr));
  if (!made) throw py::error_already_set();
  module.attr(name.c_str()) = made;
  return made;
}

void raise(const py::object& type, const std::exception& error) {
  PyErr_SetObject(type.ptr(), decoded(error.what()).ptr());
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): as pybind11 has it
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const acquire::NoHitError& error) {
    raise(exceptions().no_hit, error);
  } catch (const InputError& error) {
    raise(exceptions().input, error);
  } catch (const UsageError& error) {
    raise(exceptions().usage, error);
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, kOutOfMemoryMessage);
  }
}

void add_exceptions(py::module_& module) {
  Exceptions& all = exceptions();
  all.input = add_exception(module, "InputError", py::reinterpret_borrow<py::object>(PyExc_ValueError),
                            "Input that cannot be used, in the words of the command line: problem (where); remedy.");
  all.usage = add_exception(module, "UsageError", all.input,
                            "An option's value, or options that contradict each other, in the same form.");
  all.no_hit =
      add_exception(module, "NoHitError", all.input, "No hit can be used, so that there are no FRFs and no modes.");
  py::register_exception_translator(&translate);
}

tools::InMemoryInput input_of(const py::handle& one) {
  if (py::isinstance<RecordHandle>(one)) return given(one.cast<std::shared_ptr<RecordHandle>>());
  const auto frfs = one.cast<std::shared_ptr<const frf::FrfRecord>>();
  return [frfs](const frf::FrfReadOptions&) { return *frfs; };
}

std::shared_ptr<ResultHandle> run(const std::vector<std::string>& words, const py::list& inputs,
                                  const std::map<std::string, std::string>& names) {
  for (const std::string& word : words) {
    if (word.find('\0') != std::string::npos)
      throw UsageError("a zero byte in '" + one_line(word, 60) + "'", "leave it out");
  }
  std::vector<tools::InMemoryInput> data;
  auto held = std::make_shared<ResultHandle>();
  for (const auto& one : inputs) {
    data.push_back(input_of(one));
    if (!py::isinstance<RecordHandle>(one)) continue;
    const auto record = one.cast<std::shared_ptr<RecordHandle>>();
    if (record->arrays) held->arrays.emplace_back(record->arrays, 0);
  }
  try {
    const py::gil_scoped_release release;
    for (auto& [test, sum] : held->arrays) sum = sample_checksum(*test);
    RunResult ran = run_command(words, std::move(data), names);
    held->code = ran.code;
    held->outcome = std::move(ran.outcome);
  } catch (const InputError&) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // interrupted, and so were the readers of files
    throw;
  }
  return held;
}

}  // namespace

py::str decoded(std::string_view text) {
  PyObject* const made = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

PYBIND11_MODULE(_percuss, module) {
  add_exceptions(module);
  bind_records(module);
  bind_outcome(module);
  bind_numbers(module);
  bind_overhead(module);
  module.attr("version") = report::version();
  module.def("run", &run, py::arg("words"), py::arg("inputs"), py::arg("names") = py::dict());
  module.def("declared_commands", &declared_commands);
  module.def("nearest", &tools::nearest);
}

}  // namespace percuss::python
