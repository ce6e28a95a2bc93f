#include "pipeline/hits/hit_spectra.hpp"

#include <algorithm>
#include <memory>

#include "core/parallel/parallel.hpp"
#include "core/parallel/per_thread.hpp"
#include "pipeline/hits/correct_responses.hpp"

namespace percuss::pipeline {

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
    if (h == tasks.front().first) response.tone_candidates = tone_candidates(accel);
    trace.run("fft", [&] { frf::accel_spectrum(hit, accel, range, options.window_decay_per_s, spectrum); });
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

std::size_t longest_decay_samples(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                  std::size_t threads, Trace& trace) {
  const std::vector<std::size_t> used = accepted_hits(hits);
  const std::size_t channels = record.accel.size();
  std::vector<std::size_t> samples(used.size() * channels);
  parallel_for(samples.size(), threads, [&](std::size_t t) {
    const acquire::Hit& hit = hits[used[t / channels]].hit;
    std::vector<double> buffer;
    const acquire::SampleWindow view_or_read = [&](std::size_t first, std::size_t count) {
      return record.read_accel_mps2.view_or_read(hit.row, t % channels, hit.first + first, count, buffer);
    };
    samples[t] = trace.run("decay", [&] { return acquire::decayed_length(hit, hit.samples, view_or_read); });
  });
  return *std::max_element(samples.begin(), samples.end());
}

}  // namespace percuss::pipeline
