#include <chrono>
#include <exception>
#include <map>
#include <new>
#include <string_view>
#include <thread>

#include "acquire/calibrate.hpp"
#include "bindings.hpp"
#include "cli/nearest.hpp"
#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "option_names.hpp"
#include "report/text/version.hpp"

namespace percuss::python {
namespace {

std::string part(std::string_view text) {
  constexpr std::size_t kMaxBytes = 600;  // as in InputError::what()
  return one_line(text, kMaxBytes);
}

// The exceptions are classes of Python, with the parts of the error as attributes.
template <class... Parts>
void raise(const char* name, const Parts&... parts) {
  const Object type = imported("percuss._errors").attribute(name);
  PyErr_SetObject(type.get(), call(type, parts...).get());
}

void raise_input_error(const char* name, const InputError& error) {
  raise(name, part(error.problem()), part(error.where()), part(error.remedy()), error.options());
}

void rethrow_in_python() {
  try {
    throw;
  } catch (const PythonError&) {
  } catch (const Interrupted&) {  // the exception is set
  } catch (const acquire::NoHitError& error) {
    raise_input_error("NoHitError", error);
  } catch (const InputError& error) {
    raise_input_error("InputError", error);
  } catch (const tools::OptionError& error) {
    raise("UsageError", part(error.problem()), part(error.remedy()), error.options(), error.value(),
          error.remedy_options());
  } catch (const UsageError& error) {
    raise("UsageError", error.what());
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, kOutOfMemoryMessage);
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
}

std::vector<std::string> words_in(const Object& list) {
  std::vector<std::string> words;
  for (const Object& word : list.items()) {
    words.push_back(word.bytes());
    if (words.back().find('\0') != std::string::npos)
      throw UsageError("a zero byte in '" + one_line(words.back(), 60) + "'", "remove it");
  }
  return words;
}

// (words, inputs, [(path, display name)])
Object run(PyObject* /*module*/, const Arguments& arguments) {
  const std::vector<std::string> words = words_in(arguments[0]);
  std::vector<tools::InMemoryInput> data;
  auto held = std::make_shared<ResultHandle>();
  for (const Object& one : arguments[1].items()) {
    data.push_back(in_memory_input(one));
    if (!RecordClass::is(one)) continue;
    const auto& record = RecordClass::of(one.get());
    if (record->arrays) held->arrays.emplace_back(record->arrays, 0);
  }
  std::map<std::string, std::string> names;
  for (const Object& pair : arguments[2].items()) names.emplace(pair.at(0).text(), pair.at(1).text());
  try {
    const ReleasedLock released;
    const InterruptPolling polling;
    for (auto& [test, sum] : held->arrays) sum = sample_checksum(*test);
    RunResult ran = run_command(words, std::move(data), names);
    held->code = ran.code;
    held->outcome = std::move(ran.outcome);
  } catch (const InputError&) {
    if (PyErr_CheckSignals() != 0) throw PythonError();  // an interrupt ended the readers of files
    throw;
  }
  return ResultClass::wrap(std::move(held));
}

Object declared(PyObject* /*module*/, const Arguments& /*arguments*/) { return object_of(declared_commands()); }

Object nearest(PyObject* /*module*/, const Arguments& arguments) {
  std::vector<std::string> known;
  for (const Object& one : arguments[1].items()) known.push_back(one.text());
  return object_of(tools::nearest(arguments[0].text(), known));
}

Object option(PyObject* /*module*/, const Arguments& arguments) {
  return object_of(option_in_python(arguments[0].text()));
}

// Ends the calls of other threads, and waits for them. They check every few milliseconds; a call that does not is left
// after ten seconds.
Object stop_calls(PyObject* /*module*/, const Arguments& /*arguments*/) {
  calls_must_stop = true;
  PyThreadState* const thread = PyEval_SaveThread();
  for (int waited_ms = 0; calls_without_lock > 0 && waited_ms < 10'000; ++waited_ms)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  PyEval_RestoreThread(thread);
  return object_of(true);
}

PyObject* make_module() {
  static PyMethodDef functions[] = {method<&run>("run"),
                                    method<&declared>("declared_commands"),
                                    method<&nearest>("nearest"),
                                    method<&option>("option_in_python"),
                                    method<&mac_between>("mac"),
                                    method<&common_points_of>("common_points"),
                                    method<&shape_over_points>("shape_over_points"),
                                    method<&library_seconds>("library_seconds"),
                                    method<&stop_calls>("stop_calls"),
                                    {nullptr, nullptr, 0, nullptr}};
  static PyModuleDef definition = {
      PyModuleDef_HEAD_INIT, "_percuss", nullptr, -1, functions, nullptr, nullptr, nullptr, nullptr};
  try {
    Object module = Object::owned(PyModule_Create(&definition));
    add_memory_class(module.get());
    bind_records(module.get());
    bind_frfs(module.get());
    bind_outcome(module.get());
    if (PyModule_AddStringConstant(module.get(), "version", report::version()) != 0) throw PythonError();
    return module.release();
  } catch (...) {
    set_python_exception();
    return nullptr;
  }
}

}  // namespace

void set_python_exception() {
  try {
    rethrow_in_python();
  } catch (const PythonError&) {  // a class of exception could not be found; Python has set another exception
  }
}

}  // namespace percuss::python

PyMODINIT_FUNC PyInit__percuss() { return percuss::python::make_module(); }
