#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/io/significant_digits.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/start/unmodelled_peaks.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kPeaks_dB = 65;              // under the largest line: lower peaks are not missed
constexpr std::size_t kMaxPeaks = 8;          // named
constexpr double kMinPretriggerSamples = 32;  // samples from a record's beginning to the pulse
constexpr double kMinRingingNoise = 2e-4;     // noise of a sample over the largest response …
constexpr std::size_t kMinNoiseLines = 512;   // … when there are so many lines
constexpr double kDecayed = 0.0025;           // six time constants, as for the hits' own finding

bool any_finding(const std::vector<AnalysedHit>& hits, acquire::FindingCode code, bool accepted_only) {
  return std::any_of(hits.begin(), hits.end(), [&](const AnalysedHit& hit) {
    return (hit.accepted || !accepted_only) && std::any_of(hit.hit.findings.begin(), hit.hit.findings.end(),
                                                           [&](const acquire::Finding& f) { return f.code == code; });
  });
}

// "hits 0, 2", or "every hit used"; empty when the channel is alive in all of them.
std::string constant_hits(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  std::string numbers;
  bool alive = false;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (!hits[h].accepted || hits[h].responses.size() <= channel) continue;
    if (hits[h].responses[channel].dead) {
      numbers += fmt::format("{}{}", numbers.empty() ? "hits " : ", ", h);
    } else {
      alive = true;
    }
  }
  return numbers.empty() || alive ? numbers : "every hit used";
}

// Over the accepted hits, of the channel's largest response.
double coarsest_step(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  double step = 0;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted && hit.responses.size() > channel) step = std::max(step, hit.responses[channel].coarse_step);
  }
  return step;
}

void warn_of_steps(const acquire::Record& record, const std::vector<AnalysedHit>& hits, std::vector<Warning>& out) {
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    const double step = coarsest_step(hits, c);
    if (!(step > 0)) continue;
    out.push_back(
        {"coarse_steps",
         fmt::format("the numbers of {} come in steps of {:.2g} % of its largest response, which no noise blurs: modes "
                     "may be off by more than their ±, and weak ones none; use the recorder's range and digits",
                     one_line(record.accel[c].name, 40), 100 * step)});
  }
}

// Of a channel, over the accepted hits, m/s².
double largest_response(const std::vector<AnalysedHit>& hits, std::size_t channel) {
  double largest = 0;
  for (const AnalysedHit& hit : hits) {
    if (!hit.accepted || hit.responses.size() <= channel) continue;
    const Extremes& seen = hit.responses[channel].extremes;
    largest = std::max({largest, std::abs(seen.low), std::abs(seen.high)});
  }
  return largest;
}

// Whether the samples of some response are so quiet that what is missing of the filter's ringing stands out of them.
bool ringing_stands_out(const identify::FrfDataset& set, const std::vector<AnalysedHit>& hits) {
  if (set.lines.count < kMinNoiseLines) return true;
  const identify::LineNoise noise(set);
  const std::size_t line = set.lines.count / 2;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const std::vector<double>& ff = set.points[set.channels[o].point].ff;
    if (ff.empty()) continue;
    const double of_sample_mps2 = noise.at(o, line) * std::sqrt(ff[line] / static_cast<double>(set.lines.samples));
    if (of_sample_mps2 < kMinRingingNoise * largest_response(hits, set.channels[o].channel)) return true;
  }
  return false;
}

// What rang of the anti-alias filter before a row began is not in it.
void warn_of_pretrigger(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                        const identify::FrfDataset& set, std::vector<Warning>& out) {
  double least = kMinPretriggerSamples;
  for (const AnalysedHit& hit : hits) {
    if (hit.accepted) least = std::min(least, hit.hit.onset_s * record.fs_Hz - static_cast<double>(hit.hit.first));
  }
  if (least >= kMinPretriggerSamples || !ringing_stands_out(set, hits)) return;
  out.push_back(
      {"short_pretrigger",
       fmt::format("a record begins {:.0f} samples before its pulse, within the recorder's own ringing: "
                   "the noise is so low that a mode's ± may be half of what it should be; record {:.0f} samples "
                   "before the pulse",
                   std::max(0.0, least), 2 * kMinPretriggerSamples)});
}

}  // namespace

void Analysis::warn_of_truncation(std::vector<Warning>& out) const {
  if (!modes_.ready()) return;
  std::string ringing;
  for (const identify::Mode& mode : modes()) {
    const double left = identify::remaining_amplitude(mode.pole, lines(), window_decay_per_s());
    if (left > kDecayed)
      ringing += fmt::format("{}{:.1f} Hz ({:.1f} %)", ringing.empty() ? "" : ", ", mode.pole.freq_Hz, left * 100);
  }
  if (ringing.empty()) return;
  out.push_back(
      {"truncated_decay",
       given_ ? fmt::format("the lines' spacing tells of records of {:.4g} s, at whose end these modes still rang with "
                            "this part of their amplitude: {}. Without the force that cannot be allowed for: their "
                            "residues may be off by as much, and their damping reads high if the recorder applied an "
                            "exponential window",
                            1 / lines().df_Hz(), ringing)
              : "still ringing when the record ends, with this part of their amplitude: " + ringing +
                    "; the damping is fitted with the missing decay allowed for, not read from a peak's width"});
}

