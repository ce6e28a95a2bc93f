#include "report/text/skipped_work_text.hpp"

#include <fmt/format.h>

#include "pipeline/skipped_work.hpp"

namespace percuss::report {

ReportText skipped_text(const pipeline::Analysis& analysis) {
  TextTable table({{"skipped", TextTable::Align::right}, {"what"}, {"because"}});
  for (const pipeline::SkippedWork& one : pipeline::skipped_work(analysis))
    table.add({one.share ? fmt::format("{:.1f} %", 100 * *one.share) : "all", one.what, one.why});
  ReportText text;
  text += table;
  return text;
}

}  // namespace percuss::report
