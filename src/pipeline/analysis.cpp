#include "pipeline/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/statistics.hpp"
#include "core/units.hpp"
#include "frf/windows.hpp"
#include "pipeline/hit_agreement.hpp"

namespace percuss {
namespace {

constexpr double kAntiAlias = 0.44;       // of fs: above it a recorder's filter shapes the FRF
constexpr double kLowestPart = 0.01;      // of the excited band: below it drift and the suspension rule
constexpr double kMargin = 0.15;          // of the band's width, on either side
constexpr double kForceReach = 1.2;       // of the −20 dB bandwidth: as far as a margin may go
constexpr std::size_t kLeastLines = 16;

bool listed(const std::vector<std::size_t>& list, std::size_t i) { return std::find(list.begin(), list.end(), i) != list.end(); }

std::string where(const Record& record) { return record.files.empty() ? "record" : record.files.front().path; }

void check_numbers(const std::vector<std::size_t>& list, std::size_t hits, const char* option) {
  for (const std::size_t i : list) {
    if (i < hits) continue;
    throw InputError(fmt::format("there is no hit {} among {} hits", i, hits), option, "hits count from 0, as in the report");
  }
}

}  // namespace

Analysis::Analysis(Record record, AnalysisOptions options) : record_(std::move(record)), options_(std::move(options)) {
  if (record_.accel.empty()) throw InputError("no acceleration channel", where(record_), "name one with --accel-channel");
}

const std::vector<AnalysedHit>& Analysis::force_hits() const {
  return force_hits_.get([&] { return trace_.run("hits", [&] { return find(); }); });
}

std::vector<AnalysedHit> Analysis::find() const {
  auto found = find_hits(record_, options_.hits);
  check_numbers(options_.accept_hits, found.size(), "--accept-hit");
  check_numbers(options_.reject_hits, found.size(), "--reject-hit");
  if (options_.band_Hz) grade_bandwidth(found, options_.band_Hz->second);
  std::vector<AnalysedHit> hits;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool usable = !found[i].gated_N.empty();
    const bool accept = listed(options_.accept_hits, i) && usable;
    const bool reject = listed(options_.reject_hits, i);
    AnalysedHit hit{.hit = std::move(found[i]), .point = 0, .accepted = false, .by_user = accept || reject, .responses = {}};
    hit.point = record_.rows[hit.hit.row].point;
    hit.accepted = accept || (!reject && !rejects(hit.hit.findings));
    hits.push_back(std::move(hit));
  }
  return hits;
}

bool Analysis::possible() const {
  const auto& all = hits_.ready() ? hits() : force_hits();
  return std::any_of(all.begin(), all.end(), [](const AnalysedHit& hit) { return hit.accepted; });
}

std::pair<double, double> Analysis::band_Hz() const {
  if (options_.band_Hz) return *options_.band_Hz;
  std::vector<double> reach;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) reach.push_back(hit.hit.bandwidth_Hz);
  }
  const double high = reach.empty() ? kAntiAlias * record_.fs_Hz : std::min(median(reach), kAntiAlias * record_.fs_Hz);
  return {kLowestPart * high, high};
}

const LineRange& Analysis::lines() const {
  return lines_.get([&] { return choose_lines(); });
}

// In a long record what follows the decay is background alone: a shorter transform sees less of it.
std::size_t Analysis::longest_decay() const {
  return longest_decay_.get([&] {
    std::vector<const Hit*> used;
    for (const AnalysedHit& hit : force_hits()) {
      if (hit.accepted) used.push_back(&hit.hit);
    }
    const std::size_t channels = record_.accel.size();
    std::vector<std::size_t> length(used.size() * channels);
    parallel_for(length.size(), options_.threads, [&](std::size_t t) {
      const Hit& hit = *used[t / channels];
      std::vector<double> accel(hit.samples);
      trace_.run("read acceleration", [&] { record_.read_accel_mps2(hit.row, t % channels, hit.first, accel); });
      length[t] = decayed_length(hit, accel);
    });
    return *std::max_element(length.begin(), length.end());
  });
}

std::size_t Analysis::block_samples() const {
  std::size_t samples = 0;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) samples = samples == 0 ? hit.hit.samples : std::min(samples, hit.hit.samples);
  }
  if (samples == 0) throw InputError("no hit can be used", where(record_), "see the hits' findings; --accept-hit overrules them");
  const bool searched = record_.continuous || record_.rows.size() == 1;
  if (!searched) return samples;
  if (!options_.hits.length_s) samples = std::min(samples, longest_decay());
  return fast_length_at_most(samples);
}

