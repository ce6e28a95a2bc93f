#pragma once
#include "metrics/protocol/certify.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/certify/1 (docs/schema/certify.schema.json); what to do next, the locations, the shots that do not count and
/// why, the balls that are spent; the shots as a table; performance over the location with the limit.
CommandReport certify_report(const metrics::Session& session, const metrics::Certification& certification);

}  // namespace percuss::report
