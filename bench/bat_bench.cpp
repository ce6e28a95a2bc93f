#include <benchmark/benchmark.h>

#include <vector>

#include "model/bat/bat_collision.hpp"
#include "model/trampoline/trampoline.hpp"

// The limits on one core: 397 hoop frequencies in 50 ms, a bat of 84 slices with 60 impact positions in 1 s.
namespace percuss {
namespace {

std::vector<double> evenly(double low, double step, std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = low + step * static_cast<double>(i);
  return all;
}

void hoop_sweep_397(benchmark::State& state) {
  const auto hoop_Hz = evenly(100, 25, 397);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(model::hoop_sweep(model::baseball_on_barrel(), hoop_Hz, 1));
}

model::BatProfile slices_84() {
  model::BatProfile bat{.end_m = evenly(0.01, 0.01, 84), .diameter_m = evenly(0.025, 0.0005, 84)};
  return bat;
}

void bat_modes_84_slices(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(model::bat_modes(slices_84(), {}));
}

void bat_84_slices_60_places(benchmark::State& state) {
  const auto z_m = evenly(0, 0.014, 60);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(model::bat_sweep(model::bat_modes(slices_84(), {}), 40, {}, z_m, 1));
}

BENCHMARK(hoop_sweep_397)->Unit(benchmark::kMillisecond);
BENCHMARK(bat_modes_84_slices)->Unit(benchmark::kMillisecond);
BENCHMARK(bat_84_slices_60_places)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace percuss
