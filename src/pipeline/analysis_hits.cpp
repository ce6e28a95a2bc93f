// The hits' responses: read, graded, transformed.
#include <algorithm>

#include "core/math/fft.hpp"
#include "core/parallel/parallel.hpp"
#include "frf/windows.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/hit_consistency.hpp"
#include "pipeline/response_clipping.hpp"

namespace percuss::pipeline {

// In a long record what follows the decay is background alone: a shorter transform sees less of it.
std::size_t Analysis::longest_decay() const {
  return longest_decay_.get([&] {
    std::vector<const acquire::Hit*> used;
    for (const AnalysedHit& hit : force_hits()) {
      if (hit.accepted) used.push_back(&hit.hit);
    }
    const std::size_t channels = record_.accel.size();
    std::vector<std::size_t> length(used.size() * channels);
    parallel_for(length.size(), options_.threads, [&](std::size_t t) {
      const acquire::Hit& hit = *used[t / channels];
      std::vector<double> buffer;
      const acquire::SampleWindow view_or_read = [&](std::size_t first, std::size_t count) {
        return record_.read_accel_mps2.view_or_read(hit.row, t % channels, hit.first + first, count, buffer);
      };
      length[t] = trace_.run("decay", [&] { return acquire::decayed_length(hit, hit.samples, view_or_read); });
    });
    return *std::max_element(length.begin(), length.end());
  });
}

const std::vector<std::vector<Analysis::Response>>& Analysis::responses() const {
  return responses_.get([&] { return read_responses(); }).of;
}

Analysis::Responses Analysis::read_responses() const {
  const auto& hits = force_hits();
  const frf::LineRange& range = lines();
  const double decay = window_decay_per_s();
  const std::size_t channels = record_.accel.size();
  std::vector<std::vector<Response>> of(hits.size());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (!hits[h].accepted) continue;
    of[h].resize(channels);
    for (std::size_t c = 0; c < channels; ++c) tasks.emplace_back(h, c);
  }
  Responses out{.of = std::move(of), .lines = UninitializedArray<Complex>(tasks.size() * range.count)};
  plan_real_dft(range.samples);
  parallel_for(tasks.size(), options_.threads, [&](std::size_t t) {
    const auto [h, c] = tasks[t];
    const auto spectrum = out.lines.part(t * range.count, range.count);
    const acquire::Hit& hit = hits[h].hit;
    thread_local std::vector<double> buffer;  // fetched from the system once, not for every response
    const auto accel = trace_.run("read acceleration", [&, c = c] {
      return record_.read_accel_mps2.view_or_read(hit.row, c, hit.first, range.samples, buffer);
    });
    out.of[h][c] = {.grade = acquire::grade_response(hit, accel, record_.fs_Hz), .spectrum = spectrum};
    trace_.run("fft", [&] { frf::accel_spectrum(hit, accel, range, decay, spectrum); });
  });
  return out;
}

const std::vector<frf::Spectrum>& Analysis::force_spectra() const {
  return force_spectra_.get([&] {
    const auto& hits = force_hits();
    std::vector<frf::Spectrum> spectra(hits.size());
    const frf::LineRange& range = lines();
    const double decay = window_decay_per_s();
    std::vector<std::size_t> used;
    for (std::size_t h = 0; h < hits.size(); ++h) {
      if (hits[h].accepted) used.push_back(h);
    }
    const auto all = std::make_shared<const UninitializedArray<Complex>>(used.size() * range.count);
    parallel_for(used.size(), options_.threads, [&](std::size_t u) {
      const auto lines = all->part(u * range.count, range.count);
      trace_.run("fft",
                 [&] { frf::force_spectrum(frf::force_block(hits[used[u]].hit, record_.fs_Hz, decay), range, lines); });
      spectra[used[u]] = frf::Spectrum(all, lines.data());
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
  }
  grade_repeated_clipping(out);
  for (AnalysedHit& hit : out) {
    acquire::add_response_findings(hit.hit, hit.responses);
    if (!hit.by_user) hit.accepted = hit.accepted && !acquire::rejects(hit.hit.findings);
  }
  std::vector<HitSpectra> spectra(out.size());
  for (std::size_t h = 0; h < out.size(); ++h) {
    if (!out[h].accepted) continue;
    spectra[h].force = {force_spectra()[h].get(), lines().count};
    for (const Response& response : all[h]) spectra[h].accel.push_back(response.spectrum);
  }
  const ThreadLimit limit(options_.threads);
  trace_.run("agreement", [&] {
    grade_agreement(out, spectra);
    vote_first_motion(out);
  });
  return out;
}

}  // namespace percuss::pipeline
