#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <new>

#include "acquire/calibrate.hpp"
#include "bindings.hpp"
#include "core/error.hpp"
#include "nearest.hpp"
#include "report/version.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;

// Named as the user finds them, and pickled by that name.
template <class Error>
void add_exception(py::module_& module, const char* name, const py::handle& base, const char* what) {
  auto& made = py::register_exception<Error>(module, name, base);
  made.attr("__module__") = "percuss";
  made.attr("__doc__") = what;
}

void add_exceptions(py::module_& module) {
  add_exception<InputError>(module, "InputError", PyExc_ValueError,
                            "Input that cannot be used, in the words of the command line: problem (where); remedy.");
  add_exception<UsageError>(module, "UsageError", module.attr("InputError"),
                            "An option's value, or options that contradict each other, in the same form.");
  add_exception<NoHitError>(module, "NoHitError", module.attr("InputError"),
                            "No hit can be used: the analysis is impossible.");
}

tools::GivenInput input_of(const py::handle& one) {
  if (py::isinstance<HeldRecord>(one)) return given(one.cast<std::shared_ptr<HeldRecord>>());
  const auto frfs = one.cast<std::shared_ptr<const FrfRecord>>();
  return [frfs](const FrfReadOptions&) { return *frfs; };
}

std::shared_ptr<HeldOutcome> run(const std::vector<std::string>& words, const py::list& inputs) {
  std::vector<tools::GivenInput> data;
  for (const auto& one : inputs) data.push_back(input_of(one));
  auto held = std::make_shared<HeldOutcome>();
  try {
    const py::gil_scoped_release release;
    Ran ran = run_command(words, std::move(data));
    held->code = ran.code;
    held->outcome = std::move(ran.outcome);
  } catch (const InputError&) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // interrupted, and so were the readers of files
    throw;
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(kNoMemory);
  }
  return held;
}

}  // namespace

PYBIND11_MODULE(_percuss, module) {
  add_exceptions(module);
  bind_records(module);
  bind_outcome(module);
  bind_numbers(module);
  bind_overhead(module);
  module.attr("version") = version();
  module.def("run", &run);
  module.def("declared_commands", &declared_commands);
  module.def("nearest", &tools::nearest);
}

}  // namespace percuss::python
