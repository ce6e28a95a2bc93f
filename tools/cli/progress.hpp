#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace percuss::tools {

/// Says on standard error, if it is a terminal, that work goes on, once it has taken longer than a second; wiped when
/// done.
class Progress {
 public:
  Progress(std::string what, bool quiet);
  /// With more to say than how long it has taken: `text` is called with the seconds that have passed.
  Progress(std::function<std::string(double seconds)> text, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line; before anything else is printed. Again does nothing.
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
