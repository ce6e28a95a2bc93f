#pragma once
#include <string>
#include <vector>

namespace percuss::accuracy {

/// The half width, in standard deviations, of the interval that holds 95 % of a normal distribution.
inline constexpr double kInterval = 1.959964;

/// The error and the time of one method in one case.
struct Figure {
  std::string method;
  std::string label;              // label of the figure's point in the chart
  double error = 0;               // RMS, in the unit of TaskFigures::error
  double over_bound = 0;          // RMS of error/bound; 0: there is no bound
  double time_ratio = 0;          // multiple of the baseline in the same run
  std::vector<std::string> more;  // cells under TaskFigures::more
  bool on_pareto_front = false;   // no other figure of the case dominates it
};

/// One set of records, or one model, with the figures of all methods.
struct Case {
  std::string value;  // of the swept quantity: "0.5 s"
  std::vector<Figure> figures;
};

struct Sweep {
  std::string over;  // "record length"
  std::vector<Case> cases;
};

/// All figures of one task of percuss: FRFs, modes, deflections or impacts.
struct TaskFigures {
  std::string name;               // in the file name of its chart: accuracy-NAME.svg
  std::string title;              // of its charts
  std::string error;              // name of `error`, with its unit
  std::string time;               // baseline of `time_ratio`
  std::vector<std::string> more;  // headings of further columns
  std::vector<Sweep> sweeps;
};

/// Sets on_pareto_front. A figure dominates another when it is no worse in error and in time, and better in one of
/// them. Times within a tenth and errors within a hundredth count as equal.
void mark_pareto_front(std::vector<Figure>& figures);

/// The case of a sweep by its names. Precondition: it exists.
const Case& case_of(const TaskFigures& task, const std::string& over, const std::string& value);

/// The figure of a method. Precondition: it exists.
const Figure& figure_of(const Case& one, const std::string& method);

/// A figure as text: three significant digits, or "–" where there is none (0, NaN or infinite).
std::string shown_figure(double value);

}  // namespace percuss::accuracy
