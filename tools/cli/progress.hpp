#pragma once
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
  void stop();

 private:
  void show();

  std::function<std::string(double seconds)> text_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace percuss::tools
