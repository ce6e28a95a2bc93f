#pragma once
#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>

#include "core/lazy.hpp"
#include "percuss/budget.hpp"

namespace percuss {
inline namespace core {

/// Compares the time and memory of one analysis or model with its budget. The memory is the growth of the process while
/// analyses run. Several analyses at the same time share the sum of their memory budgets.
class BudgetMeter {
 public:
  /// `where` names the input in the error.
  BudgetMeter(const Budget& budget, std::string where, BudgetedWork work = BudgetedWork::analysis);
  ~BudgetMeter();
  BudgetMeter(const BudgetMeter&) = delete;
  BudgetMeter& operator=(const BudgetMeter&) = delete;

  const Budget& budget() const { return budget_; }
  /// errors  BudgetSpent, Interrupted
  void check();

 private:
  friend class BudgetScope;

  Budget budget_;
  std::string where_;
  BudgetedWork work_;
  double spent_s_ = 0;                    // in scopes that have ended
  std::atomic<double> began_s_{0};        // of the present scope
  std::atomic<double> next_memory_s_{0};  // when the memory is measured again
  // The flag of the latest InterruptScope in which a BudgetScope of this meter began, or in which this object was made.
  // nullptr: none.
  std::shared_ptr<std::atomic<bool>> interrupted_;
};

/// The meter that this thread checks; nullptr: none.
BudgetMeter* current_budget();

/// During its lifetime, this thread checks `meter`, as do the threads of the parallel loops that it starts.
class CheckedBudget {
 public:
  explicit CheckedBudget(BudgetMeter* meter);
  ~CheckedBudget();
  CheckedBudget(const CheckedBudget&) = delete;
  CheckedBudget& operator=(const CheckedBudget&) = delete;

 private:
  BudgetMeter* before_;
};

/// A CheckedBudget that also measures its time, unless it lies within another scope of the same meter.
class BudgetScope {
 public:
  explicit BudgetScope(BudgetMeter& meter);
  ~BudgetScope();
  BudgetScope(const BudgetScope&) = delete;
  BudgetScope& operator=(const BudgetScope&) = delete;

 private:
  BudgetMeter* measured_;  // nullptr within another scope
  CheckedBudget checked_;
};

/// slot.get(compute), within a scope of `meter`.
template <class T, class Compute>
const T& within_budget(BudgetMeter& meter, const Lazy<T>& slot, Compute&& compute) {
  return slot.get([&] {
    const BudgetScope scope(meter);
    return compute();
  });
}

/// A computation ended because its host asked for it. Not an InputError: nothing is wrong with the input.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// During its lifetime, computations of this thread call `poll` about every 20 ms. Where it returns true, this thread
/// and the threads of its parallel loops throw Interrupted. Results computed before stay valid.
class InterruptScope {
 public:
  using Poll = bool (*)();
  explicit InterruptScope(Poll poll);
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

 private:
  Poll before_;
  std::shared_ptr<std::atomic<bool>> flag_before_;
};

/// Long computations call this at least every few milliseconds; it takes about 30 ns. errors  BudgetSpent, Interrupted
void check_budget();

}  // namespace core
}  // namespace percuss
