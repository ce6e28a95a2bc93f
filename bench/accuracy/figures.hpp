#pragma once
#include <string>
#include <vector>

namespace percuss::accuracy {

/// One method in one case: what it missed the truth by, and what that took.
struct Figure {
  std::string method;
  std::string label;              // beside its point in the chart
  double error = 0;               // RMS, in the unit of the family
  double over_bound = 0;          // RMS of error/bound; 0: there is no bound
  double time_ratio = 0;          // over bare transforms and reading in the same run
  std::vector<std::string> more;  // cells under Family::more
  bool on_pareto_front = false;   // nothing else of the case beats it
};

/// One set of records, or one model, on which all methods were tried.
struct Case {
  std::string value;  // of what the sweep goes over: "0.5 s"
  std::vector<Figure> figures;
};

struct Sweep {
  std::string over;  // "record length"
  std::vector<Case> cases;
};

/// All that was tried of one task.
struct Family {
  std::string name;               // of its chart's file: accuracy-NAME.svg
  std::string title;              // of its charts
  std::string error;              // what `error` is, with its unit
  std::string time;               // what `time_ratio` is over
  std::vector<std::string> more;  // heads of further columns
  std::vector<Sweep> sweeps;
};

/// Sets on_pareto_front. One figure beats another when it is no worse in error and in time, and better in one of them;
/// times within a tenth and errors within a hundredth count as the same.
void mark_pareto_front(std::vector<Figure>& figures);

/// The case of a sweep by its names; it must be there.
const Case& case_of(const Family& family, const std::string& over, const std::string& value);

/// The figure of a method; it must be there.
const Figure& figure_of(const Case& one, const std::string& method);

/// A figure for people: three significant digits, "–" for what was not measured (0, NaN or infinite).
std::string shown_figure(double value);

}  // namespace percuss::accuracy
