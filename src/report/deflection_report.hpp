#pragma once
#include <string>

#include "pipeline/impact_test.hpp"
#include "report/json/deflection_json.hpp"
#include "report/svg/deflection_chart.hpp"
#include "report/text/deflection_text.hpp"

namespace percuss::report {

/// One line per sample: hit, channel, time from the row's beginning, velocity, deflection, its standard deviation
/// (empty where the method has none), point, position (empty where not known).
std::string deflection_csv(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// /deflection_m, /velocity_mps, /deflection_std_m [hits, channels, samples], filled up with NaN; /hit, /point [hits],
/// /start_s [hits]; attribute fs. Written whole or not at all.
void write_deflection_hdf5(const std::string& path, const pipeline::Analysis& analysis,
                           const pipeline::ImpactTest& test, bool force);

}  // namespace percuss::report
