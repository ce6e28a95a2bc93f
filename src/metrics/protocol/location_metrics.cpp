#include "metrics/protocol/location_metrics.hpp"

#include "metrics/protocol/averages.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/protocol/session.hpp"

namespace percuss::metrics {

LocationMetrics location_metrics(const Session& session, double z_in, const std::vector<const SessionShot*>& shots,
                                 double correction) {
  const double length_m = session.bat.length_in * kInch_m, z_m = z_in * kInch_m;
  const double contact_mps = contact_speed_mps(length_m, z_m);
  std::vector<double> besr, ncaa_besr, bbcor;
  for (const SessionShot* shot : shots) {
    const double in_mps = shot->in_mph * kMilePerHour_mps, out_mps = shot->out_mph * kMilePerHour_mps;
    besr.push_back(besr_of(out_mps, in_mps) + correction);                         // (P6), (P11)
    ncaa_besr.push_back(ncaa_besr_of(out_mps, in_mps, contact_mps) + correction);  // (P7), (P11)
    if (!session.bat.moi_ozin2) continue;
    const double moi_kgm2 = *session.bat.moi_ozin2 * kOunceInch2_kgm2;
    bbcor.push_back(bbcor_of(besr.back(), ball_to_bat_inertia(1e-3 * shot->ball_g, length_m, z_m, moi_kgm2)));  // (P9)
  }
  LocationMetrics out{.besr = mean_of(besr), .ncaa_besr = mean_of(ncaa_besr)};
  if (bbcor.empty()) return out;
  const double swing_mps = swing_speed_mps(length_m, z_m, *session.bat.moi_ozin2 * kOunceInch2_kgm2);  // (P4)
  out.bbcor = mean_of(bbcor);
  out.swing_mph = swing_mps / kMilePerHour_mps;
  out.bbs_mph = batted_ball_speed_mps(out.besr, swing_mps) / kMilePerHour_mps;  // (P8)
  return out;
}

}  // namespace percuss::metrics
