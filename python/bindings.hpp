#pragma once
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "acquire/channels/stored_frfs.hpp"
#include "array_record.hpp"
#include "classes.hpp"
#include "cli/host.hpp"
#include "core/error.hpp"
#include "core/visible_text.hpp"
#include "interrupt.hpp"
#include "numpy_arrays.hpp"
#include "run_command.hpp"

namespace percuss::python {

/// A record that Python holds: from a file, from `synth`, or from arrays, to which reading options still apply.
struct RecordHandle {
  acquire::Record record;
  std::shared_ptr<const ArrayTest> arrays{};
};
using RecordClass = Class<RecordHandle>;

/// FRFs that Python holds: from a file, or from arrays, to which reading options still apply.
struct FrfHandle {
  acquire::FrfRecord record;
  std::shared_ptr<const acquire::StoredFrfs> arrays{};
};
using FrfClass = Class<FrfHandle>;

/// A record or FRFs as an input of a command.
tools::InMemoryInput in_memory_input(const Object& held);

/// The result of a command. Functions that compute more of the result lock `mutex`, since only one thread at a time may
/// use an Analysis.
struct ResultHandle {
  int code = 0;
  tools::CommandResult outcome;
  std::vector<std::pair<std::shared_ptr<const ArrayTest>, std::uint64_t>>
      arrays{};                                                        // with their checksums before the run
  std::shared_ptr<std::mutex> mutex = std::make_shared<std::mutex>();  // the parts of a result share it
};
using SharedResult = std::shared_ptr<ResultHandle>;
using ResultClass = Class<ResultHandle>;

/// The analysis of one test. Throws IndexError, and InputError for a result without FRFs.
const std::shared_ptr<const pipeline::Analysis>& analysis_of(const SharedResult& held, std::size_t test);

/// Calls the function without Python's lock, one thread at a time; an interrupt (Ctrl-C) stops the computation. A
/// reference that it returns stays valid.
template <class Function>
decltype(auto) compute(const SharedResult& held, const Function& function) {
  const ReleasedLock released;
  const std::scoped_lock lock(*held->mutex);
  const InterruptPolling polling;
  return function();
}

/// The analysed band; the fits also use spectral lines outside it.
acquire::LineRange band_of(const pipeline::Analysis& analysis);

/// The stabilisation diagram as columns (poles).
Object stabilisation_of(PyObject* self, const Arguments& arguments);
/// A survey's shapes (modes, places), their MAC (modes, modes) and the mode indicator (lines, values). Throws TypeError
/// for other results.
Object shapes_of(PyObject* self, const Arguments& arguments);
/// The columns of the modal parameters, and the residues (modes, FRFs).
Object modes_of(PyObject* self, const Arguments& arguments);
/// The residual terms and the FRAC of each FRF.
Object residual_terms_of(PyObject* self, const Arguments& arguments);

/// The kind that a text names. Throws UsageError for other texts.
acquire::FrfKind frf_kind_of(const Object& name);

/// Responses as [(point, channel, averages, value, std or None, coherence or None)]: views of `count` spectral lines of
/// `frfs` from `first` on, which keep `owner` alive.
Object responses_of(const std::vector<acquire::PointFrf>& frfs, std::size_t first, std::size_t count,
                    const std::shared_ptr<const void>& owner);

/// Notes as [(text, [option identifiers])], which note_in_python of _errors.py converts to text.
template <class Notes>
Object notes_of(const Notes& notes) {
  std::vector<Object> out;
  for (const auto& note : notes) {
    const Message message{note};
    out.push_back(tuple_of(visible_text(message.text), message.options));
  }
  return object_of(out);
}

void bind_records(PyObject* module);
void bind_frfs(PyObject* module);
void bind_outcome(PyObject* module);  // the results of commands
/// Modal assurance criterion of shapes (modes, places).
Object mac_between(PyObject* module, const Arguments& arguments);
/// The points of two documents at common places, as [(point of the first, point of the second, sign)].
Object common_points_of(PyObject* module, const Arguments& arguments);
/// The shape over the points (points,), ascending, from a table (residues, 5) of point, channel, real part, imaginary
/// part and standard deviation. All channels contribute to the value of a point, as in a survey with a roving hammer.
Object shape_over_points(PyObject* module, const Arguments& arguments);
/// The run time of the library without Python, for bench_overhead.py.
Object library_seconds(PyObject* module, const Arguments& arguments);

}  // namespace percuss::python
