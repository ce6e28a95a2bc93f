#include "model/math/brent_maximum.hpp"

#include <gsl/gsl_min.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace percuss::model {
namespace {

constexpr int kMaxNarrowings = 60;
constexpr double kNarrow = 1e-8;  // of the range: a smooth top is flat to rounding within that

double minus_value(double x, void* f) { return -(*static_cast<const std::function<double(double)>*>(f))(x); }

}  // namespace

MaximumPoint brent_maximum(const std::function<double(double)>& f, const std::vector<double>& x,
                           const std::vector<double>& y) {
  const auto best = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
  const MaximumPoint on_grid{.x = x[best], .y = y[best]};
  if (best == 0 || best + 1 == y.size() || !(y[best - 1] < on_grid.y && y[best + 1] < on_grid.y)) return on_grid;
  std::function<double(double)> copy = f;
  gsl_function function{.function = minus_value, .params = &copy};
  const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> brent(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  gsl_min_fminimizer_set_with_values(brent.get(), &function, on_grid.x, -on_grid.y, x[best - 1], -y[best - 1],
                                     x[best + 1], -y[best + 1]);
  for (int i = 0; i < kMaxNarrowings; ++i) {
    if (gsl_min_fminimizer_iterate(brent.get()) != 0) break;
    const double width = gsl_min_fminimizer_x_upper(brent.get()) - gsl_min_fminimizer_x_lower(brent.get());
    if (width < kNarrow * (x.back() - x.front())) break;
  }
  return {.x = gsl_min_fminimizer_x_minimum(brent.get()), .y = -gsl_min_fminimizer_f_minimum(brent.get())};
}

}  // namespace percuss::model
