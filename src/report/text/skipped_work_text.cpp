#include "report/text/skipped_work_text.hpp"

#include <fmt/format.h>

#include "pipeline/skipped_work.hpp"

namespace percuss {

ReportText skipped_text(const Analysis& analysis) {
  TextTable table({{"skipped", TextTable::Align::right}, {"what"}, {"because"}});
  for (const SkippedWork& one : skipped_work(analysis))
    table.add({one.share ? fmt::format("{:.1f} %", 100 * *one.share) : "all", one.what, one.why});
  ReportText text;
  text += table;
  return text;
}

}  // namespace percuss
