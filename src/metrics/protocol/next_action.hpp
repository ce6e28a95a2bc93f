#pragma once
#include "metrics/protocol/certify.hpp"

namespace percuss::metrics {

/// The speed of the ball at which a location is tested. (P5)
double contact_mph(const Session& s, double z_in);

/// Whether damage was seen after a shot.
bool damaged(const Certification& c);

/// The next action of the laboratory. Precondition: all fields of `c` except `next` are set.
NextAction next_action(const Session& s, const Certification& c, const ProtocolLimits& limits);

}  // namespace percuss::metrics
