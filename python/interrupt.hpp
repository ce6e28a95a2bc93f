#pragma once
#include "core/budget.hpp"
#include "objects.hpp"

namespace percuss::python {

/// During its lifetime, a signal to Python (Ctrl-C) stops the computations of this thread: Python's exception is set,
/// and they throw Interrupted. Only Python's main thread handles signals. For threads without Python's lock.
class InterruptPolling {
 public:
  InterruptPolling() : scope_(&poll) {}

 private:
  static bool poll() {
    const PyGILState_STATE lock = PyGILState_Ensure();
    bool raised = PyErr_CheckSignals() != 0;
    if (!raised && calls_must_stop) {
      PyErr_SetString(PyExc_KeyboardInterrupt, "the interpreter ends");
      raised = true;
    }
    PyGILState_Release(lock);
    return raised;
  }
  InterruptScope scope_;
};

}  // namespace percuss::python
