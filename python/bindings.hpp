#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <vector>

#include "array_record.hpp"
#include "host.hpp"
#include "run_command.hpp"

namespace percuss::python {

/// A record that Python holds: from a file, from `synth`, or of its own arrays, which options may still reinterpret.
struct HeldRecord {
  Record record;
  std::shared_ptr<const ArrayTest> arrays{};
};
HeldRecord held_record(const std::shared_ptr<const ArrayTest>& test);

/// As a command's input.
tools::GivenInput given(const std::shared_ptr<const HeldRecord>& held);

/// What a command came to, for Python. What computes more takes the lock, since an analysis is one thread's at a time.
struct HeldOutcome {
  int code = 0;
  tools::Outcome outcome;
  std::mutex mutex{};
};

/// Responses as [(point, channel, averages, value, std or None, coherence or None)], views of `count` lines of `frfs`
/// from `first` on that keep `owner`.
pybind11::list responses_of(const std::vector<PointFrf>& frfs, std::size_t first, std::size_t count,
                            const std::shared_ptr<const void>& owner);

void bind_records(pybind11::module_& module);
void bind_outcome(pybind11::module_& module);
void bind_numbers(pybind11::module_& module);
void bind_overhead(pybind11::module_& module);

}  // namespace percuss::python
