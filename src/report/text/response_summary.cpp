#include "report/text/response_summary.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

struct FirstMotion {
  std::size_t with = 0, against = 0, undecided = 0;  // hits
  std::vector<double> delay_s;
};

FirstMotion first_motion(const pipeline::Analysis& analysis, std::size_t channel) {
  FirstMotion out;
  for (const pipeline::AnalysedHit& hit : analysis.hits()) {
    if (!hit.accepted || hit.responses.size() <= channel || hit.responses[channel].dead) continue;
    const acquire::ResponseGrade& grade = hit.responses[channel];
    if (grade.polarity == 0) ++out.undecided;
    if (grade.polarity * hit.hit.peak_N > 0) ++out.with;
    if (grade.polarity * hit.hit.peak_N < 0) ++out.against;
    if (grade.delay_s) out.delay_s.push_back(*grade.delay_s);
  }
  return out;
}

// Points may differ in direction, which then tells nothing of a sensor. The hits of one point agree, because
// vote_first_motion() discards the first motion of an outvoted hit.
bool differs_between_points(const FirstMotion& motion) { return motion.with > 0 && motion.against > 0; }

}  // namespace

std::string responses_text(const pipeline::Analysis& analysis, std::size_t width) {
  std::string text;
  bool any_direction = false;
  for (std::size_t c = 0; c < analysis.record().accel.size(); ++c) {
    const FirstMotion motion = first_motion(analysis, c);
    if (differs_between_points(motion)) continue;
    const std::string name = (text.empty() ? "" : "; ") + one_line(analysis.record().accel[c].name, 40);
    if (!motion.delay_s.empty()) {
      any_direction = true;
      text += fmt::format("{} first moves {} the push, {:.2f} ms after the force's onset", name,
                          motion.with > 0 ? "with" : "against", median(motion.delay_s) * 1e3);
    } else if (motion.undecided > 0) {
      text += fmt::format("{}: the hits show no clear direction of its first motion", name);
    }
  }
  return any_direction ? wrapped(text, width, 0) + "\n" : "";
}

}  // namespace percuss::report
