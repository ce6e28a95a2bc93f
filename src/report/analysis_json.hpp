#pragma once
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/analysis.hpp"

namespace percuss {

/// Parts of an analysis that a report can hold; naming them is the demand that computes them.
enum class Section { hits, frf, coherence, modes, classes };

/// The sections named in a list such as {"hits", "modes"}; UsageError names the known ones.
std::set<Section> parse_sections(const std::vector<std::string>& names);
std::set<Section> all_sections();

struct JsonOptions {
  std::set<Section> sections = all_sections();
  bool trace = false;
  bool per_hit = false;
};

/// The document percuss/analysis/1 with the sections asked for.
nlohmann::ordered_json analysis_json(const Analysis& analysis, const JsonOptions& options = {});

/// {"schema", "version", "runs": […]} for several analyses, each with its run number.
nlohmann::ordered_json runs_json(const std::vector<std::pair<int, nlohmann::ordered_json>>& runs);

}  // namespace percuss
