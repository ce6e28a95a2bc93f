#pragma once
#include <cassert>
#include <optional>
#include <stdexcept>
#include <utility>

namespace percuss {
inline namespace core {

/// A result that is computed on first use and kept.
///   double fs() const { return fs_.get([&] { return costly(); }); }
/// A computation that throws leaves the slot empty, and the next call tries again. A computation that uses its own slot
/// throws std::logic_error. A slot has no lock: compute it before the tasks that share it start, or in one task only.
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

}  // namespace core
}  // namespace percuss
