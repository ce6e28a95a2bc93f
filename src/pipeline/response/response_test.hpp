#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/decay/decay_modes.hpp"
#include "pipeline/analysis_options.hpp"
#include "pipeline/response/response_impacts.hpp"
#include "pipeline/warnings/lost_sample_warnings.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

struct ResponseHit {
  ResponseImpact impact;  // first … end is the usable part of its decay (usable_decay.hpp)
  int point = 0;
  double onset_s = 0;  // from the row's beginning
  bool accepted = false, by_user = false;
  std::string reason;                 // why it is rejected
  double clipped_s = 0;               // from the onset to the last clipped sample; the decay is fitted after it
  bool gated = false;                 // the recorder cut the decay off
  std::optional<LostSamples> lost{};  // in its decay; if not predicted, only the longer part of the decay is used
  bool shortened = false;             // the decay ends before a disturbance (decay_disturbances())
};

/// Shorter decays show no modes.
inline constexpr std::size_t kMinDecaySamples = 64;
/// Whether the user may accept a hit: its decay is not too short.
inline bool can_be_accepted(const ResponseHit& hit) { return hit.impact.end - hit.impact.first >= kMinDecaySamples; }

/// The results of a test without a force: modes from free decays.
struct ResponseTest {
  acquire::Record record;  // two channels without angles have assumed ones: assume_angles()
  AnalysisOptions options;
  std::pair<double, double> band_Hz;
  std::vector<ResponseHit> hits;
  std::size_t samples = 0;  // of each decay, from ResponseHit::impact.first on
  double start_s = 0;       // start of the fit within these samples: no force acts from there on
  identify::DecayResults found;
  std::vector<identify::ModeClassification> classifications;  // [found.modes]
  std::vector<Warning> warnings;

  bool fitted = false;     // false: ResponseWork::hits; there are no modes, no band and no start
  bool no_impact = false;  // no row shows an impact, nothing stands out of the noise, and nothing decays in the band

  bool possible() const { return samples > 0; }
};

/// What an analysis computes: only the hits, or also the modes. Only a fit of the modes finds hits whose decays are
/// disturbed, and distinguishes a row that begins within a decay from a row without an impact.
enum class ResponseWork { hits, modes };

/// Finds the impacts in the responses and fits the free decays after them, all hits and channels together.
/// errors  InputError: a band that does not fit the data; a hit that does not exist.
ResponseTest analyse_responses(acquire::Record record, const AnalysisOptions& options,
                               ResponseWork work = ResponseWork::modes);

/// The number of impacts: those within the rows, and one for each accepted row that begins within a decay.
std::size_t count_impacts(const ResponseTest& test);

/// The options of an analysis that need a force and are not at their default, in the order of the help.
std::vector<OptionId> stated_force_options(const AnalysisOptions& options);

}  // namespace percuss::pipeline
