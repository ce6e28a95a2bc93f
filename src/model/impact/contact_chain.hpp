#pragma once
#include <cstddef>

#include "model/impact/ball_on_beam.hpp"

namespace percuss::model {

/// The contacts of ball and beam from the first separation on.
struct ContactChain {
  double ball_mps = 0;           // after the last contact, in the ball's initial direction
  std::size_t contacts = 1;      // the first one included
  double last_separation_s = 0;  // from the first touch
  double energy_error = 0;       // largest |E/E₀ − 1| within one of these contacts
  bool complete = false;         // no further contact follows within kFollowUp_s
};

/// Follows the motion from `separated`, `contact_s` after the first touch, until the ball stays away for kFollowUp_s.
/// The ball has its original shape at each touch: a dent of a lossy contact counts as lost energy.
ContactChain contact_chain(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s,
                           BallOnBeamState separated, double contact_s);

}  // namespace percuss::model