void Analysis::warn_of_unmodelled_peaks(std::vector<Warning>& out) const {
  if (!modes_.ready() || options_.modes.modes || !options_.modes.start_Hz.empty()) return;  // the user chose
  const auto [low, high] = band_Hz();
  auto peaks = identify::unmodelled_peaks(fitted_frfs(), modes(), kPeaks_dB);
  std::erase_if(peaks, [low = low, high = high](const identify::UnmodelledPeak& peak) {
    return peak.freq_Hz < low || peak.freq_Hz > high;
  });
  if (peaks.empty()) return;
  std::stable_sort(
      peaks.begin(), peaks.end(),
      [](const identify::UnmodelledPeak& a, const identify::UnmodelledPeak& b) { return a.level_dB > b.level_dB; });
  std::string named;
  for (std::size_t p = 0; p < std::min(peaks.size(), kMaxPeaks); ++p)
    named += fmt::format("{}{:.6g} Hz ({:.0f} dB)", p == 0 ? "" : ", ", peaks[p].freq_Hz, peaks[p].level_dB);
  if (peaks.size() > kMaxPeaks) named += fmt::format(" and {} lower ones", peaks.size() - kMaxPeaks);
  out.push_back({"unclaimed_peaks", "peaks that no mode stands for: " + named +
                                        ". A single decaying oscillation does not fit them beyond doubt; two that are "
                                        "a line or two apart may: point at each with --start"});
}

namespace {

// Accepted hits that agree with the others by less than half.
std::string poorly_coherent_hits(const std::vector<AnalysedHit>& hits) {
  constexpr double kHalf = 0.5;
  std::string out;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const auto& findings = hits[i].hit.findings;
    const bool strange = std::any_of(findings.begin(), findings.end(), [](const acquire::Finding& finding) {
      return finding.code == acquire::FindingCode::low_coherence && finding.value < kHalf;
    });
    if (hits[i].accepted && strange) out += fmt::format("{}{}", out.empty() ? "hits " : ", ", i);
  }
  return out;
}

}  // namespace

std::vector<Warning> Analysis::warnings() const {
  std::vector<Warning> out;
  const auto& all = hits_.ready() ? hits() : force_hits();
  for (const Message& note : record_.notes) out.push_back({"input", note.text});
  if (given_ && modes_.ready() && !modes().empty()) {
    out.push_back(
        {"force_noise_unknown",
         "FRFs do not tell how noisy the force was: each ± counts the response's noise alone, and is too small "
         "where the force's is larger; analyse the records where you have them"});
  }
  const auto rejected = std::count_if(all.begin(), all.end(), [](const AnalysedHit& hit) { return !hit.accepted; });
  if (rejected > 0) {
    out.push_back(
        {"rejected_hits", fmt::format("{} of {} hits not used; the reasons stand beside them", rejected, all.size())});
  }
  if (const std::string strangers = poorly_coherent_hits(all); !strangers.empty()) {
    out.push_back({"hits_disagree",
                   strangers + " explain less than half of what the others show: another structure, place or sensor?" +
                       (record_.files.size() > 1 ? " --files tests takes each file for itself" : "")});
  }
  if (any_finding(all, acquire::FindingCode::polarity, true)) {
    out.push_back(
        {"polarity",
         "the force is negative during the pulse: the FRFs have the wrong sign unless --force-scale is negative"});
  }
  if (any_finding(all, acquire::FindingCode::low_bandwidth, true)) {
    out.push_back(
        {"low_bandwidth", "the hammer's force does not reach the end of the band: modes there are weakly excited"});
  }
  for (std::size_t c = 0; c < record_.accel.size(); ++c) {
    const std::string dead = constant_hits(all, c);
    if (dead.empty()) continue;
    out.push_back({"dead_channel", fmt::format("{} reads the same number throughout in {}: check its cable, or choose "
                                               "the others with --accel-channel",
                                               one_line(record_.accel[c].name, 40), dead)});
  }
  warn_of_steps(record_, all, out);
  if (modes_.ready() && !given_) warn_of_pretrigger(record_, all, fitted_frfs(), out);
  const bool rings = std::any_of(all.begin(), all.end(), [](const AnalysedHit& hit) {
    return hit.accepted && std::any_of(hit.responses.begin(), hit.responses.end(),
                                       [](const acquire::ResponseGrade& g) { return g.rings_before; });
  });
  if (rings) {
    out.push_back({"not_at_rest",
                   "the structure was still ringing before a hit: wait longer between hits; damping there may be off "
                   "by more than its ±"});
  }
  warn_of_freq_scatter(out);
  warn_of_truncation(out);
  warn_of_unmodelled_peaks(out);
  if (verdicts_.ready()) {
    std::string pairs;
    for (std::size_t m = 0; m < classifications().size(); ++m) {
      const auto& pair = classifications()[m].split_mode;
      if (pair && pair->first) {
        pairs += fmt::format("{}{:.1f} Hz ({} Hz apart)", pairs.empty() ? "" : ", ", modes()[m].pole.freq_Hz,
                             significant(pair->separation_Hz, 3));
      }
    }
    if (!pairs.empty()) {
      out.push_back(
          {"double_peak", "double peaks, of which the first is quoted: " + pairs +
                              ". Possible causes: a tuned absorber, a crack or other damage, uneven wall or material"});
    }
  }
  return out;
}

}  // namespace percuss::pipeline
