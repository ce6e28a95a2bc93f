#pragma once
#include <cstddef>
#include <string>

namespace percuss::tools {

/// Names the first records with a problem on standard error, a line each, and counts the others.
class ProblemList {
 public:
  /// `what` happened: failed, is left open.
  explicit ProblemList(const char* what) : what_(what) {}
  void add(const std::string& id, const std::string& reason);
  /// Says how many of `total` records were not named.
  void finish(std::size_t total) const;
  std::size_t size() const { return size_; }

 private:
  const char* what_;
  std::size_t size_ = 0;
};

}  // namespace percuss::tools
