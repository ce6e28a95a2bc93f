#pragma once
// The stable interface of CPython 3.9: one compiled module runs in that version and in every later one.
#define PY_SSIZE_T_CLEAN
#define Py_LIMITED_API 0x03090000
#include <Python.h>

#include <atomic>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace percuss::python {

/// Says that a Python exception is set. The caller of the module sees that exception.
class PythonError : public std::exception {};

/// An owned reference to a Python object. Needs Python's lock, as all functions of this header.
class Object {
 public:
  Object() = default;
  /// Takes a new reference. Throws PythonError for a null pointer, with which Python reports an exception.
  static Object owned(PyObject* made);
  static Object borrowed(PyObject* object);
  static Object none() { return borrowed(Py_None); }
  Object(const Object& other) : object_(other.object_) { Py_XINCREF(object_); }
  Object(Object&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Object& operator=(Object other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Object() { Py_XDECREF(object_); }

  PyObject* get() const { return object_; }
  PyObject* release() { return std::exchange(object_, nullptr); }
  bool is_none() const { return object_ == Py_None; }
  Object attribute(const char* name) const;
  /// The items of a sequence.
  std::vector<Object> items() const;
  Object at(std::size_t index) const;  // of a sequence
  std::string text() const;            // of a str, in UTF-8
  std::string bytes() const;           // of a bytes object
  double number() const;
  std::int64_t whole() const;
  bool truth() const;

 private:
  PyObject* object_ = nullptr;
};

Object imported(const char* module);

/// Raises a Python exception of a built-in type, such as PyExc_TypeError.
[[noreturn]] void raise_builtin(PyObject* type, const std::string& message);

/// Text that need not be UTF-8, such as the name of a file.
Object decoded(std::string_view text);

Object object_of(bool value);
Object object_of(double value);
Object object_of(std::complex<double> value);
inline Object object_of(std::string_view text) { return decoded(text); }
inline Object object_of(const std::string& text) { return decoded(text); }
inline Object object_of(const char* text) { return decoded(text); }
inline Object object_of(Object object) { return object; }
template <class Whole>
requires(std::is_integral_v<Whole> && !std::is_same_v<Whole, bool>) Object object_of(Whole value) {
  return Object::owned(PyLong_FromLongLong(static_cast<long long>(value)));
}
template <class Value>
Object object_of(const std::optional<Value>& value) {
  return value ? object_of(*value) : Object::none();
}

/// A list of the values.
template <class Value>
Object object_of(const std::vector<Value>& values) {
  Object list = Object::owned(PyList_New(0));
  for (const Value& value : values) {
    if (PyList_Append(list.get(), object_of(value).get()) != 0) throw PythonError();
  }
  return list;
}

template <class... Values>
Object tuple_of(Values&&... values) {
  Object tuple = Object::owned(PyTuple_New(sizeof...(Values)));
  Py_ssize_t at = 0;
  const auto add = [&](Object item) {
    if (PyTuple_SetItem(tuple.get(), at++, item.release()) != 0) throw PythonError();
  };
  (add(object_of(std::forward<Values>(values))), ...);
  return tuple;
}

template <class... Values>
Object call(const Object& function, Values&&... values) {
  return Object::owned(PyObject_Call(function.get(), tuple_of(std::forward<Values>(values)...).get(), nullptr));
}

/// A dictionary with texts as keys.
class Dictionary {
 public:
  Dictionary() : dictionary_(Object::owned(PyDict_New())) {}
  template <class Value>
  void set(const char* key, const Value& value) {
    if (PyDict_SetItemString(dictionary_.get(), key, object_of(value).get()) != 0) throw PythonError();
  }
  operator Object() const { return dictionary_; }  // NOLINT(google-explicit-constructor): a dictionary is an object

 private:
  Object dictionary_;
};

/// Calls that have released Python's lock. While the interpreter ends, Python ends each thread that takes the lock.
/// Within C++ functions, this aborts the process. Therefore stop_calls() ends the calls of daemon threads first.
inline std::atomic<int> calls_without_lock{0};
inline std::atomic<bool> calls_must_stop{false};

/// During its lifetime, other threads may hold Python's lock.
class ReleasedLock {
 public:
  ReleasedLock() : thread_(begun()) {}
  ~ReleasedLock() {
    PyEval_RestoreThread(thread_);
    --calls_without_lock;
  }
  ReleasedLock(const ReleasedLock&) = delete;
  ReleasedLock& operator=(const ReleasedLock&) = delete;

 private:
  static PyThreadState* begun() {
    ++calls_without_lock;
    return PyEval_SaveThread();
  }
  PyThreadState* thread_;
};

}  // namespace percuss::python