LineRange Analysis::choose_lines() const {
  const std::size_t samples = block_samples();
  double reach = 0;
  for (const AnalysedHit& hit : force_hits()) {
    if (hit.accepted) reach = std::max(reach, hit.hit.bandwidth_Hz);
  }
  const auto [low, high] = band_Hz();
  if (!(low < high) || low < 0 || high > record_.fs_Hz / 2) {
    throw InputError(fmt::format("the band {:.6g}:{:.6g} Hz does not fit a sampling rate of {:.6g} Hz", low, high, record_.fs_Hz), "--band",
                     "give LO:HI with LO < HI <= half the sampling rate");
  }
  const double margin = kMargin * (high - low);
  const double top = std::max(high, std::min({high + margin, kForceReach * reach, kAntiAlias * record_.fs_Hz}));
  const LineRange range = lines_in_band(record_.fs_Hz, samples, std::max(low - margin, 0.5 * low), top);
  if (range.count < kLeastLines) {
    throw InputError(fmt::format("only {} lines of {:.4g} Hz lie in the band {:.6g}:{:.6g} Hz", range.count, range.df_Hz(), low, high), where(record_),
                     "record longer or widen --band");
  }
  return range;
}

double Analysis::window_decay_per_s() const {
  if (!(options_.exponential_end > 0)) return 0;
  return decay_for_end(options_.exponential_end, static_cast<double>(lines().samples) / record_.fs_Hz);
}

const std::vector<std::vector<Analysis::Response>>& Analysis::responses() const {
  return responses_.get([&] { return read_responses(); });
}

std::vector<std::vector<Analysis::Response>> Analysis::read_responses() const {
  const auto& hits = force_hits();
  const LineRange& range = lines();
  const double decay = window_decay_per_s();
  const std::size_t channels = record_.accel.size();
  std::vector<std::vector<Response>> out(hits.size());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (!hits[h].accepted) continue;
    out[h].resize(channels);
    for (std::size_t c = 0; c < channels; ++c) tasks.emplace_back(h, c);
  }
  parallel_for(tasks.size(), options_.threads, [&](std::size_t t) {
    const auto [h, c] = tasks[t];
    const Hit& hit = hits[h].hit;
    std::vector<double> accel(range.samples);
    trace_.run("read acceleration", [&, c = c] { record_.read_accel_mps2(hit.row, c, hit.first, accel); });
    Response& response = out[h][c];
    response.grade = grade_response(hit, accel, record_.fs_Hz);
    response.spectrum = trace_.run("fft", [&] { return accel_spectrum(hit, accel, range, decay); });
  });
  return out;
}

const std::vector<std::vector<Complex>>& Analysis::force_spectra() const {
  return force_spectra_.get([&] {
    const auto& hits = force_hits();
    std::vector<std::vector<Complex>> spectra(hits.size());
    const LineRange& range = lines();
    const double decay = window_decay_per_s();
    parallel_for(hits.size(), options_.threads, [&](std::size_t h) {
      if (!hits[h].accepted) return;
      spectra[h] = trace_.run("fft", [&] { return force_spectrum(force_block(hits[h].hit, record_.fs_Hz, decay), range); });
    });
    return spectra;
  });
}

const std::vector<AnalysedHit>& Analysis::hits() const {
  return hits_.get([&] { return graded(); });
}

std::vector<AnalysedHit> Analysis::graded() const {
  std::vector<AnalysedHit> out = force_hits();
  if (!possible()) return out;
  const auto& all = responses();
  for (std::size_t h = 0; h < out.size(); ++h) {
    for (const Response& response : all[h]) out[h].responses.push_back(response.grade);
    add_response_findings(out[h].hit, out[h].responses);
    if (!out[h].by_user) out[h].accepted = out[h].accepted && !rejects(out[h].hit.findings);
  }
  std::vector<HitSpectra> spectra(out.size());
  for (std::size_t h = 0; h < out.size(); ++h) {
    if (!out[h].accepted) continue;
    spectra[h].force = &force_spectra()[h];
    for (const Response& response : all[h]) spectra[h].accel.push_back(&response.spectrum);
  }
  trace_.run("agreement", [&] { grade_agreement(out, spectra); });
  return out;
}

std::vector<std::size_t> Analysis::accepted_hits() const {
  std::vector<std::size_t> list;
  for (std::size_t h = 0; h < hits().size(); ++h) {
    if (hits()[h].accepted) list.push_back(h);
  }
  if (!list.empty()) return list;
  throw InputError("no hit can be used", where(record_), "see the hits' findings; --accept-hit overrules them");
}

const std::vector<PointFrf>& Analysis::frfs() const {
  return frfs_.get([&] {
    const auto hits = accepted_hits();
    force_spectra();
    return trace_.run("frf", [&] { return average(); });
  });
}

namespace {

std::map<int, std::vector<std::size_t>> by_point(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& which) {
  std::map<int, std::vector<std::size_t>> points;
  for (const std::size_t h : which) points[hits[h].point].push_back(h);
  return points;
}

}  // namespace

