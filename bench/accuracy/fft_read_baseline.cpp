#include "fft_read_baseline.hpp"

#include <map>
#include <memory>

#include "../fftw_baseline.hpp"
#include "../read_bytes.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::size_t kMaxMeasured = std::size_t{1}
                                     << 17U;  // samples; planning longer lengths by measurement takes seconds

// Plans each length once, and forgets FFTW's wisdom afterwards. Otherwise percuss's own plans, made without
// measurement, would use it.
FftwBaseline& planned(std::size_t samples) {
  static std::map<std::size_t, std::unique_ptr<FftwBaseline>> plans;
  auto& plan = plans[samples];
  if (plan) return *plan;
  plan = std::make_unique<FftwBaseline>(samples, samples > kMaxMeasured ? FFTW_ESTIMATE : FFTW_MEASURE);
  fftw_forget_wisdom();
  plan->fill(std::vector<double>(samples, 1.0));
  return *plan;
}

}  // namespace

FftReadBaseline::FftReadBaseline(std::vector<std::string> paths, const acquire::Record& record)
    : paths_(std::move(paths)),
      samples_(record.rows.front().samples),
      transforms_(record.rows.size() * (1 + record.accel.size())) {
  planned(samples_);
}

void FftReadBaseline::run() const {
  for (const std::string& path : paths_) read_bytes_of(path);
  FftwBaseline& fftw = planned(samples_);
  for (std::size_t n = 0; n < transforms_; ++n) fftw.transform();
}

void transform_once(std::size_t samples) { planned(samples).transform(); }

}  // namespace percuss::accuracy
