#pragma once
#include <cstddef>
#include <vector>

#include "model/section/section.hpp"

namespace percuss::model {

/// What the rows of a table of sections mean.
enum class ProfileKind {
  slices,  // each section extends unchanged from the previous position to its own
  points   // sections at positions; dimensions and constants vary linearly between them
};

/// The section at one position along a beam.
struct SectionStation {
  double at_m = 0;
  double width_m = 0;  // outer diameter of a round section
  std::vector<SectionLayer> layers;
};

/// The sections along a beam, from its end x = 0 on. Before the first position the first section extends unchanged.
/// shapes  positions ascend, the last is the length; each station has the same number of layers.
struct SectionTable {
  ProfileKind kind = ProfileKind::slices;
  bool round = true;  // false: rectangular
  std::vector<SectionStation> stations;

  double length_m() const { return stations.back().at_m; }
  /// The start of the stretch that ends at a station.
  double start_m(std::size_t station) const { return station == 0 ? 0 : stations[station - 1].at_m; }
  /// The length of the longest stretch, as a fraction of the beam's length.
  double longest_fraction() const;
};

/// The section at x_m, in the stretch that ends at `station`.
BeamSection section_at(const SectionTable& table, const Material& of_beam, std::size_t station, double x_m);

}  // namespace percuss::model