std::vector<PointFrf> Analysis::average() const {
  std::vector<PointFrf> out;
  for (const auto& [point, members] : by_point(hits(), accepted_hits())) {
    std::vector<const std::vector<Complex>*> force;
    for (const std::size_t h : members) force.push_back(&force_spectra()[h]);
    for (std::size_t c = 0; c < record_.accel.size(); ++c) {
      std::vector<const std::vector<Complex>*> accel;
      for (const std::size_t h : members) accel.push_back(&responses()[h][c].spectrum);
      out.push_back({.point = point, .channel = c, .frf = estimate_frf(cross_spectra(force, accel), lines(), options_.estimator)});
    }
  }
  return out;
}

FrfSet Analysis::frf_set(const std::vector<std::size_t>& which) const {
  FrfSet set{.lines = lines()};
  std::vector<double> reach;
  for (const std::size_t h : which) reach.push_back(hits()[h].hit.bandwidth_Hz);
  set.reach_Hz = median(reach);
  const double decay = window_decay_per_s();
  for (const auto& [point, members] : by_point(hits(), which)) {
    std::vector<ForceBlock> blocks;
    std::vector<double> noise;
    std::vector<const std::vector<Complex>*> spectra;
    for (const std::size_t h : members) {
      blocks.push_back(force_block(hits()[h].hit, record_.fs_Hz, decay));
      noise.push_back(hits()[h].hit.noise_N);
      spectra.push_back(&force_spectra()[h]);
    }
    for (std::size_t c = 0; c < record_.accel.size(); ++c) {
      std::vector<const std::vector<Complex>*> accel;
      for (const std::size_t h : members) accel.push_back(&responses()[h][c].spectrum);
      set.outputs.push_back({.point = set.points.size(), .channel = c, .frf = estimate_frf(cross_spectra(spectra, accel), lines()).value});
    }
    set.points.push_back(point_force(std::move(blocks), spectra, median(noise)));
  }
  return set;
}

const std::vector<Mode>& Analysis::modes() const {
  return modes_.get([&] {
    const FrfSet set = frf_set(accepted_hits());
    auto modes = trace_.run("modes", [&] { return identify_quick(set, options_.modes); });
    std::vector<int> points;
    for (const auto& [point, members] : by_point(hits(), accepted_hits())) points.push_back(point);
    const auto [low, high] = band_Hz();
    std::erase_if(modes, [&, low = low, high = high](const Mode& mode) { return mode.pole.freq_Hz < low || mode.pole.freq_Hz > high; });
    for (Mode& mode : modes) {
      for (Residue& residue : mode.residues) residue.point = static_cast<std::size_t>(points[residue.point]);
    }
    return modes;
  });
}

const std::vector<Verdict>& Analysis::verdicts() const {
  return verdicts_.get([&] {
    modes();
    return trace_.run("classes", [&] { return name_modes(); });
  });
}

std::vector<Verdict> Analysis::name_modes() const {
  std::vector<std::optional<double>> angles;
  for (const SignalInfo& signal : record_.accel) angles.push_back(signal.angle_rad);
  const auto sensors = pair_of_sensors(angles);
  std::vector<std::optional<double>> overlay_dB(modes().size());
  if (sensors) {
    const auto line_of = [&](double freq_Hz) {
      return static_cast<std::size_t>(std::lround(freq_Hz / lines().df_Hz())) - lines().first;
    };
    for (std::size_t m = 0; m < modes().size(); ++m) {
      double first = 0, second = 0;
      for (const PointFrf& frf : frfs()) {
        const double power = std::norm(frf.frf.value[std::min(line_of(modes()[m].pole.freq_Hz), lines().count - 1)]);
        (frf.channel == sensors->first ? first : second) += frf.channel == sensors->first || frf.channel == sensors->second ? power : 0;
      }
      if (first > 0 && second > 0) overlay_dB[m] = 10 * std::log10(second / first);
    }
  }
  return classify(modes(), sensors, overlay_dB, options_.classes);
}

const std::vector<HitMode>& Analysis::modes_per_hit() const {
  return modes_per_hit_.get([&] {
    modes();
    return trace_.run("modes per hit", [&] { return identify_per_hit(); });
  });
}

std::vector<HitMode> Analysis::identify_per_hit() const {
  QuickOptions options;
  for (const Mode& mode : modes()) options.start_Hz.push_back(mode.pole.freq_Hz);
  std::vector<HitMode> out;
  if (options.start_Hz.empty()) return out;
  for (const std::size_t h : accepted_hits()) {
    const auto found = identify_quick(frf_set({h}), options);
    for (std::size_t m = 0; m < found.size() && m < modes().size(); ++m) {
      out.push_back({.hit = h, .mode = m, .pole = found[m].pole, .freq_std_Hz = found[m].freq_std_Hz, .damping_std = found[m].damping_std});
    }
  }
  return out;
}

std::vector<std::pair<int, Record>> split_runs(const Record& record) {
  std::map<int, bool> runs;
  for (const RowInfo& row : record.rows) runs[row.run] = true;
  std::vector<std::pair<int, Record>> out;
  for (const auto& [run, present] : runs) {
    out.emplace_back(run, select_rows(record, [run = run](const RowInfo& row) { return row.run == run; }));
  }
  return out;
}

}  // namespace percuss
