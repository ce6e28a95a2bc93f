#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percuss::accuracy {
namespace {

using Row = std::vector<std::string>;

std::string line_of(const Row& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

bool has_bound(const TaskFigures& task) {
  for (const Sweep& sweep : task.sweeps) {
    for (const Case& one : sweep.cases) {
      if (std::any_of(one.figures.begin(), one.figures.end(), [](const Figure& f) { return f.over_bound > 0; }))
        return true;
    }
  }
  return false;
}

Row heads_of(const TaskFigures& task) {
  Row heads{"method", task.error};
  if (has_bound(task)) heads.emplace_back("over the bound");
  heads.insert(heads.end(), task.more.begin(), task.more.end());
  heads.emplace_back("time, ×");
  heads.emplace_back("Pareto-optimal");
  return heads;
}

Row cells_of(const Figure& figure, bool bound) {
  Row cells{figure.label.empty() ? figure.method : figure.method + ", " + figure.label, shown_figure(figure.error)};
  if (bound) cells.push_back(shown_figure(figure.over_bound));
  cells.insert(cells.end(), figure.more.begin(), figure.more.end());
  cells.push_back(shown_figure(figure.time_ratio));
  cells.emplace_back(figure.on_pareto_front ? "yes" : "");
  return cells;
}

std::string collapsed(const std::string& summary, const std::string& table) {
  return fmt::format("<details>\n<summary>{}</summary>\n\n{}\n</details>\n", summary, table);
}

std::string megabytes(double bytes) { return bytes > 0 ? shown_figure(bytes / 1e6) : "–"; }

}  // namespace

std::string markdown_table(const Row& heads, const std::vector<Row>& rows) {
  std::string text = line_of(heads) + "|---|";
  for (std::size_t i = 1; i < heads.size(); ++i) text += "---:|";
  text += '\n';
  for (const Row& row : rows) text += line_of(row);
  return text;
}

std::string case_table(const TaskFigures& task, const Case& one) {
  std::vector<Row> rows;
  for (const Figure& figure : one.figures) rows.push_back(cells_of(figure, has_bound(task)));
  return markdown_table(heads_of(task), rows);
}

std::string all_figures(const TaskFigures& task) {
  Row heads = heads_of(task);
  heads.insert(heads.begin(), "case");
  std::vector<Row> rows;
  for (const Sweep& sweep : task.sweeps) {
    for (const Case& one : sweep.cases) {
      for (const Figure& figure : one.figures) {
        rows.push_back(cells_of(figure, has_bound(task)));
        rows.back().insert(rows.back().begin(), sweep.over + ": " + one.value);
      }
    }
  }
  return collapsed("All figures of " + task.title, markdown_table(heads, rows));
}

std::string scaling_table(const std::vector<Scaling>& scalings) {
  std::vector<Row> rows;
  for (const Scaling& scaling : scalings) {
    if (scaling.points.empty()) continue;
    const ScalePoint& last = scaling.points.back();
    const std::string range = fmt::format("{:.0f} to {:.0f}", scaling.points.front().n, last.n);
    rows.push_back({scaling.of, scaling.with, range, shown_figure(last.seconds), shown_figure(last.time_ratio),
                    fmt::format("{:.2f}", scaling.time_exponent), megabytes(last.peak_bytes),
                    fmt::format("{:.2f}", scaling.memory_exponent)});
  }
  return markdown_table({"growing", "fixed", "range", "largest time, s", "× baseline", "exponent of time",
                         "largest memory, MB", "exponent of memory"},
                        rows);
}

std::string all_scaling(const std::vector<Scaling>& scalings) {
  std::vector<Row> rows;
  for (const Scaling& scaling : scalings) {
    for (const ScalePoint& point : scaling.points) {
      rows.push_back({scaling.of, fmt::format("{:.0f}", point.n), shown_figure(1e3 * point.seconds),
                      shown_figure(point.time_ratio), megabytes(point.peak_bytes),
                      fmt::format("{} of {}", point.modes, point.modes_sought)});
    }
  }
  return collapsed("All figures of growth",
                   markdown_table({"growing", "n", "time, ms", "× baseline", "memory, MB", "modes found"}, rows));
}

}  // namespace percuss::accuracy
