#pragma once
#include <string>
#include <utility>
#include <vector>

namespace percuss::report {

/// A node of a bending mode.
struct BendingNode {
  double z_m = 0, std_m = 0;
  std::string text;  // "6.311 ± 0.020 in, 160.30 ± 0.51 mm"
};

/// One bending mode along a bat: deflection y at z_m, 1 at its largest.
struct BendingShape {
  std::string name;
  double freq_Hz = 0;
  std::vector<double> z_m, y;
  std::vector<BendingNode> nodes;
};

/// Bending modes that a page animates.
struct BendingPlot {
  std::vector<std::pair<double, double>> outline_m;  // position and radius; empty: not known
  std::vector<BendingShape> modes;
  std::string ends;         // caption of the ends: "Left: the knob."
  bool from_right = false;  // z is measured from the right end
};

/// The data of src/report/html/page/bending.js, as JSON in ASCII: {"bending": {outline, modes: [{name, hz, z_m, y,
/// nodes}], ends, from_right}}.
std::string bending_plot_json(const BendingPlot& plot);

/// `value_m ± std_m` in inches and in millimetres; without the ± where std_m is 0.
std::string inches_and_mm(double value_m, double std_m);

}  // namespace percuss::report
