#include "pipeline/warnings/object_warnings.hpp"

#include <algorithm>

namespace percuss::pipeline {

std::vector<Warning> object_warnings(const std::vector<identify::ModeClassification>& classifications,
                                     const identify::ClassifyOptions& options) {
  if (!options.angles_assumed || classifications.empty()) return {};
  const bool tube = std::any_of(classifications.begin(), classifications.end(),
                                [](const auto& one) { return one.ratio.has_value(); });
  if (tube && options.object == identify::ObjectKind::tube) {
    return {with_remedy({"assumed_tube", "two accelerometers taken as 0° and 90° around the tube", {"angle"}},
                        "state their angles to confirm")};
  }
  if (tube) {
    return {with_remedy({"assumed_tube",
                         "two accelerometers taken as 0° and 90° on a tube: bending and hoop are wrong on another "
                         "object",
                         {"angle", "object"}},
                        "state the angles to confirm, or that it is another object")};
  }
  return {with_remedy({"not_a_tube",
                       "the ratios of the two accelerometers do not fit a tube with sensors at 0° and 90°: the modes "
                       "are numbered, not named as bending or hoop",
                       {"angle", "object"}},
                      "state that it is a tube, or its sensors' angles, if it is one")};
}

}  // namespace percuss::pipeline
