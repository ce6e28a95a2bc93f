#include "synth/random_stream.hpp"

#include <cmath>
#include <numbers>

#include "core/budget.hpp"

namespace percuss::synth {
namespace {

// Stafford's mix of SplitMix64: a bijection with uncorrelated outputs for neighbouring inputs.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t seed_of(std::initializer_list<std::uint64_t> name) {
  std::uint64_t seed = name.size();
  for (const std::uint64_t part : name) seed = mix(seed ^ mix(part));
  return seed;
}

}  // namespace

RandomStream::RandomStream(std::initializer_list<std::uint64_t> name) : engine_(seed_of(name)) {}

double RandomStream::uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

void RandomStream::add_normal(double sigma, std::span<double> to) {
  constexpr std::size_t kNumbersPerCheck = std::size_t{1} << 16U;  // about 3 ms
  for (std::size_t i = 0; i < to.size(); i += 2) {
    if (i % kNumbersPerCheck == 0) check_budget();
    const double radius = sigma * std::sqrt(-2 * std::log1p(-uniform()));
    const double angle = 2 * std::numbers::pi * uniform();
    to[i] += radius * std::cos(angle);
    if (i + 1 < to.size()) to[i + 1] += radius * std::sin(angle);
  }
}

}  // namespace percuss::synth
