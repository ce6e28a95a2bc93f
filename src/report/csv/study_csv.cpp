#include "report/csv/study_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace percuss::report {

std::string study_csv(const metrics::Study& study, CsvFormulas formulas) {
  std::string out =
      "figure,source,length_in,bats,counted,pearson,pearson_low,pearson_high,spearman,spearman_low,spearman_high,p,"
      "slope,slope_low,slope_high,outliers\n";
  for (const metrics::StudyFigure& figure : study.figures) {
    for (const metrics::StudyClass& one : figure.classes) {
      out += fmt::format("{},{},{},{}", figure.name, figure.source,
                         one.length_class == 0 ? "all" : std::to_string(one.length_class), one.bats.size());
      if (const auto& a = one.association) {
        out += fmt::format(",{},{},{},{},{},{},{},{}", a->points, a->pearson.value, a->pearson.low, a->pearson.high,
                           a->spearman.value, a->spearman.low, a->spearman.high, a->p);
      } else {
        out += ",,,,,,,,";
      }
      const auto bound = [](double slope) { return std::isfinite(slope) ? fmt::format("{}", slope) : ""; };
      out += one.trend ? fmt::format(",{},{},{},", one.trend->slope, bound(one.trend->slope_low),
                                     bound(one.trend->slope_high))
                       : ",,,,";
      std::string names;
      for (const std::size_t b : one.outliers) names += (names.empty() ? "" : " ") + study.bats[b].id;
      out += csv_cell(names, formulas) + "\n";
    }
  }
  return out;
}

std::string study_groups_csv(const metrics::Study& study, CsvFormulas formulas) {
  std::string out = "material,kind,program,bats,quantity,states,mean,std,low,high\n";
  for (const metrics::StudyGroup& g : study.groups) {
    for (const metrics::QuantitySummary& q : g.quantities) {
      out += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", name_of(g.material), g.kind, csv_cell(g.program, formulas),
                         g.bats, metrics::column_of(q.quantity), q.states, q.mean,
                         q.states > 1 ? fmt::format("{}", q.std) : "", q.low, q.high);
    }
  }
  return out;
}

}  // namespace percuss::report
