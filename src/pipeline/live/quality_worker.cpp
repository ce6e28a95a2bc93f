#include "pipeline/live/quality_worker.hpp"

#include <exception>
#include <utility>

namespace percuss::pipeline {

QualityWorker::QualityWorker(AnalysisOptions options) : options_(std::move(options)), thread_([this] { work(); }) {}

QualityWorker::~QualityWorker() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void QualityWorker::ask(acquire::Record record) {
  {
    const std::lock_guard lock(mutex_);
    asked_ = std::move(record);
  }
  wake_.notify_one();
}

void QualityWorker::discard() {
  const std::lock_guard lock(mutex_);
  asked_.reset();
  done_.reset();
  discarded_ = true;
}

std::optional<SessionQuality> QualityWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, std::nullopt);
}

void QualityWorker::work() {
  std::unique_lock lock(mutex_);
  while (!closing_) {
    if (!asked_) {
      wake_.wait(lock);
      continue;
    }
    acquire::Record record = std::move(*asked_);
    asked_.reset();
    discarded_ = false;
    lock.unlock();
    std::optional<SessionQuality> quality;
    try {
      quality = session_quality(std::move(record), options_);
    } catch (const std::exception&) {  // no budget or memory: the next blow asks again
    }
    lock.lock();
    if (quality && !discarded_) done_ = std::move(quality);
  }
}

}  // namespace percuss::pipeline
