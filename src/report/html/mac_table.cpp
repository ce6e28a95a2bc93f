#include "report/html/mac_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

std::string mac_cell(const std::optional<double>& mac) {
  constexpr double kSteps = 5;
  if (!mac) return "<td class=\"right\">–</td>";
  const double shade = std::clamp(std::floor(*mac * kSteps), 0.0, kSteps - 1);
  return fmt::format("<td class=\"right shade{:.0f}\">{:.2f}</td>", shade, *mac);
}

}  // namespace

std::string mac_table_html(const MacMatrix& matrix) {
  std::string out = "<table class=\"mac\">\n<caption>" + html_escape(matrix.caption) + "</caption>\n<tr><td></td>";
  for (const std::string& name : matrix.columns) out += "<th scope=\"col\">" + html_escape(name) + "</th>";
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    out += "</tr>\n<tr><th scope=\"row\">" + html_escape(matrix.rows[i]) + "</th>";
    for (const std::optional<double>& mac : matrix.values[i]) out += mac_cell(mac);
  }
  return out + "</tr>\n</table>\n";
}

}  // namespace percuss::report
