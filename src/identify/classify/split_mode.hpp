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

/// What makes two close peaks: asymmetry turns the two by 90°/n against each other; two resonances in the same plane
/// are no split ring mode, but something coupled to it (a tuned absorber, a loose part).
enum class SplitCause { asymmetry, coupled, unclear };
const char* name_of(SplitCause cause);

/// The planes of the two members of a double peak.
struct SplitPlanes {
  PatternPlane own;
  double between_rad = 0;  // of both, 0 … π/2n
  double between_std_rad = 0;
  SplitCause cause = SplitCause::unclear;
};

/// Two peaks so close that they count as one split mode, as one of them sees it.
struct SplitMode {
  std::size_t partner = 0;  // index of the other mode
  double separation_Hz = 0;
  bool first = false;  // the lower one
  double separation_std_Hz = 0;
  double first_over_second_dB = 0;    // height of the peaks, over all FRFs
  bool quoted = false;                // this one's frequency is the one to quote
  std::optional<SplitPlanes> planes;  // where the planes of both are known
};

}  // namespace percuss::identify
