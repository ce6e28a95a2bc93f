#include "page_sections.hpp"

#include <fmt/format.h>

#include "tables.hpp"

namespace percuss::accuracy {
namespace {

constexpr double kEven = 1.2;  // exponent of what grows in proportion, or nearly

}  // namespace

std::string scaling_section(const std::vector<Scaling>& scalings) {
  std::string stopped, lost, even, steep;
  for (const Scaling& scaling : scalings) {
    if (scaling.points.empty()) continue;
    std::string& list = scaling.time_exponent <= kEven ? even : steep;
    list += (list.empty() ? "" : ", ") + scaling.of;
    const ScalePoint& last = scaling.points.back();
    if (last.n < static_cast<double>(scaling.asked)) {
      stopped +=
          fmt::format("\n- {}: up to {:.0f} of {} in the time that was allowed", scaling.of, last.n, scaling.asked);
    }
    for (const ScalePoint& point : scaling.points) {
      if (point.modes == point.modes_sought) continue;
      lost += fmt::format("\n- {} = {:.0f}: {} found of {}", scaling.of, point.n, point.modes, point.modes_sought);
    }
  }
  return fmt::format(R"(
## Growth

A whole analysis (files to named modes, `best`, one thread) while one thing grows. Memory is what the process grows by, in a process of its own. Exponents are the slopes of the upper half of
each line in the chart: 1 is in proportion.

{}
![time and memory over size](accuracy-scaling.svg)

- In proportion, or nearly (exponent of time up to 1.2): {}.
- Faster than that: {}. Where many modes are fitted together (`best`), every mode is fitted with all others. Many channels have many lines to fit. Rows of 2^17 samples and more
  are cut where their decay has ended, as continuous records are.
- Memory grows in proportion to what is held at a time, or slower.
{}{}
)",
                     scaling_table(scalings), even.empty() ? "nothing" : even, steep.empty() ? "nothing" : steep,
                     stopped.empty() ? "" : "\nNot measured to the end:\n" + stopped + "\n",
                     lost.empty() ? "" : "\nNot all modes were found at\n" + lost + "\n");
}

std::string skipped_work_section(const std::vector<Saving>& savings) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(savings.size());
  for (const Saving& saving : savings) {
    rows.push_back({saving.what, saving.when, shown_figure(saving.with_s * 1e3), shown_figure(saving.without_s * 1e3),
                    shown_figure(saving.factor())});
  }
  return fmt::format(R"(
## What is left out

From a file to a result, with and without what nobody asked for or what tells nothing (ten hits of one second at 25.6 kHz, or the same within a minute; one thread). `--explain` says of any
analysis what was left out and why.

{}
)",
                     markdown_table({"left out", "when", "with, ms", "without, ms", "times faster"}, rows));
}

}  // namespace percuss::accuracy
