#include "numpy_arrays.hpp"

#include "classes.hpp"

namespace percuss::python {
namespace {

using MemoryClass = Class<ArrayMemory>;

Object tuple_of_sizes(const std::vector<std::size_t>& sizes) {
  return Object::owned(PyList_AsTuple(object_of(sizes).get()));
}

Object interface_of(PyObject* self) {
  const ArrayMemory& memory = *MemoryClass::of(self);
  Dictionary out;
  out.set("shape", tuple_of_sizes(memory.shape));
  out.set("typestr", memory.type);
  out.set("data", tuple_of(Object::owned(PyLong_FromVoidPtr(const_cast<void*>(memory.first))), true));  // read-only
  out.set("version", 3);
  return out;
}

// numpy.asarray, which lives as long as the process. The module sets it when it is imported: a static initialiser could
// wait for another thread that waits for Python's lock.
Object* numpy_asarray = nullptr;

}  // namespace

void add_memory_class(PyObject* module) {
  numpy_asarray = new Object(imported("numpy").attribute("asarray"));
  MemoryClass::add(module, "percuss._percuss.ArrayMemory", {}, {property<&interface_of>("__array_interface__")});
}

Object array_of(ArrayMemory memory) {
  static const double nothing = 0;  // an array without elements has no address
  if (memory.first == nullptr) memory.first = &nothing;
  return call(*numpy_asarray, MemoryClass::wrap(std::make_shared<ArrayMemory>(std::move(memory))));
}

GivenArray given_array(const Object& array) {
  const Object interface = array.attribute("__array_interface__");
  const auto entry = [&](const char* key) { return Object::borrowed(PyDict_GetItemString(interface.get(), key)); };
  GivenArray out;
  const Object address = entry("data").at(0);
  out.first = static_cast<const std::byte*>(PyLong_AsVoidPtr(address.get()));
  for (const Object& size : entry("shape").items()) out.shape.push_back(static_cast<std::size_t>(size.whole()));
  const Object strides = entry("strides");
  if (!strides.is_none()) {
    for (const Object& stride : strides.items())
      out.strides_bytes.push_back(static_cast<std::ptrdiff_t>(stride.whole()));
  }
  out.type = entry("typestr").text();
  return out;
}

}  // namespace percuss::python
