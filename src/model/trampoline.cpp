#include "model/trampoline.hpp"

#include <gsl/gsl_min.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/parallel.hpp"

namespace percuss {
namespace {

constexpr int kMostNarrowings = 60;
constexpr double kNarrow = 1e-8;  // of the frequency; the curve's top is flat to rounding within that

struct HoopSearch {
  const Trampoline* model;
};

double minus_cor(double hoop_Hz, void* search) {
  return -rebound(*static_cast<const HoopSearch*>(search)->model, hoop_Hz).cor;
}

}  // namespace

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

HoopPeak best_hoop(const Trampoline& model, const std::vector<double>& hoop_Hz, const std::vector<Rebound>& sweep) {
  const auto best = static_cast<std::size_t>(
      std::max_element(sweep.begin(), sweep.end(), [](const auto& a, const auto& b) { return a.cor < b.cor; }) -
      sweep.begin());
  const HoopPeak on_grid{.hoop_Hz = hoop_Hz[best], .cor = sweep[best].cor};
  if (best == 0 || best + 1 == sweep.size()) return on_grid;
  if (!(sweep[best - 1].cor < on_grid.cor && sweep[best + 1].cor < on_grid.cor)) return on_grid;
  HoopSearch search{&model};
  gsl_function function{.function = minus_cor, .params = &search};
  const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> brent(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  gsl_min_fminimizer_set_with_values(brent.get(), &function, on_grid.hoop_Hz, -on_grid.cor, hoop_Hz[best - 1],
                                     -sweep[best - 1].cor, hoop_Hz[best + 1], -sweep[best + 1].cor);
  for (int i = 0; i < kMostNarrowings; ++i) {
    if (gsl_min_fminimizer_iterate(brent.get()) != 0) break;
    const double width = gsl_min_fminimizer_x_upper(brent.get()) - gsl_min_fminimizer_x_lower(brent.get());
    if (width < kNarrow * on_grid.hoop_Hz) break;
  }
  return {.hoop_Hz = gsl_min_fminimizer_x_minimum(brent.get()), .cor = -gsl_min_fminimizer_f_minimum(brent.get())};
}

double loaded_hoop_Hz(const Trampoline& model, double hoop_Hz) {
  return hoop_Hz * std::sqrt(model.barrel_mass_kg / (model.barrel_mass_kg + model.extra_mass_kg));  // (4)
}

double modal_mass_kg(double added_kg, double free_Hz, double loaded_Hz) {
  const double ratio = free_Hz / loaded_Hz;
  return added_kg / ((ratio - 1) * (ratio + 1));
}

}  // namespace percuss
