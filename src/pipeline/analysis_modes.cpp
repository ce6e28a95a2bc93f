// From the hits' spectra to FRFs, modes and their names.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kFlopsPerHitLine = 20;  // and hit: a few products of complex numbers

// Hits by the point they struck, ascending.
std::map<int, std::vector<std::size_t>> by_point(const std::vector<AnalysedHit>& hits,
                                                 const std::vector<std::size_t>& which) {
  std::map<int, std::vector<std::size_t>> points;
  for (const std::size_t h : which) points[hits[h].point].push_back(h);
  return points;
}

}  // namespace

const std::vector<frf::PointFrf>& Analysis::frfs() const {
  return frfs_.get([&] {
    if (given_) return given_within_lines();
    const std::vector<FrfHits> of = frf_hits();
    force_spectra();
    const ThreadLimit limit(options_.threads);
    return trace_.run("frf", [&] {
      std::vector<frf::PointFrf> out(of.size());
      parallel_for_cost(of.size(), kFlopsPerHitLine * lines().count * of.front().hits.size(),
                        [&](std::size_t i) { out[i] = average(of[i]); });
      return out;
    });
  });
}

std::vector<Analysis::FrfHits> Analysis::frf_hits() const {
  std::vector<FrfHits> out;
  for (const auto& [point, hits_there] : by_point(hits(), accepted_hits())) {
    for (std::size_t c = 0; c < record_.accel.size(); ++c)
      out.push_back({.point = point, .channel = c, .hits = hits_there});
  }
  return out;
}

frf::PointFrf Analysis::average(const FrfHits& of) const {
  const frf::LineRange& range = lines();
  std::vector<std::span<const Complex>> force, accel;
  for (const std::size_t h : of.hits) {
    force.emplace_back(force_spectra()[h].get(), range.count);
    accel.push_back(responses()[h][of.channel].spectrum);
  }
  return {.point = of.point,
          .channel = of.channel,
          .frf = frf::estimate_frf(frf::cross_spectra(force, accel), range, options_.estimator)};
}

const identify::FrfDataset& Analysis::fitted_frfs() const {
  return fitted_frfs_.get([&] {
    const ThreadLimit limit(options_.threads);
    return frf_set(accepted_hits());
  });
}

identify::FrfDataset Analysis::frf_set(const std::vector<std::size_t>& which) const {
  if (given_) return given_set();
  identify::FrfDataset set{.lines = lines()};
  std::vector<double> reach;
  reach.reserve(which.size());
  for (const std::size_t h : which) reach.push_back(hits()[h].hit.bandwidth_Hz);
  set.usable_bandwidth_Hz = median(reach);
  const double decay = window_decay_per_s();
  const std::size_t channels = record_.accel.size();
  std::vector<std::vector<std::size_t>> members;
  for (auto& [point, hits_there] : by_point(hits(), which)) members.push_back(std::move(hits_there));
  const auto& force_spectrum = force_spectra();
  const auto& response = responses();
  // FRFs that somebody has asked for are the same, to the last bit.
  const bool made = frfs_.ready() && options_.estimator == frf::Estimator::h1 && which == accepted_hits();
  set.points.resize(members.size());
  set.outputs.resize(members.size() * channels);
  parallel_for_cost(
      members.size(), kFlopsPerHitLine * lines().count * which.size() / members.size(), [&](std::size_t p) {
        std::vector<frf::ForceBlock> blocks;
        std::vector<double> noise;
        std::vector<frf::Spectrum> spectra;
        for (const std::size_t h : members[p]) {
          blocks.push_back(frf::force_block(hits()[h].hit, record_.fs_Hz, decay));
          noise.push_back(hits()[h].hit.noise_N);
          spectra.push_back(force_spectrum[h]);
        }
        set.points[p] = identify::point_force(std::move(blocks), std::move(spectra), lines(), median(noise));
        for (std::size_t c = 0; c < channels; ++c) {
          std::vector<std::span<const Complex>> accel;
          for (const std::size_t h : members[p]) accel.push_back(response[h][c].spectrum);
          const std::size_t o = p * channels + c;
          set.outputs[o] = {
              .point = p, .channel = c, .frf = made ? frfs()[o].frf.value : identify::h1_at(set.points[p], accel)};
        }
      });
  return set;
}

