#include "core/parallel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/parallel/task_arena.hpp"

namespace percuss {
namespace {

using Task = std::function<void(std::size_t)>;

constexpr std::size_t kWorthWaking = 400'000;  // operations, about 0.1 ms: waking another thread takes a third of that
constexpr std::size_t kStrip = 512;

thread_local std::size_t allowed_threads = 0;
thread_local LoopWatch* loop_watch = nullptr;

std::atomic<void (*)()> greeting{nullptr};
thread_local bool greeted = false;

void greet() {
  greeted = true;
  if (const auto call = greeting.load()) call();
}

// oneTBB orders a task after what came before parallel_for, and what follows after the task. These say so once more, to
// a thread sanitizer, which does not see into the library.
std::atomic<std::size_t> begun{0}, ended{0};

struct AtEnd {  // also of a task that throws
  void (*say)();
  ~AtEnd() { say(); }
};

struct Watched {
  LoopWatch* watch;
  explicit Watched(LoopWatch* by) : watch(by) {
    if (watch != nullptr) watch->wanted();
  }
  ~Watched() {
    if (watch != nullptr) watch->free();
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;
};

void call_in_order(const void* task, std::size_t i) {
  begun.load(std::memory_order_acquire);
  if (!greeted) greet();
  const AtEnd end{[] { ended.fetch_add(1, std::memory_order_release); }};
  (*static_cast<const Task*>(task))(i);
}

}  // namespace

void parallel_for(std::size_t count, std::size_t threads, const Task& task) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  const Watched watched{loop_watch};
  begun.fetch_add(1, std::memory_order_release);
  const AtEnd end{[] { ended.load(std::memory_order_acquire); }};
  run_in_arena(count, threads, call_in_order, &task);
}

ThreadLimit::ThreadLimit(std::size_t threads) : before_(std::exchange(allowed_threads, threads)) {}
ThreadLimit::~ThreadLimit() { allowed_threads = before_; }
std::size_t ThreadLimit::here() { return allowed_threads; }

void greet_threads(void (*call)()) {
  greeted = true;
  greeting = call;
}

LoopWatch* watch_loops(LoopWatch* watch) { return std::exchange(loop_watch, watch); }

void share_out(std::size_t count, std::size_t operations, const Task& task) {
  const bool worth_it = count > 1 && operations > kWorthWaking / count;
  parallel_for(count, worth_it ? allowed_threads : 1, [limit = allowed_threads, &task](std::size_t i) {
    const ThreadLimit same(limit);  // for what the task shares out in its turn
    task(i);
  });
}

void share_out_strips(std::size_t size, std::size_t operations,
                      const std::function<void(std::size_t, std::size_t)>& task) {
  share_out((size + kStrip - 1) / kStrip, operations * kStrip, [&](std::size_t strip) {
    const std::size_t first = strip * kStrip;
    task(first, std::min(kStrip, size - first));
  });
}

}  // namespace percuss
