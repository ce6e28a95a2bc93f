#include "report/response_summary.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/error.hpp"
#include "core/statistics.hpp"
#include "report/text_table.hpp"

namespace percuss {
namespace {

std::string direction(std::size_t with, std::size_t against) {
  if (with > 0 && against > 0) return fmt::format("with the push in {} hits, against it in {}", with, against);
  return with > 0 ? "with the push" : "against the push";
}

}  // namespace

std::string responses_text(const Analysis& analysis, std::size_t width) {
  std::string text;
  for (std::size_t c = 0; c < analysis.record().accel.size(); ++c) {
    std::vector<double> delay_s;
    std::size_t with = 0, against = 0;
    for (const AnalysedHit& hit : analysis.hits()) {
      if (!hit.accepted || hit.responses.size() <= c || !hit.responses[c].delay_s) continue;
      delay_s.push_back(*hit.responses[c].delay_s);
      ++(hit.responses[c].polarity * hit.hit.peak_N > 0 ? with : against);
    }
    if (delay_s.empty()) continue;
    text += fmt::format("{}{} first moves {}, {:.2f} ms after the force's onset", text.empty() ? "" : "; ",
                        one_line(analysis.record().accel[c].name, 40), direction(with, against), median(delay_s) * 1e3);
  }
  return text.empty() ? text : wrapped(text, width, 0) + "\n";
}

}  // namespace percuss
