#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace percuss::tools {

/// A progress line on standard error, if it is a terminal, from the first second on; erased at the end.
class Progress {
 public:
  Progress(std::string what, bool quiet);
  /// `text` returns the line for the elapsed seconds.
  Progress(std::function<std::string(double seconds)> text, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Erases the line. Call it before other output; repeated calls have no effect.
  void stop() const;

 private:
  void show();

  std::function<std::string(double seconds)> text_;
  mutable std::mutex mutex_;
  mutable std::condition_variable wake_;
  mutable bool done_ = false;
  mutable std::thread thread_;
};

}  // namespace percuss::tools
