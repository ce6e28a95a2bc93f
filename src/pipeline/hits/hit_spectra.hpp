#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "acquire/hits/decaying_lines.hpp"
#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"
#include "core/trace.hpp"
#include "core/uninitialized_array.hpp"
#include "frf/spectra.hpp"
#include "pipeline/findings/baseline.hpp"
#include "pipeline/findings/long_dropout.hpp"
#include "pipeline/findings/recorded_window.hpp"
#include "pipeline/findings/sample_faults.hpp"
#include "pipeline/findings/tones.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// The spectral lines that the hits are transformed to, and the exponential window applied before.
struct TransformOptions {
  acquire::LineRange lines;
  double window_decay_per_s = 0;
  std::size_t threads = 0;
  // Samples of each response in which tones are searched. If a decay was cut, they are more than the samples of the
  // lines, because only the tones are left after the decay. 0: the samples of the lines.
  std::size_t tone_samples = 0;
};

/// One response to one hit.
struct HitResponse {
  acquire::ResponseGrade grade;
  NoiseHistory noise;
  RestLevels rest;
  std::optional<LongDropout> dropout;      // not replaced
  std::optional<BaselineChange> baseline;  // removed before the transform
  std::vector<double> tone_candidates;     // turns per sample; of the first accepted hit alone
  std::span<const Complex> spectrum;       // [lines]
};

/// The faults found in the samples of one hit. Wrong and missing samples are replaced before the transform.
struct HitFaults {
  std::size_t hit = 0;
  std::vector<SampleFault> faults;
};

struct HitResponses {
  std::vector<std::vector<HitResponse>> of;  // [hits][channels]; empty for hits that are not accepted
  UninitializedArray<Complex> lines;         // storage of the spectra
  std::vector<HitFaults> faults{};           // ascending by hit
  std::vector<Tone> tones{};                 // removed before the transform
};

/// The time of each hit that the transforms use, and the time that all hits have.
struct DecayCut {
  double used_s = 0, all_s = 0;
};

/// Reads, grades and transforms the responses to the accepted hits. Stages: "read acceleration", "fft".
HitResponses read_responses(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                            const TransformOptions& options, Trace& trace);

/// Spectra of the forces, [hits]; nullptr for hits that are not accepted. Stage: "fft".
std::vector<frf::Spectrum> force_spectra(const std::vector<AnalysedHit>& hits, const TransformOptions& options,
                                         Trace& trace);

/// Samples that all accepted hits have. The last `missing_samples` of a row have no data. Needs an accepted hit.
std::size_t common_samples(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                           std::size_t missing_samples);

/// Samples until the slowest response to an accepted hit has decayed into the noise, at most `most`. Later samples add
/// only noise to a transform: in the largest hit of each point, no spectral line of the band decays after them.
/// Stages: "decay", "decaying lines".
std::size_t longest_decay_samples(const acquire::Record& record, const std::vector<AnalysedHit>& hits, std::size_t most,
                                  const acquire::RelativeBand& band, std::size_t threads, Trace& trace);

}  // namespace percuss::pipeline
