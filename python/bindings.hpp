#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "array_record.hpp"
#include "cli/host.hpp"
#include "core/error.hpp"
#include "core/visible_text.hpp"
#include "run_command.hpp"

namespace percuss::python {

/// A record that Python holds: from a file, from `synth`, or from arrays, to which reading options still apply.
struct RecordHandle {
  acquire::Record record;
  std::shared_ptr<const ArrayTest> arrays{};
};
RecordHandle record_handle(const std::shared_ptr<const ArrayTest>& test);

/// The record as an input of a command.
tools::InMemoryInput in_memory_input(const std::shared_ptr<const RecordHandle>& held);

/// The result of a command. Functions that compute more of the result lock `mutex`, since only one thread at a time may
/// use an Analysis.
struct ResultHandle {
  int code = 0;
  tools::CommandResult outcome;
  std::vector<std::pair<std::shared_ptr<const ArrayTest>, std::uint64_t>>
      arrays{};  // with their checksums before the run
  std::mutex mutex{};
};
using SharedResult = std::shared_ptr<ResultHandle>;

/// The analysis of one test. Throws IndexError, and InputError for a result without FRFs.
const std::shared_ptr<const pipeline::Analysis>& analysis_of(const SharedResult& held, std::size_t test);

/// Calls the function without Python's lock, one thread at a time. A reference that it returns stays valid.
template <class Function>
decltype(auto) without_gil(const SharedResult& held, const Function& function) {
  const pybind11::gil_scoped_release release;
  const std::scoped_lock lock(held->mutex);
  return function();
}

std::vector<double> freq_Hz_of(const acquire::LineRange& lines);

/// The stabilisation diagram as columns (poles).
pybind11::dict stabilisation_of(const SharedResult& held, std::size_t test);
/// A survey's shapes (modes, places), their MAC (modes, modes) and the mode indicator (lines, values). Throws TypeError
/// for other results.
pybind11::dict shapes_of(const SharedResult& held);

/// Responses as [(point, channel, averages, value, std or None, coherence or None)]: views of `count` spectral lines of
/// `frfs` from `first` on, which keep `owner` alive.
pybind11::list responses_of(const std::vector<acquire::PointFrf>& frfs, std::size_t first, std::size_t count,
                            const std::shared_ptr<const void>& owner);

/// Text that need not be UTF-8, such as the name of a file.
pybind11::str decoded(std::string_view text);

/// Notes as [(text, [option identifiers])], which note_in_python of _errors.py converts to text.
template <class Notes>
pybind11::list notes_of(const Notes& notes) {
  pybind11::list out;
  for (const auto& note : notes) {
    const Message message{note};
    pybind11::list options;
    for (const OptionId& option : message.options) options.append(decoded(option));
    out.append(pybind11::make_tuple(decoded(visible_text(message.text)), options));
  }
  return out;
}

void bind_records(pybind11::module_& module);
void bind_outcome(pybind11::module_& module);  // the results of commands
void bind_numbers(pybind11::module_& module);  // functions of arrays: mac
/// Adds the run time of the library without Python, for bench_overhead.py.
void bind_overhead(pybind11::module_& module);

}  // namespace percuss::python
