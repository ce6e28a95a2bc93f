#include "pipeline/analysis_options.hpp"

#include <cstdint>

namespace percuss::pipeline {

Budget budget_of(const AnalysisOptions& options, const acquire::Record& record) {
  if (options.budget) return *options.budget;
  std::uint64_t bytes = 0;
  for (const acquire::InputFile& file : record.files) bytes += file.bytes;
  return default_budget(bytes);
}

}  // namespace percuss::pipeline
