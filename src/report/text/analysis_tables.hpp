#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

struct HitsTable {
  TextTable shown;
  std::size_t left_out = 0;  // of hits in order, where there are very many
};

/// Every hit with its force and what was found out about it.
HitsTable hits_table(const pipeline::Analysis& analysis, const std::vector<pipeline::AnalysedHit>& hits);

/// Every mode with its deviations, and with `classes` its family.
TextTable modes_table(const pipeline::Analysis& analysis, bool classes);

/// What was measured how: "25.6 kHz · 5 hits × 2 accelerometers (0°, 90°) · band 60–3200 Hz"
std::string test_conditions(const pipeline::Analysis& analysis, std::size_t hits);

/// "hoop 1"; "bending" or "unknown" without an order.
std::string mode_type_of(const identify::ModeClassification& verdict);
/// "hoop 1", or by its number, "mode 3", where it has no order.
std::string mode_name(const identify::ModeClassification& verdict, std::size_t number);

/// The file it was read from, "and 3 more" with it.
std::string source_name(const pipeline::Analysis& analysis);

}  // namespace percuss::report
