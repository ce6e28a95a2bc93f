#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

struct HitsTable {
  TextTable shown;
  std::size_t left_out = 0;  // accepted hits without a row, because the table is full
};

/// Each hit with its force and its findings. Hits and modes count from 1 in every table of a text or page.
HitsTable hits_table(const pipeline::Analysis& analysis, const std::vector<pipeline::AnalysedHit>& hits);

/// Each mode with its standard deviations and, with `classes`, its type.
TextTable modes_table(const pipeline::Analysis& analysis, bool classes);

/// The line that stands in place of an empty table of modes.
const char* no_modes_text(const pipeline::Analysis& analysis);

/// The conditions of the test: "25.6 kHz · 5 hits × 2 accelerometers (0°, 90°) · band 60–3200 Hz"
std::string test_conditions(const pipeline::Analysis& analysis, std::size_t hits);

/// False for the peak of a split mode that is not quoted (SplitMode::quoted), true for every other peak.
bool is_quoted(const identify::ModeClassification& classification);

/// "hoop 1"; "bending" or "unknown" without an order.
std::string mode_type_of(const identify::ModeClassification& classification);
/// "could be hoop", "could be three waves (n = 3)"; empty where no other type is stated.
std::string other_types(const identify::ModeClassification& classification);
/// The confidence of a mode's type: "97 %", "99.6 %", "> 99.9 %"; "–" for an unknown type.
std::string confidence_text(const identify::ModeClassification& classification);
/// Names the parts of the frequency's or the damping ratio's standard deviation that exceed the noise, such as "± from
/// the misfit"; empty for none.
std::string source_of_std(const identify::Mode& mode);

/// "hoop 1"; for a mode without an order, "mode 3" for index 2: people count from 1.
std::string mode_name(const identify::ModeClassification& classification, std::size_t index);

/// The name of the first file, with "and 3 more".
std::string source_name(const acquire::Record& record);

}  // namespace percuss::report
