#include "core/math/fft.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "fftw_baseline.hpp"

// real_dft compared with bare FFTW on its own memory. Lengths: a short hit, 2.56 s at 25.6 kHz, and a prime (the
// slowest case).
namespace percuss {
namespace {

std::vector<double> decay(std::size_t samples) {
  std::vector<double> x(samples);
  for (std::size_t n = 0; n < samples; ++n) {
    const double t = static_cast<double>(n) / static_cast<double>(samples);
    x[n] = std::exp(-8 * t) * std::sin(900 * t);
  }
  return x;
}

void fftw_baseline(benchmark::State& state) {
  FftwBaseline fftw(static_cast<std::size_t>(state.range(0)));
  fftw.fill(decay(static_cast<std::size_t>(state.range(0))));
  for ([[maybe_unused]] auto _ : state) {
    fftw.transform();
    benchmark::ClobberMemory();
  }
}

void percuss_real_dft(benchmark::State& state) {
  const std::vector<double> x = decay(static_cast<std::size_t>(state.range(0)));
  std::vector<Complex> lines(x.size() / 2 + 1);
  for ([[maybe_unused]] auto _ : state) {
    real_dft(x, lines);
    benchmark::ClobberMemory();
  }
}

void percuss_real_dft_allocating(benchmark::State& state) {
  const std::vector<double> x = decay(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(real_dft(x));
}

BENCHMARK(fftw_baseline)->Arg(4096)->Arg(65536)->Arg(65537);
BENCHMARK(percuss_real_dft)->Arg(4096)->Arg(65536)->Arg(65537);
BENCHMARK(percuss_real_dft_allocating)->Arg(4096)->Arg(65536)->Arg(65537);

}  // namespace
}  // namespace percuss
