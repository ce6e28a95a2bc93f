#pragma once
#include "metrics/protocol/certify.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/certify/1 (docs/schema/certify.schema.json). Text: the next step, the locations, the invalid shots
/// with their reasons, the balls to remove. Table: the shots. Chart: performance over the location, with the limit.
CommandReport certify_report(const metrics::Session& session, const metrics::Certification& certification);

}  // namespace percuss::report
