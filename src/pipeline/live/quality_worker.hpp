#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/live/session_quality.hpp"

namespace percuss::pipeline {

/// Computes the quality of a session in a thread of its own, so that no verdict waits for a fit. A newer request
/// replaces one that has not begun. A result states the number of its blows, so it is worth showing when newer blows
/// wait: blows that follow each other faster than the fits do not hide all results.
class QualityWorker {
 public:
  explicit QualityWorker(AnalysisOptions options);
  ~QualityWorker();
  QualityWorker(const QualityWorker&) = delete;
  QualityWorker& operator=(const QualityWorker&) = delete;

  /// The record is read by the other thread.
  void ask(acquire::Record record);
  /// Drops the waiting request, the result of the running fit and a result not yet taken: their blows no longer count.
  void discard();
  /// The newest result, once.
  std::optional<SessionQuality> take();

 private:
  void work();

  AnalysisOptions options_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<acquire::Record> asked_;
  std::optional<SessionQuality> done_;
  bool discarded_ = false;  // the blows of the running fit
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace percuss::pipeline
