#include "model/section/section_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace percuss::model {
namespace {

std::optional<double> between(const std::optional<double>& from, const std::optional<double>& to, double part) {
  if (!from || !to) return to;
  return std::lerp(*from, *to, part);
}

// Two stations of one table have the same layout: a constant is given in both of them or in none.
SectionStation between(const SectionStation& from, const SectionStation& to, double part) {
  SectionStation mixed{.at_m = std::lerp(from.at_m, to.at_m, part),
                       .width_m = std::lerp(from.width_m, to.width_m, part),
                       .layers = to.layers};
  for (std::size_t i = 0; i < mixed.layers.size(); ++i) {
    const SectionLayer &a = from.layers[i], &b = to.layers[i];
    if (std::isfinite(b.thickness_m)) mixed.layers[i].thickness_m = std::lerp(a.thickness_m, b.thickness_m, part);
    mixed.layers[i].density_kgpm3 = between(a.density_kgpm3, b.density_kgpm3, part);
    mixed.layers[i].young_Pa = between(a.young_Pa, b.young_Pa, part);
    mixed.layers[i].shear_Pa = between(a.shear_Pa, b.shear_Pa, part);
  }
  return mixed;
}

BeamSection section_of(const SectionStation& station, bool round, const Material& of_beam) {
  return round ? round_section(station.width_m, station.layers, of_beam)
               : rectangular_section(station.width_m, station.layers, of_beam);
}

}  // namespace

double SectionTable::longest_fraction() const {
  double longest_m = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) longest_m = std::max(longest_m, stations[i].at_m - start_m(i));
  return longest_m / length_m();
}

BeamSection section_at(const SectionTable& table, const Material& of_beam, std::size_t station, double x_m) {
  const SectionStation& end = table.stations[station];
  if (table.kind == ProfileKind::slices || station == 0) return section_of(end, table.round, of_beam);
  const SectionStation& start = table.stations[station - 1];
  return section_of(between(start, end, (x_m - start.at_m) / (end.at_m - start.at_m)), table.round, of_beam);
}

}  // namespace percuss::model
