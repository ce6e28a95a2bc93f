#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "objects.hpp"

namespace percuss::python {

/// Memory that a NumPy array shows, through the protocol `__array_interface__`.
struct ArrayMemory {
  const void* first = nullptr;
  std::vector<std::size_t> shape;
  const char* type = "";  // as NumPy writes it: "<f8"
  std::shared_ptr<const void> owner{};
};

void add_memory_class(PyObject* module);

/// A read-only array of the memory, which it keeps alive.
Object array_of(ArrayMemory memory);

template <class Value>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<Value, double>) return "<f8";
  if constexpr (std::is_same_v<Value, std::complex<double>>) return "<c16";
  if constexpr (std::is_same_v<Value, std::int64_t>) return "<i8";
}

/// A read-only view of `values` that keeps `owner` alive.
template <class Value>
Object view_of(std::span<const Value> values, const std::shared_ptr<const void>& owner) {
  return array_of({.first = values.data(), .shape = {values.size()}, .type = type_name<Value>(), .owner = owner});
}

/// A read-only array of the values; `shape` is (values,) unless given.
template <class Value>
Object array_of(std::vector<Value> values, std::vector<std::size_t> shape = {}) {
  if (shape.empty()) shape = {values.size()};
  auto kept = std::make_shared<const std::vector<Value>>(std::move(values));
  return array_of({.first = kept->data(), .shape = std::move(shape), .type = type_name<Value>(), .owner = kept});
}

/// An array of Python, of any shape: its numbers in place.
struct GivenArray {
  const std::byte* first = nullptr;
  std::vector<std::size_t> shape;
  std::vector<std::ptrdiff_t> strides_bytes;  // empty: contiguous
  std::string type;                           // as NumPy writes it
};
GivenArray given_array(const Object& array);

/// The numbers of a contiguous array of the type, any shape, as a copy. Throws TypeError for another type.
template <class Value>
std::vector<Value> copied_values(const Object& array) {
  const GivenArray given = given_array(array);
  std::size_t count = 1;
  for (const std::size_t size : given.shape) count *= size;
  if (given.type != type_name<Value>() || !given.strides_bytes.empty())
    raise_builtin(PyExc_TypeError, "expected a contiguous array of " + std::string(type_name<Value>()));
  const auto* const first = reinterpret_cast<const Value*>(given.first);
  return count == 0 ? std::vector<Value>() : std::vector<Value>(first, first + count);
}

}  // namespace percuss::python
