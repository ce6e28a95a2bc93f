#include "page_sections.hpp"

#include <fmt/format.h>

#include "tables.hpp"

namespace percuss::accuracy {
namespace {

constexpr double kProportional = 1.2;  // largest exponent of nearly proportional growth

}  // namespace

std::string scaling_section(const std::vector<Scaling>& scalings) {
  std::string stopped, lost, even, steep;
  for (const Scaling& scaling : scalings) {
    if (scaling.points.empty()) continue;
    std::string& list = scaling.time_exponent <= kProportional ? even : steep;
    list += (list.empty() ? "" : ", ") + scaling.of;
    const ScalePoint& last = scaling.points.back();
    if (last.n < static_cast<double>(scaling.asked)) {
      stopped += fmt::format("\n- {}: up to {:.0f} of {} in the time limit", scaling.of, last.n, scaling.asked);
    }
    for (const ScalePoint& point : scaling.points) {
      if (point.modes == point.modes_sought) continue;
      lost += fmt::format("\n- {} = {:.0f}: {} found of {}", scaling.of, point.n, point.modes, point.modes_sought);
    }
  }
  return fmt::format(R"(
## Growth

This section shows the time and the memory of a whole analysis (files to classified modes, `best`, one thread) while one
size grows. Each analysis runs in its own process; its memory is the growth of that process. An exponent is the slope of
the upper half of a line in the chart: 1 means proportional growth.

{}
![time and memory over size](accuracy-scaling.svg)

- Proportional or nearly so (exponent of time up to 1.2): {}.
- Steeper: {}. `best` fits every mode together with all others. Many channels have many lines to fit.
- Rows of 2^17 samples and more are cut at the end of their decay, like continuous records. Their time can be below the
  baseline, which transforms whole rows.
- Memory grows at most in proportion to the data held at a time.
{}{}
)",
                     scaling_table(scalings), even.empty() ? "nothing" : even, steep.empty() ? "nothing" : steep,
                     stopped.empty() ? "" : "\nMeasured up to the time limit:\n" + stopped + "\n",
                     lost.empty() ? "" : "\nMissing modes:\n" + lost + "\n");
}

std::string skipped_work_section(const std::vector<Saving>& savings) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(savings.size());
  for (const Saving& saving : savings) {
    rows.push_back({saving.what, saving.when, shown_figure(saving.with_s * 1e3), shown_figure(saving.without_s * 1e3),
                    shown_figure(saving.factor())});
  }
  return fmt::format(R"(
## Skipped work

The table shows processor times from a file to a result, with and without work that the result does not need. The test
has ten hits of one second at 25.6 kHz, or the same hits in one record of a minute; one thread. `--explain` lists the
skipped work of any analysis, with reasons.

{}
)",
                     markdown_table({"skipped", "condition", "with, ms", "without, ms", "speed-up"}, rows));
}

}  // namespace percuss::accuracy
