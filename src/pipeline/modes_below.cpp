// The modes below the analysed band. The orders of a tube's modes in the band continue from them.
#include <algorithm>

#include "pipeline/analysis.hpp"

namespace percuss::pipeline {
namespace {

// Of successive bending frequencies of a tube: at most 2.76 if it is free, 4 if it is pinned, and a margin. Only the
// second mode of a clamped tube lies higher, at up to 6.3 times the first.
constexpr double kMaxRatio = 4.5;
constexpr std::size_t kMinLines = 16;  // fewer lines hold no mode
constexpr std::size_t kMaxHits = 4;    // enough to count modes

// The same analysis of a few hits in another band.
AnalysisOptions lower_options(const AnalysisOptions& options, std::pair<double, double> band_Hz,
                              const std::vector<AnalysedHit>& hits) {
  AnalysisOptions lower = options;
  lower.band_Hz = band_Hz;
  lower.modes = {.effort = identify::Effort::quick};
  lower.accept_hits = accepted_hits(hits);
  lower.accept_hits.resize(std::min(lower.accept_hits.size(), kMaxHits));
  lower.reject_hits.clear();
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const auto& few = lower.accept_hits;
    if (std::find(few.begin(), few.end(), h) == few.end()) lower.reject_hits.push_back(h);
  }
  return lower;
}

}  // namespace

const std::vector<identify::Mode>& Analysis::modes_below() const {
  return within_budget(budget_, modes_below_, [&] {
    const std::vector<identify::Mode>& found = modes();
    if (found.empty() || !options_.band_Hz) return std::vector<identify::Mode>{};
    const double margin_begin_Hz = lines().freq_Hz(0);
    const double from_Hz =
        std::max(source_->default_band_Hz(force_hits()).first, found.front().pole.freq_Hz / kMaxRatio);
    if (given_frfs() != nullptr || (margin_begin_Hz - from_Hz) / lines().df_Hz() < kMinLines)
      return margin_modes_below();
    const Analysis lower(record(), lower_options(options_, {from_Hz, margin_begin_Hz}, hits()));
    std::vector<identify::Mode> below = lower.modes();
    const std::vector<identify::Mode> of_margin = margin_modes_below();
    below.insert(below.end(), of_margin.begin(), of_margin.end());
    return below;
  });
}

std::vector<identify::ModeClassification> Analysis::types_below() const {
  identify::ClassifyOptions classes = options_.classes;
  classes.object = identify::ObjectKind::tube;
  return classify_modes(modes_below(), fitted_frfs(), typing_accel(), classes);
}

identify::LowerTubeModes Analysis::modes_of_lower_orders() const {
  return identify::lower_tube_modes(modes_below(), types_below(), lower_orders(), options_.classes);
}

const identify::LowerOrders& Analysis::lower_orders() const {
  return within_budget(budget_, lower_orders_, [&] {
    const auto& found = types();
    const bool tube = std::any_of(found.begin(), found.end(), [](const auto& type) { return type.order > 0; });
    if (!tube || !options_.modes.start_Hz.empty()) return identify::LowerOrders{};
    const std::vector<identify::Mode>& below = modes_below();
    return trace_.run("lower orders",
                      [&] { return identify::lower_orders(below, types_below(), modes(), found, options_.classes); });
  });
}

}  // namespace percuss::pipeline
