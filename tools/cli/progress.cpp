#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <utility>

#include "core/visible_text.hpp"

namespace percuss::tools {

Progress::Progress(std::string what, bool quiet)
    : Progress([what = std::move(what)](double seconds) { return fmt::format("{} … {:.0f} s", what, seconds); },
               quiet) {}

Progress::Progress(std::function<std::string(double seconds)> text, bool quiet) : text_(std::move(text)) {
  if (!quiet && isatty(STDERR_FILENO) == 1) thread_ = std::thread([this] { show(); });
}

Progress::~Progress() { stop(); }

void Progress::stop() {
  if (!thread_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    done_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Progress::show() {
  const auto start = std::chrono::steady_clock::now();
  bool shown = false;
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::seconds(1), [&] { return done_; })) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    // std::cerr would write the control characters as escapes (VisibleOutput).
    fmt::print(stderr, "\r{}\033[K", visible_text(text_(seconds)));
    shown = true;
  }
  if (shown) fmt::print(stderr, "\r\033[K");
}

}  // namespace percuss::tools
