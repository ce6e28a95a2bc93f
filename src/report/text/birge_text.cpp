#include "report/text/birge_text.hpp"

#include <fmt/format.h>

#include "core/math/significance.hpp"

namespace percuss::report {

std::string birge_text(double chi2, std::size_t degrees) {
  const double ratio = birge_ratio(chi2, static_cast<double>(degrees));
  if (!(ratio > 1)) return {};
  return fmt::format(
      "misfit beyond the ± of the frequencies (chi2 {:.3g}, {} degree{} of freedom): each ± is {:.3g} times larger\n",
      chi2, degrees, degrees == 1 ? "" : "s", ratio);
}

}  // namespace percuss::report
