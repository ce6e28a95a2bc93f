#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "array_record.hpp"
#include "cli/host.hpp"
#include "run_command.hpp"

namespace percuss::python {

/// A record that Python holds: from a file, from `synth`, or of its own arrays, which options may still reinterpret.
struct RecordHandle {
  acquire::Record record;
  std::shared_ptr<const ArrayTest> arrays{};
};
RecordHandle record_handle(const std::shared_ptr<const ArrayTest>& test);

/// As a command's input.
tools::InMemoryInput given(const std::shared_ptr<const RecordHandle>& held);

/// What a command came to, for Python. What computes more takes the lock, since an analysis is one thread's at a time.
struct ResultHandle {
  int code = 0;
  tools::CommandResult outcome;
  std::vector<std::pair<std::shared_ptr<const ArrayTest>, std::uint64_t>> arrays{};  // and their sums before it ran
  std::mutex mutex{};
};
using SharedResult = std::shared_ptr<ResultHandle>;

/// The analysis of one of its tests. errors  IndexError.
const std::shared_ptr<const pipeline::Analysis>& analysis_of(const SharedResult& held, std::size_t test);

/// Computes without Python's lock, one thread at a time. What the function returns by reference stays where it is.
template <class Function>
decltype(auto) without_gil(const SharedResult& held, const Function& function) {
  const pybind11::gil_scoped_release release;
  const std::scoped_lock lock(held->mutex);
  return function();
}

std::vector<double> freq_Hz_of(const frf::LineRange& lines);

/// The stabilisation diagram as columns, and a survey's shapes, their MAC and the mode indicator.
pybind11::dict stabilisation_of(const SharedResult& held, std::size_t test);
pybind11::dict shapes_of(const SharedResult& held);

/// Responses as [(point, channel, averages, value, std or None, coherence or None)], views of `count` lines of `frfs`
/// from `first` on that keep `owner`.
pybind11::list responses_of(const std::vector<frf::PointFrf>& frfs, std::size_t first, std::size_t count,
                            const std::shared_ptr<const void>& owner);

/// Text of files' names and the like, which need not be UTF-8.
pybind11::str decoded(std::string_view text);

void bind_records(pybind11::module_& module);
void bind_outcome(pybind11::module_& module);
void bind_numbers(pybind11::module_& module);
void bind_overhead(pybind11::module_& module);

}  // namespace percuss::python
