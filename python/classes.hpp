#pragma once
#include <memory>
#include <new>
#include <vector>

#include "objects.hpp"

namespace percuss::python {

/// The positional arguments of a call.
class Arguments {
 public:
  explicit Arguments(PyObject* tuple) : tuple_(tuple) {}
  std::size_t size() const { return static_cast<std::size_t>(PyTuple_Size(tuple_)); }
  /// Throws TypeError for a missing argument.
  Object operator[](std::size_t index) const {
    if (index >= size()) raise_builtin(PyExc_TypeError, "too few arguments");
    return Object::borrowed(PyTuple_GetItem(tuple_, static_cast<Py_ssize_t>(index)));
  }

 private:
  PyObject* tuple_;
};

/// Sets the Python exception for the C++ exception that is being handled.
void set_python_exception();

/// A function as Python calls it. `Function` takes the object of a method, or the module, and the arguments.
template <auto Function>
PyObject* guarded(PyObject* self, PyObject* arguments) {
  try {
    Object result = Function(self, Arguments(arguments));
    return PyErr_Occurred() == nullptr ? result.release() : nullptr;  // an interrupt may come at the end
  } catch (...) {
    set_python_exception();
    return nullptr;
  }
}

template <auto Function>
PyMethodDef method(const char* name) {
  return {name, &guarded<Function>, METH_VARARGS, nullptr};
}

template <auto Function>
PyGetSetDef property(const char* name) {
  const getter get = [](PyObject* self, void*) -> PyObject* {
    try {
      return Function(self).release();
    } catch (...) {
      set_python_exception();
      return nullptr;
    }
  };
  return {name, get, nullptr, nullptr, nullptr};
}

/// The Python class of a C++ class. An instance holds a shared pointer.
template <class Held>
class Class {
 public:
  /// Adds the class to the module. `construct` makes instances from arguments; without it, only C++ makes them.
  static void add(PyObject* module, const char* qualified_name, std::vector<PyMethodDef> methods,
                  std::vector<PyGetSetDef> properties, newfunc construct = nullptr) {
    static std::vector<PyMethodDef> methods_of_class;
    static std::vector<PyGetSetDef> properties_of_class;
    methods_of_class = std::move(methods);
    properties_of_class = std::move(properties);
    methods_of_class.push_back({nullptr, nullptr, 0, nullptr});
    properties_of_class.push_back({nullptr, nullptr, nullptr, nullptr, nullptr});
    std::vector<PyType_Slot> slots{{Py_tp_dealloc, reinterpret_cast<void*>(&dealloc)},
                                   {Py_tp_methods, methods_of_class.data()},
                                   {Py_tp_getset, properties_of_class.data()},
                                   {Py_tp_new, reinterpret_cast<void*>(construct == nullptr ? &refuse : construct)},
                                   {0, nullptr}};
    PyType_Spec spec{qualified_name, sizeof(Instance), 0, Py_TPFLAGS_DEFAULT, slots.data()};
    type() = Object::owned(PyType_FromSpec(&spec)).release();  // lives as long as the process
    const std::string name = qualified_name;
    if (PyObject_SetAttrString(module, name.substr(name.rfind('.') + 1).c_str(), type()) != 0) throw PythonError();
  }

  static Object wrap(std::shared_ptr<Held> held) {
    auto* const made = type();
    Object object = Object::owned(PyType_GenericAlloc(reinterpret_cast<PyTypeObject*>(made), 0));
    new (&reinterpret_cast<Instance*>(object.get())->held) std::shared_ptr<Held>(std::move(held));
    return object;
  }

  static bool is(const Object& object) { return PyObject_IsInstance(object.get(), type()) == 1; }

  static const std::shared_ptr<Held>& of(PyObject* self) { return reinterpret_cast<Instance*>(self)->held; }

 private:
  struct Instance {
    PyObject_HEAD std::shared_ptr<Held> held;
  };

  static PyObject*& type() {
    static PyObject* made = nullptr;
    return made;
  }
  static void dealloc(PyObject* self) {
    PyTypeObject* const own = Py_TYPE(self);
    std::destroy_at(&reinterpret_cast<Instance*>(self)->held);
    reinterpret_cast<freefunc>(PyType_GetSlot(own, Py_tp_free))(self);
    Py_DECREF(own);
  }
  static PyObject* refuse(PyTypeObject* /*type*/, PyObject* /*arguments*/, PyObject* /*keywords*/) {
    PyErr_SetString(PyExc_TypeError, "only the module makes this object");
    return nullptr;
  }
};

}  // namespace percuss::python
