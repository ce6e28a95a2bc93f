#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "report/json/compare_json.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// The number of the document's first mode, for people. Modes of beams are numbered from 0, as in the tables of the
/// models; all others from 1.
std::size_t first_mode_number(const metrics::ComparedDocument& document);
/// The stated family and order of a mode: "bending 3"; with a letter where the document has several of this order, the
/// lowest first: "bending 3a". "" without a family.
std::string compared_mode_name(const metrics::ComparedDocument& document, std::size_t m);
/// The partner of a mode of the first document, or nullptr.
const metrics::ModePair* pair_at(const Comparison& comparison, std::size_t mode);

inline constexpr double kMinPercentShown = 0.1;  // smaller differences are shown in ppm

/// A row for each mode of the first document, with its partners in the others; whether they are paired by order or by
/// frequency, and which of them may be exchanged; the modes without a partner; the damping ratios; what σ does not
/// hold, where differences are stated in it. `comparisons`: of each document after the first.
ReportText compare_modes_text(const std::vector<metrics::ComparedDocument>& documents,
                              const std::vector<Comparison>& comparisons);
/// A row for each place at which both documents state a deflection.
ReportText compare_deflections_text(const Comparison& comparison);

}  // namespace percuss::report
