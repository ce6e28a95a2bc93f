#pragma once
#include <cstddef>
#include <optional>

namespace percuss::identify {

/// The plane of a pattern cos n(θ − plane): an antinode, modulo π/n.
struct PatternPlane {
  double plane_rad = 0;
  double std_rad = 0;
  int order = 0;  // n
};

/// The cause of two close peaks. Asymmetry splits a mode into two at planes 90°/n apart. Two resonances in the same
/// plane come from a coupled part instead (a tuned absorber, a loose part).
enum class SplitCause { asymmetry, coupled, unclear };
const char* name_of(SplitCause cause);

/// The plane of one member of a split mode, and its angle to the plane of the other member.
struct SplitPlanes {
  PatternPlane own;
  double between_rad = 0;  // angle between the two planes, 0 … π/2n
  double between_std_rad = 0;
  SplitCause cause = SplitCause::unclear;
};

/// A split mode as one of its two modes sees it.
struct SplitMode {
  std::size_t partner = 0;  // index of the other mode
  double separation_Hz = 0;
  bool first = false;  // this mode has the lower frequency of the two
  double separation_std_Hz = 0;
  double first_over_second_dB = 0;    // level difference of the peaks, over all FRFs
  bool quoted = false;                // its frequency stands for the pair, as in source [8]: the first, unless hidden
  std::optional<SplitPlanes> planes;  // where both planes are known
};

}  // namespace percuss::identify
