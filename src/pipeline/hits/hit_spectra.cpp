#include "pipeline/hits/hit_spectra.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>

#include "core/parallel/parallel.hpp"
#include "core/parallel/per_thread.hpp"
#include "pipeline/hits/correct_responses.hpp"

namespace percuss::pipeline {
namespace {

// The largest accepted hit of each point, which rings longest.
std::vector<std::size_t> largest_hits(const std::vector<AnalysedHit>& hits) {
  std::map<int, std::size_t> of_point;
  for (const std::size_t h : accepted_hits(hits)) {
    std::size_t& largest = of_point.try_emplace(hits[h].point, h).first->second;
    if (std::abs(hits[h].hit.peak_N) > std::abs(hits[largest].hit.peak_N)) largest = h;
  }
  std::vector<std::size_t> out;
  for (const auto& [point, h] : of_point) out.push_back(h);
  return out;
}

}  // namespace

HitResponses read_responses(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                            const TransformOptions& options, Trace& trace) {
  const acquire::LineRange& range = options.lines;
  const std::size_t channels = record.accel.size();
  std::vector<std::vector<HitResponse>> of(hits.size());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (const std::size_t h : accepted_hits(hits)) {
    of[h].resize(channels);
    for (std::size_t c = 0; c < channels; ++c) tasks.emplace_back(h, c);
  }
  HitResponses out{.of = std::move(of), .lines = UninitializedArray<Complex>(tasks.size() * range.count)};
  if (tasks.empty()) return out;
  plan_real_dft(range.samples);
  parallel_for(tasks.size(), options.threads, [&](std::size_t t) {
    const auto [h, c] = tasks[t];
    const auto spectrum = out.lines.part(t * range.count, range.count);
    const acquire::Hit& hit = hits[h].hit;
    static const PerThread<std::vector<double>> buffers;  // allocated once per thread, not for every response
    std::vector<double>& buffer = buffers.local();
    const auto accel = trace.run("read acceleration", [&, c = c] {
      return record.read_accel_mps2.view_or_read(hit.row, c, hit.first, range.samples, buffer);
    });
    HitResponse& response = out.of[h][c];
    response.grade = acquire::grade_response(hit, accel, record.fs_Hz);
    response.spectrum = spectrum;
    examine_response(response, hit, accel);
    trace.run("fft", [&] { frf::accel_spectrum(hit, accel, range, options.window_decay_per_s, spectrum); });
    if (h != tasks.front().first) return;
    // `accel` may lie in the buffer that this read fills.
    response.tone_candidates =
        tone_candidates(options.tone_samples > range.samples
                            ? record.read_accel_mps2.view_or_read(hit.row, c, hit.first, options.tone_samples, buffer)
                            : accel);
  });
  correct_responses(out, record, hits, options);
  return out;
}

std::vector<frf::Spectrum> force_spectra(const std::vector<AnalysedHit>& hits, const TransformOptions& options,
                                         Trace& trace) {
  const acquire::LineRange& range = options.lines;
  const std::vector<std::size_t> used = accepted_hits(hits);
  std::vector<frf::Spectrum> spectra(hits.size());
  const auto all = std::make_shared<const UninitializedArray<Complex>>(used.size() * range.count);
  parallel_for(used.size(), options.threads, [&](std::size_t u) {
    const auto lines = all->part(u * range.count, range.count);
    trace.run("fft", [&] {
      frf::force_spectrum(frf::force_block(hits[used[u]].hit, range.fs_Hz, options.window_decay_per_s), range, lines);
    });
    spectra[used[u]] = frf::Spectrum(all, lines.data());
  });
  return spectra;
}

std::size_t common_samples(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                           std::size_t missing_samples) {
  const std::vector<std::size_t> used = accepted_hits(hits);
  std::size_t samples = hits[used.front()].hit.samples;
  for (const std::size_t h : used) {
    const acquire::Hit& hit = hits[h].hit;
    const std::size_t row = record.rows[hit.row].samples;
    const std::size_t filled = row - std::min(row, missing_samples);
    samples = std::min({samples, hit.samples, filled - std::min(filled, hit.first)});
  }
  return samples;
}

std::size_t longest_decay_samples(const acquire::Record& record, const std::vector<AnalysedHit>& hits, std::size_t most,
                                  const acquire::RelativeBand& band, std::size_t threads, Trace& trace) {
  const std::size_t channels = record.accel.size();
  // Calls task(t, hit, samples) for response t of these hits.
  const auto for_each_response = [&](const char* stage, const std::vector<std::size_t>& hit_indices, const auto& task) {
    parallel_for(hit_indices.size() * channels, threads, [&](std::size_t t) {
      const acquire::Hit& hit = hits[hit_indices[t / channels]].hit;
      std::vector<double> buffer;
      const acquire::SampleWindow view_or_read = [&](std::size_t first, std::size_t count) {
        return record.read_accel_mps2.view_or_read(hit.row, t % channels, hit.first + first, count, buffer);
      };
      trace.run(stage, [&] { task(t, hit, view_or_read); });
    });
  };
  const std::vector<std::size_t> used = accepted_hits(hits);
  std::vector<std::size_t> settled(used.size() * channels);
  for_each_response("decay", used, [&](std::size_t t, const acquire::Hit& hit, const acquire::SampleWindow& accel) {
    settled[t] = acquire::decayed_length(hit, hit.samples, accel);
  });
  std::size_t samples = std::min(most, *std::max_element(settled.begin(), settled.end()));
  // The level of all frequencies together hides modes that are quieter than the noise of the others, or than hum.
  const std::vector<std::size_t> largest = largest_hits(hits);
  while (samples < most) {
    std::atomic<bool> decays = false;
    for_each_response("decaying lines", largest,
                      [&](std::size_t /*t*/, const acquire::Hit& hit, const acquire::SampleWindow& accel) {
                        if (!decays && acquire::has_decaying_lines(samples, hit.samples, band, accel)) decays = true;
                      });
    if (!decays) break;
    samples = std::min(most, samples + std::max<std::size_t>(samples / 2, 1));
  }
  return samples;
}

}  // namespace percuss::pipeline
