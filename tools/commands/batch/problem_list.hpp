#pragma once
#include <cstddef>
#include <string>

namespace percuss::tools {

/// The pattern of the files that hold the rows in a folder of results: "results/part-*.jsonl".
std::string part_files(const std::string& folder);

/// The sentence on all failed records: "all of them, with their reasons, are the rows of FILE whose code is not 0".
std::string place_of_failed(const std::string& file);

/// Names the first records with a problem on standard error, a line each, and counts the others.
class ProblemList {
 public:
  /// `what` follows the id in each line: "failed" or "is left open".
  explicit ProblemList(const char* what) : what_(what) {}
  void add(const std::string& id, const std::string& reason);
  /// Says how many of `total` records were not named. `where`: the end of this line, see place_of_failed().
  void finish(std::size_t total, const std::string& where = "") const;
  std::size_t size() const { return size_; }

 private:
  const char* what_;
  std::size_t size_ = 0;
};

}  // namespace percuss::tools
