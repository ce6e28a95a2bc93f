#include "core/parallel/background_tasks.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/parallel/parallel.hpp"
#include "core/parallel/task_arena.hpp"

namespace percuss::inline core {
namespace {

using Clock = std::chrono::steady_clock;

// Loops follow each other closely: a task begun between two of them would be in the way of the second.
constexpr auto kPause = std::chrono::microseconds(30);

// oneTBB orders a call after what came before it was asked for. This says so once more, to a thread sanitizer.
std::atomic<std::size_t> asked{0};

}  // namespace

// Kept by the calls as well, which may come when nobody is left who asked for them.
class BackgroundTasks::Work final : public LoopObserver, public std::enable_shared_from_this<Work> {
 public:
  Work(std::size_t count, std::function<void(std::size_t)> task)
      : count_(count),
        task_(std::move(task)),
        threads_(ThreadLimit::here()),
        others_(count == 0 || threads_ == 1 ? 0 : arena_concurrency(threads_) - 1) {}

  void loop_started() override {
    ++open_loops_;
    ++changes_;
  }
  void loop_finished() override {
    if (--open_loops_ > 0) return;
    while (next_ < count_ && calls_ < others_ && enqueue()) continue;
  }

  std::size_t claim_remaining() { return next_.exchange(count_); }
  void run(std::size_t i) {
    try {
      task_(i);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (failed_ && failed_at_ < i) return;
      failed_ = std::current_exception();
      failed_at_ = i;
    }
  }
  void wait() {
    ++changes_;
    while (busy_ > 0) std::this_thread::yield();
  }
  std::size_t count() const { return count_; }
  std::size_t threads() const { return threads_; }
  std::exception_ptr failed() const { return failed_; }

 private:
  using Held = std::shared_ptr<Work>;

  // False where memory is short: finish() does it all then.
  bool enqueue() noexcept {
    ++calls_;
    try {
      auto held = std::make_unique<Held>(shared_from_this());
      ++asked;
      enqueue_in_arena(threads_, run_enqueued, held.get());
      static_cast<void>(held.release());  // answer() has it now
      return true;
    } catch (...) {
      --calls_;
      return false;
    }
  }
  static void run_enqueued(void* with) {
    asked.load();
    const std::unique_ptr<Held> held(static_cast<Held*>(with));
    (*held)->run_while_idle();
  }

  void run_while_idle() {
    const ThreadLimit alone(1);
    ++busy_;
    const std::size_t before = changes_;
    const auto still_idle = [&] { return open_loops_ == 0 && changes_ == before; };
    const auto pause_end = Clock::now() + kPause;
    while (still_idle() && Clock::now() < pause_end) std::this_thread::yield();
    while (still_idle()) {
      const std::size_t i = next_++;
      if (i >= count_) break;
      run(i);
    }
    --calls_;
    --busy_;
  }

  const std::size_t count_;
  const std::function<void(std::size_t)> task_;
  const std::size_t threads_, others_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> open_loops_{0}, changes_{0};  // of the owner: loops that want threads, and when that changed
  std::atomic<std::size_t> calls_{0}, busy_{0};          // asked for and not done; begun and not done
  std::mutex mutex_;
  std::exception_ptr failed_;
  std::size_t failed_at_ = 0;
};

BackgroundTasks::BackgroundTasks(std::size_t count, std::function<void(std::size_t)> task)
    : work_(std::make_shared<Work>(count, std::move(task))), previous_observer_(set_loop_observer(work_.get())) {}

BackgroundTasks::~BackgroundTasks() {
  work_->claim_remaining();
  work_->wait();
  set_loop_observer(previous_observer_);
}

void BackgroundTasks::finish() {
  const std::size_t first = work_->claim_remaining();
  const std::size_t left = first < work_->count() ? work_->count() - first : 0;
  parallel_for(left, work_->threads(), [&](std::size_t i) { work_->run(first + i); });
  work_->wait();
  if (work_->failed()) std::rethrow_exception(work_->failed());
}

}  // namespace percuss::inline core
