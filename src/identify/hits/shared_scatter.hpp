#pragma once
#include <cstddef>
#include <vector>

namespace percuss::identify {

/// The frequency or the damping ratio of a mode in the hits of a test, relative to the mode's own value.
struct RelativeHitValues {
  std::vector<double> value, std;  // [hits that determine the value]
  double spread = 0;               // significant scatter beyond std; 0: none
  std::size_t window = 0;          // modes fitted in one window count as one: their scatter may have the same cause
};

/// The scatter that several modes of a test have in common.
struct SharedScatter {
  double spread = 0;                // relative; 0: none
  std::vector<double> probability;  // [modes] that the mode has it; empty if spread is 0
};
/// The scatter is shared if modes of at least two windows scatter significantly, and three quarters of the modes that
/// do so agree within a factor of two. The probability of the other modes follows from their own values. theory (4.33)
SharedScatter shared_scatter(const std::vector<RelativeHitValues>& modes);

/// The standard deviation of a mode's mean over `hits` hits from a shared scatter, of the units of `spread`.
/// std  [hits that determine the value]; with fewer than two, the mean has the weights of equal hits
double std_from_shared_scatter(const std::vector<double>& std, std::size_t hits, double spread, double probability);

}  // namespace percuss::identify
