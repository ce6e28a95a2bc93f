#include "report/text/warnings_text.hpp"

namespace percuss::report {

ReportText warnings_text(const std::vector<pipeline::Warning>& warnings) {
  ReportText text;
  for (const pipeline::Warning& warning : warnings) text.warn({warning.message, warning.options});
  return text;
}

}  // namespace percuss::report
