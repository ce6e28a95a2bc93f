#pragma once
#include <optional>
#include <vector>

namespace percuss::metrics {

struct Session;
struct SessionShot;

/// All metrics of one location: means over its counted shots, with the correction of the ball lot.
struct LocationMetrics {
  double besr = 0, ncaa_besr = 0;                   // (P6), (P7)
  std::optional<double> bbcor, swing_mph, bbs_mph;  // (P9), (P4), (P8); none without the bat's moment of inertia
};

/// The metrics of shots at the location z_in. The swing speed follows from the swing model (P4).
LocationMetrics location_metrics(const Session& session, double z_in, const std::vector<const SessionShot*>& shots,
                                 double correction);

}  // namespace percuss::metrics
