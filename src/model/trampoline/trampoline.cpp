#include "model/trampoline/trampoline.hpp"

#include <cmath>

#include "core/math/roots.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::model {
Trampoline baseball_on_barrel() { return {}; }

Trampoline softball_on_barrel() {
  return {.ball_mass_kg = 0.180,
          .stiffness = 40.6e6,
          .damping = 4700,
          .stiffness_exponent = 0.65,
          .damping_exponent = 0.5,
          .barrel_mass_kg = 0.150,
          .barrel_damping_Nspm = 100.5};
}

std::vector<Rebound> hoop_sweep(const Trampoline& model, const std::vector<double>& hoop_Hz, std::size_t threads) {
  std::vector<Rebound> sweep(hoop_Hz.size());
  parallel_for(hoop_Hz.size(), threads, [&](std::size_t i) { sweep[i] = rebound(model, hoop_Hz[i]); });
  return sweep;
}

HoopPeak optimal_hoop_frequency(const Trampoline& model, const std::vector<double>& hoop_Hz,
                                const std::vector<Rebound>& sweep) {
  std::vector<double> cor;
  cor.reserve(sweep.size());
  for (const Rebound& r : sweep) cor.push_back(r.cor);
  const MaximumPoint peak = bracketed_maximum([&](double at_Hz) { return rebound(model, at_Hz).cor; }, hoop_Hz, cor);
  return {.hoop_Hz = peak.x, .cor = peak.y, .at_edge = peak.x == hoop_Hz.front() || peak.x == hoop_Hz.back()};
}

double loaded_hoop_Hz(const Trampoline& model, double hoop_Hz) {
  return hoop_Hz * std::sqrt(model.barrel_mass_kg / (model.barrel_mass_kg + model.extra_mass_kg));  // (4)
}

double modal_mass_kg(double added_kg, double free_Hz, double loaded_Hz) {
  const double ratio = free_Hz / loaded_Hz;
  return added_kg / ((ratio - 1) * (ratio + 1));
}

}  // namespace percuss::model
