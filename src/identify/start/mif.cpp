#include "identify/start/mif.hpp"

#include <cassert>
#include <cmath>

namespace percuss::identify {

std::vector<double> mif(const FrfDataset& set, const acquire::LineRange& band) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  const std::size_t skip = band.first - set.lines.first;
  std::vector<double> out(band.count, 1);
  for (std::size_t k = 0; k < band.count; ++k) {
    double real = 0, whole = 0;
    for (const FrfChannel& channel : set.channels) {
      const Complex& h = channel.frf[skip + k];
      real += std::abs(h.real()) * std::abs(h);
      whole += std::norm(h);
    }
    if (whole > 0) out[k] = real / whole;
  }
  return out;
}

}  // namespace percuss::identify
