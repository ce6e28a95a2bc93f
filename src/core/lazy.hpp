#pragma once
#include <cassert>
#include <optional>
#include <stdexcept>
#include <utility>

namespace percuss::inline core {

/// One result, computed when first asked for and kept.
///   double fs() const { return fs_.get([&] { return costly(); }); }
/// A computation that throws leaves the slot empty, so that asking again tries again; one that asks for its own slot
/// throws std::logic_error. A slot is not locked: demand it before tasks that share it start, or from one task only.
template <class T>
class Lazy {
 public:
  template <class Compute>
  const T& get(Compute&& compute) const {
    if (value_) return *value_;
    if (running_) throw std::logic_error("a stage demands its own result");
    running_ = true;
    try {
      value_.emplace(std::forward<Compute>(compute)());
    } catch (...) {
      running_ = false;
      throw;
    }
    running_ = false;
    return *value_;
  }
  bool ready() const { return value_.has_value(); }

 private:
  mutable std::optional<T> value_;
  mutable bool running_ = false;
};

}  // namespace percuss::inline core
