#pragma once
#include <fftw3.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace percuss {

/// Memory for samples, aligned as FFTW likes it.
using FftwSamples = std::unique_ptr<double, decltype(&fftw_free)>;
inline FftwSamples fftw_samples(std::size_t samples) { return {fftw_alloc_real(samples), fftw_free}; }

/// FFTW called by hand on memory of its own, planned once: what every other time is compared with.
class FftwBaseline {
 public:
  explicit FftwBaseline(std::size_t samples, unsigned planning = FFTW_ESTIMATE)
      : in_(fftw_alloc_real(samples)),
        out_(fftw_alloc_complex(samples / 2 + 1)),
        plan_(fftw_plan_dft_r2c_1d(static_cast<int>(samples), in_, out_, planning | FFTW_PRESERVE_INPUT)) {}
  FftwBaseline(const FftwBaseline&) = delete;
  FftwBaseline& operator=(const FftwBaseline&) = delete;
  ~FftwBaseline() {
    fftw_destroy_plan(plan_);
    fftw_free(in_);
    fftw_free(out_);
  }
  void fill(const std::vector<double>& x) { std::copy(x.begin(), x.end(), in_); }
  void transform() { fftw_execute(plan_); }
  /// Of values elsewhere, which are FftwSamples.
  void transform(double* values) { fftw_execute_dft_r2c(plan_, values, out_); }

 private:
  double* in_;
  fftw_complex* out_;
  fftw_plan plan_;
};

}  // namespace percuss
