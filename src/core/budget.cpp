#include "core/budget.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <utility>
#include <vector>

#include "core/sanitized.hpp"

namespace percuss {
inline namespace core {
namespace {

constexpr double kMinTime_s = 120 * kSlowness, kTimePerByte_s = 2e-6 * kSlowness;
constexpr std::uint64_t kMinMemory_bytes = std::uint64_t{2} << 30U, kMemoryPerByte = 16;
constexpr std::uint64_t kMaxMemory_bytes = std::uint64_t{1} << 48U;  // a larger budget means no limit
constexpr double kMemoryInterval_s = 0.01;                           // one measurement takes about 2 µs
constexpr double kPollInterval_s = 0.02;                             // a person does not feel the delay

thread_local BudgetMeter* meter_of_thread = nullptr;
thread_local InterruptScope::Poll poll_of_thread = nullptr;
thread_local double next_poll_s = 0;
thread_local std::shared_ptr<std::atomic<bool>> flag_of_thread;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Without the pages of files, which the kernel can drop. 0 where /proc is absent: then memory has no budget.
std::uint64_t process_memory_bytes() {
  const int statm = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (statm < 0) return 0;
  std::array<char, 128> text{};
  const ssize_t size = ::read(statm, text.data(), text.size() - 1);
  ::close(statm);
  unsigned long long total = 0, resident = 0, shared = 0;
  if (size <= 0 || std::sscanf(text.data(), "%llu %llu %llu", &total, &resident, &shared) != 3) return 0;  // NOLINT
  return (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// The memory budgets of all analyses of the process. Allocations cannot be told apart by analysis.
class SharedMemory {
 public:
  void add(const Budget& budget) {
    const std::lock_guard lock(mutex_);
    if (meters_++ == 0) base_bytes_ = process_memory_bytes();
    is_unlimited(budget) ? ++unlimited_ : limit_bytes_ += budget.memory_bytes;
  }
  void remove(const Budget& budget) {
    const std::lock_guard lock(mutex_);
    --meters_;
    is_unlimited(budget) ? --unlimited_ : limit_bytes_ -= budget.memory_bytes;
  }
  bool spent() {
    const std::lock_guard lock(mutex_);
    return unlimited_ == 0 && process_memory_bytes() > base_bytes_ + limit_bytes_;
  }

 private:
  static bool is_unlimited(const Budget& budget) { return budget.memory_bytes > kMaxMemory_bytes; }

  std::mutex mutex_;
  std::uint64_t base_bytes_ = 0;  // before the first analysis began
  std::uint64_t limit_bytes_ = 0;
  std::size_t meters_ = 0, unlimited_ = 0;
};

SharedMemory& shared_memory() {
  static SharedMemory memory;
  return memory;
}

std::string problem_of(Resource resource, const Budget& budget, BudgetedWork work) {
  const char* name = work == BudgetedWork::analysis ? "analysis" : "model";
  return resource == Resource::time
             ? fmt::format("the {} is not finished after its budget of {:.4g} s", name, budget.time_s)
             : fmt::format("the {} needs more memory than its budget of {:.4g} GB", name,
                           static_cast<double>(budget.memory_bytes) / 1e9);
}

const char* remedy_of(BudgetedWork work) {
  return work == BudgetedWork::analysis ? "limit the band, choose a lower effort, or raise the budget"
                                        : "ask for fewer values, modes or steps, or raise the budget";
}

std::vector<OptionId> options_of(BudgetedWork work) {
  if (work == BudgetedWork::model) return {"budget"};
  return {"band", "effort", "budget"};
}

}  // namespace

BudgetMeter::BudgetMeter(const Budget& budget, std::string where, BudgetedWork work)
    : budget_(budget), where_(std::move(where)), work_(work), interrupted_(flag_of_thread) {
  shared_memory().add(budget_);
}

BudgetMeter::~BudgetMeter() { shared_memory().remove(budget_); }

void BudgetMeter::check() {
  if (interrupted_ && *interrupted_) throw Interrupted();
  const double now = now_s();
  if (poll_of_thread != nullptr && now >= next_poll_s) {
    next_poll_s = now + kPollInterval_s;
    if (poll_of_thread()) {
      *flag_of_thread = true;
      throw Interrupted();
    }
  }
  if (spent_s_ + (now - began_s_) > budget_.time_s) throw BudgetSpent(Resource::time, budget_, where_, work_);
  double due = next_memory_s_;
  if (now < due || !next_memory_s_.compare_exchange_strong(due, now + kMemoryInterval_s)) return;
  if (shared_memory().spent()) throw BudgetSpent(Resource::memory, budget_, where_, work_);
}

BudgetMeter* current_budget() { return meter_of_thread; }

CheckedBudget::CheckedBudget(BudgetMeter* meter) : before_(std::exchange(meter_of_thread, meter)) {}
CheckedBudget::~CheckedBudget() { meter_of_thread = before_; }

BudgetScope::BudgetScope(BudgetMeter& meter)
    : measured_(meter_of_thread == &meter ? nullptr : &meter), checked_(&meter) {
  if (measured_ == nullptr) return;
  if (flag_of_thread) measured_->interrupted_ = flag_of_thread;
  measured_->began_s_ = now_s();
}

BudgetScope::~BudgetScope() {
  if (measured_ != nullptr) measured_->spent_s_ += now_s() - measured_->began_s_;
}

InterruptScope::InterruptScope(Poll poll)
    : before_(std::exchange(poll_of_thread, poll)),
      flag_before_(std::exchange(flag_of_thread, std::make_shared<std::atomic<bool>>(false))) {}

InterruptScope::~InterruptScope() {
  poll_of_thread = before_;
  flag_of_thread = std::move(flag_before_);
}

void check_budget() {
  if (meter_of_thread != nullptr) meter_of_thread->check();
}

}  // namespace core

Budget default_budget(std::uint64_t input_bytes) {
  return {.time_s = kMinTime_s + kTimePerByte_s * static_cast<double>(input_bytes),
          .memory_bytes = kMinMemory_bytes + kMemoryPerByte * std::min(input_bytes, kMaxMemory_bytes)};
}

BudgetSpent::BudgetSpent(Resource resource, const Budget& budget, const std::string& where, BudgetedWork work)
    : InputError(problem_of(resource, budget, work), where, remedy_of(work), options_of(work)), resource_(resource) {}

}  // namespace percuss
