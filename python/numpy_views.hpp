#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace percuss::python {

/// Makes the array read-only.
inline pybind11::array read_only(pybind11::array array) {
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// A read-only view of `values` that keeps `owner` alive.
template <class Value, class Owner>
pybind11::array view_of(std::span<const Value> values, std::shared_ptr<Owner> owner) {
  auto kept = std::make_unique<std::shared_ptr<Owner>>(std::move(owner));
  const pybind11::capsule base(kept.get(), [](void* held) { delete static_cast<std::shared_ptr<Owner>*>(held); });
  static_cast<void>(kept.release());  // owned by the capsule
  return read_only(pybind11::array_t<Value>(static_cast<pybind11::ssize_t>(values.size()), values.data(), base));
}

/// A read-only copy of `values`.
template <class Value>
pybind11::array copy_of(std::span<const Value> values) {
  return read_only(pybind11::array_t<Value>(static_cast<pybind11::ssize_t>(values.size()), values.data()));
}

}  // namespace percuss::python
