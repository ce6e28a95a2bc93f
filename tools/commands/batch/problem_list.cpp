#include "commands/batch/problem_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "batch/status.hpp"
#include "core/error.hpp"

namespace percuss::tools {

std::string part_files(const std::string& folder) { return (std::filesystem::path(folder) / "part-*.jsonl").string(); }

std::string place_of_failed(const std::string& file) {
  return fmt::format("all of them, with their reasons, are the rows of {} whose code is not 0", one_line(file));
}

void ProblemList::add(const std::string& id, const std::string& reason) {
  constexpr std::size_t kMaxReason_bytes = 1000;
  if (size_++ >= batch::kMaxNamed) return;
  std::cerr << fmt::format("percuss: {} {}: {}\n", one_line(id), what_, one_line(reason, kMaxReason_bytes));
}

void ProblemList::finish(std::size_t total, const std::string& where) const {
  const std::size_t named = std::min(size_, batch::kMaxNamed);
  if (total > named)
    std::cerr << fmt::format("percuss: and {} more{}\n", total - named, where.empty() ? "" : "; " + where);
}

}  // namespace percuss::tools
