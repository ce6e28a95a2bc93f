#include "acquire/live/session_journal.hpp"

#include <system_error>
#include <utility>

namespace percuss::acquire {
namespace {

using namespace std::chrono_literals;

constexpr auto kRetryAfter = 200ms;
constexpr auto kSyncEvery = 1s;
constexpr std::size_t kMaxWaiting_bytes = std::size_t{16} << 20U;  // tens of thousands of events

}  // namespace

SessionJournal::SessionJournal(JournalWriter writer)
    : writer_(std::move(writer)), syncing_([this] { sync_every_second(); }) {}

SessionJournal::~SessionJournal() {
  {
    const std::lock_guard guard(mutex_);
    closing_ = true;
  }
  wake_.notify_all();
  syncing_.join();
}

bool SessionJournal::accept(int error) {
  if (error == 0) {
    fault_.clear();
    return true;
  }
  fault_ = std::system_category().message(error);
  retry_ = Clock::now() + kRetryAfter;
  return false;
}

bool SessionJournal::flush_locked() {
  while (!waiting_.empty()) {
    if (!fault_.empty() && Clock::now() < retry_) return false;
    if (!accept(writer_.append(waiting_.front()).error)) return false;
    waiting_bytes_ -= waiting_.front().size();
    waiting_.pop_front();
  }
  return true;
}

void SessionJournal::append_text(std::string block) {
  const std::lock_guard guard(mutex_);
  if (flush_locked() && accept(writer_.append(block).error)) return;
  if (waiting_bytes_ + block.size() > kMaxWaiting_bytes) return;
  waiting_bytes_ += block.size();
  waiting_.push_back(std::move(block));
}

std::optional<std::uint64_t> SessionJournal::append_samples(const std::string& block) {
  const std::lock_guard guard(mutex_);
  if (!flush_locked() || (!fault_.empty() && Clock::now() < retry_)) return {};
  const auto [error, offset] = writer_.append(block);
  return accept(error) ? std::optional(offset) : std::nullopt;
}

bool SessionJournal::flush() {
  const std::lock_guard guard(mutex_);
  return flush_locked();
}

void SessionJournal::sync() {
  const int error = writer_.sync();
  const std::lock_guard guard(mutex_);
  if (error != 0) accept(error);
}

void SessionJournal::wait_for_retry() const {
  Clock::time_point retry;
  {
    const std::lock_guard guard(mutex_);
    if (fault_.empty()) return;
    retry = retry_;
  }
  std::this_thread::sleep_until(retry);
}

void SessionJournal::sync_every_second() {
  std::uint64_t synced_bytes = 0;
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kSyncEvery, [this] { return closing_; })) {
    lock.unlock();
    const std::uint64_t bytes = writer_.size_bytes();
    const int error = bytes != synced_bytes ? writer_.sync() : 0;
    lock.lock();
    if (error == 0) synced_bytes = bytes;
    if (error != 0) accept(error);
  }
}

std::string SessionJournal::fault() const {
  const std::lock_guard guard(mutex_);
  return fault_;
}

}  // namespace percuss::acquire
