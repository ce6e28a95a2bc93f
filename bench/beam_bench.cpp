#include <benchmark/benchmark.h>

#include "model/beam/beam.hpp"
#include "model/impact/impact.hpp"

// Limit: impact_three_sweeps takes at most 100 ms on one core. The default beam is a composite cricket bat.
namespace percuss {
namespace {

void beam_fifty_modes(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(model::beam_modes({}, 50));
}

void impact_one(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(model::simulate_impact({}));
}

void impact_small_increment_10us(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(model::simulate_impact({}, {.method = model::ImpactMethod::small_increment}));
}

// EI 1000:1000:6000, T 500:500:3000, ρA 0.6:0.2:3.0.
void impact_three_sweeps(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const auto run = [](double model::UniformBeam::*value, double low, double step, int count) {
      for (int i = 0; i < count; ++i) {
        model::Impact impact;
        impact.beam.*value = low + i * step;
        benchmark::DoNotOptimize(model::simulate_impact(impact));
      }
    };
    run(&model::UniformBeam::stiffness_Nm2, 1000, 1000, 6);
    run(&model::UniformBeam::torsion_Nmprad, 500, 500, 6);
    run(&model::UniformBeam::mass_per_length_kgpm, 0.6, 0.2, 13);
  }
}

BENCHMARK(beam_fifty_modes)->Unit(benchmark::kMicrosecond);
BENCHMARK(impact_one)->Unit(benchmark::kMillisecond);
BENCHMARK(impact_small_increment_10us)->Unit(benchmark::kMillisecond);
BENCHMARK(impact_three_sweeps)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace percuss
