#pragma once
#include <string>

#include "pipeline/impact_test.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// percuss/deflection/1: peaks per hit and channel, means per point, impact speeds, warnings.
std::string deflection_json(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// The same for people, and without the name of the file.
ReportText deflection_text(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);
ReportText deflection_tables(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// Every sample: hit, channel, time from the row's beginning, velocity, deflection and its deviation (empty where the
/// method knows none).
std::string deflection_csv(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// /deflection_m, /velocity_mps, /deflection_std_m [hits, channels, samples], filled up with NaN; /hit, /point [hits],
/// /start_s [hits]; attribute fs. Whole or absent.
void write_deflection_hdf5(const std::string& path, const pipeline::Analysis& analysis,
                           const pipeline::ImpactTest& test, bool force);

/// Deflection over time of the hits with the largest peaks, a dozen at the most.
LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

}  // namespace percuss::report
