#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "acquire/calibrate.hpp"
#include "bindings.hpp"
#include "cli/nearest.hpp"
#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "option_names.hpp"
#include "report/text/version.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;

py::str part(std::string_view text) {
  constexpr std::size_t kMaxBytes = 600;  // as in InputError::what()
  return decoded(one_line(text, kMaxBytes));
}

// The exceptions are classes of Python, with the parts of the error as attributes.
template <class... Parts>
void raise(const char* name, const Parts&... parts) {
  const py::object type = py::module_::import("percuss._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(parts...).ptr());
}

void raise_input_error(const char* name, const InputError& error) {
  raise(name, part(error.problem()), part(error.where()), part(error.remedy()), py::cast(error.options()));
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): pybind11's signature
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const acquire::NoHitError& error) {
    raise_input_error("NoHitError", error);
  } catch (const InputError& error) {
    raise_input_error("InputError", error);
  } catch (const tools::OptionError& error) {
    raise("UsageError", part(error.problem()), part(error.remedy()), py::cast(error.options()), decoded(error.value()),
          py::cast(error.remedy_options()));
  } catch (const UsageError& error) {
    raise("UsageError", decoded(error.what()));
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, kOutOfMemoryMessage);
  }
}

tools::InMemoryInput input_of(const py::handle& one) {
  if (py::isinstance<RecordHandle>(one)) return in_memory_input(one.cast<std::shared_ptr<RecordHandle>>());
  const auto frfs = one.cast<std::shared_ptr<const acquire::FrfRecord>>();
  return [frfs](const acquire::FrfReadOptions&) { return *frfs; };
}

std::shared_ptr<ResultHandle> run(const std::vector<std::string>& words, const py::list& inputs,
                                  const std::map<std::string, std::string>& names) {
  for (const std::string& word : words) {
    if (word.find('\0') != std::string::npos)
      throw UsageError("a zero byte in '" + one_line(word, 60) + "'", "remove it");
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
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // an interrupt ended the readers of files
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
  py::register_exception_translator(&translate);
  bind_records(module);
  bind_outcome(module);
  bind_numbers(module);
  bind_overhead(module);
  module.attr("version") = report::version();
  module.def("run", &run, py::arg("words"), py::arg("inputs"), py::arg("names") = py::dict());
  module.def("declared_commands", &declared_commands);
  module.def("nearest", &tools::nearest);
  module.def("option_in_python", &option_in_python);
}

}  // namespace percuss::python
