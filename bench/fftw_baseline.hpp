#pragma once
#include <fftw3.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace percuss {

/// Memory for samples with the alignment of FFTW.
using FftwSamples = std::unique_ptr<double, decltype(&fftw_free)>;
inline FftwSamples fftw_samples(std::size_t samples) { return {fftw_alloc_real(samples), fftw_free}; }

/// A bare FFTW transform on its own memory, planned once: the baseline of all other times.
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
  /// Transforms other FftwSamples.
  void transform(double* values) { fftw_execute_dft_r2c(plan_, values, out_); }

 private:
  double* in_;
  fftw_complex* out_;
  fftw_plan plan_;
};

}  // namespace percuss
