#include "objects.hpp"

namespace percuss::python {

Object Object::owned(PyObject* made) {
  if (made == nullptr) throw PythonError();
  Object out;
  out.object_ = made;
  return out;
}

Object Object::borrowed(PyObject* object) {
  Py_XINCREF(object);
  return owned(object);
}

Object Object::attribute(const char* name) const { return owned(PyObject_GetAttrString(object_, name)); }

std::vector<Object> Object::items() const {
  const Object list = owned(PySequence_List(object_));
  std::vector<Object> out;
  const Py_ssize_t count = PyList_Size(list.get());
  out.reserve(static_cast<std::size_t>(count));
  for (Py_ssize_t i = 0; i < count; ++i) out.push_back(borrowed(PyList_GetItem(list.get(), i)));
  return out;
}

Object Object::at(std::size_t index) const {
  return owned(PySequence_GetItem(object_, static_cast<Py_ssize_t>(index)));
}

std::string Object::text() const {
  const Object utf8 = owned(PyUnicode_AsUTF8String(object_));
  return utf8.bytes();
}

std::string Object::bytes() const {
  char* first = nullptr;
  Py_ssize_t size = 0;
  if (PyBytes_AsStringAndSize(object_, &first, &size) != 0) throw PythonError();
  return {first, static_cast<std::size_t>(size)};
}

double Object::number() const {
  const double value = PyFloat_AsDouble(object_);
  if (value == -1 && PyErr_Occurred() != nullptr) throw PythonError();
  return value;
}

std::int64_t Object::whole() const {
  const long long value = PyLong_AsLongLong(object_);
  if (value == -1 && PyErr_Occurred() != nullptr) throw PythonError();
  return value;
}

bool Object::truth() const {
  const int value = PyObject_IsTrue(object_);
  if (value < 0) throw PythonError();
  return value != 0;
}

Object imported(const char* module) { return Object::owned(PyImport_ImportModule(module)); }

void raise_builtin(PyObject* type, const std::string& message) {
  PyErr_SetString(type, message.c_str());
  throw PythonError();
}

Object decoded(std::string_view text) {
  return Object::owned(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

Object object_of(bool value) { return Object::borrowed(value ? Py_True : Py_False); }
Object object_of(double value) { return Object::owned(PyFloat_FromDouble(value)); }
Object object_of(std::complex<double> value) {
  return Object::owned(PyComplex_FromDoubles(value.real(), value.imag()));
}

}  // namespace percuss::python