std::vector<int> Analysis::frf_points() const {
  std::set<int> of;
  if (given_) of = points();
  for (const std::size_t h : accepted_hits()) of.insert(hits()[h].point);
  return {of.begin(), of.end()};
}

const std::vector<identify::Mode>& Analysis::modes() const {
  return modes_.get([&] {
    const identify::FrfDataset& set = fitted_frfs();
    const ThreadLimit limit(options_.threads);
    auto modes = trace_.run("modes", [&] { return identify::identify_modes(set, options_.modes); });
    const std::vector<int> points = frf_points();
    const auto [low, high] = band_Hz();
    std::erase_if(modes, [&, low = low, high = high](const identify::Mode& mode) {
      return mode.pole.freq_Hz < low || mode.pole.freq_Hz > high;
    });
    for (identify::Mode& mode : modes) {
      for (identify::Residue& residue : mode.residues) residue.point = static_cast<std::size_t>(points[residue.point]);
    }
    return modes;
  });
}

void Analysis::compute_modes_and_frfs() const {
  frfs();  // first: the fit reuses the H1 estimates
  modes();
}

const std::vector<identify::ModeClassification>& Analysis::classifications() const {
  return verdicts_.get([&] {
    modes();
    return trace_.run("classes", [&] { return classify_modes(); });
  });
}

std::vector<identify::ModeClassification> Analysis::classify_modes() const {
  std::vector<std::optional<double>> angles;
  for (const acquire::SignalInfo& signal : record_.accel) angles.push_back(signal.angle_rad);
  const auto sensors = identify::pair_of_sensors(angles);
  std::vector<std::optional<double>> overlay_dB(modes().size());
  if (sensors) {
    for (std::size_t m = 0; m < modes().size(); ++m) {
      const std::size_t peak = lines().nearest(modes()[m].pole.freq_Hz);
      double first = 0, second = 0;
      for (const identify::FrfChannel& output : fitted_frfs().outputs) {
        const double power = std::norm(output.frf[peak]);
        if (output.channel == sensors->first) first += power;
        if (output.channel == sensors->second) second += power;
      }
      if (first > 0 && second > 0) overlay_dB[m] = 10 * std::log10(second / first);
    }
  }
  return identify::classify(modes(), sensors, overlay_dB, options_.classes);
}

const std::vector<HitMode>& Analysis::modes_per_hit() const {
  return modes_per_hit_.get([&] {
    modes();
    return trace_.run("modes per hit", [&] { return identify_per_hit(); });
  });
}

const identify::Stabilisation& Analysis::stabilisation() const {
  return stabilisation_.get([&] {
    const identify::FrfDataset& set = fitted_frfs();
    identify::Stabilisation diagram = trace_.run("stabilisation", [&] { return identify::stabilise(set); });
    std::tie(diagram.low_Hz, diagram.high_Hz) = band_Hz();
    std::erase_if(diagram.poles, [&](const identify::StabilisationPole& pole) {
      return pole.pole.freq_Hz < diagram.low_Hz || pole.pole.freq_Hz > diagram.high_Hz;
    });
    return diagram;
  });
}

std::vector<HitMode> Analysis::identify_per_hit() const {
  identify::IdentifyOptions options{.effort = options_.modes.effort};
  for (const identify::Mode& mode : modes()) options.start_Hz.push_back(mode.pole.freq_Hz);
  std::vector<HitMode> out;
  if (options.start_Hz.empty()) return out;
  for (const std::size_t h : accepted_hits()) {
    const auto found = identify::identify_modes(frf_set({h}), options);
    for (std::size_t m = 0; m < found.size() && m < modes().size(); ++m) {
      out.push_back({.hit = h,
                     .mode = m,
                     .pole = found[m].pole,
                     .freq_std_Hz = found[m].freq_std_Hz,
                     .damping_std = found[m].damping_std});
    }
  }
  return out;
}

}  // namespace percuss::pipeline
