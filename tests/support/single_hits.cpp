#include "support/single_hits.hpp"

#include "support/modal_frfs.hpp"

namespace percuss::test {
namespace {

identify::FrfDataset channels_without_modes(std::size_t channels) { return empty_set(4096, 8192, 200, 450, channels); }

}  // namespace

SingleHits::SingleHits(std::size_t points, std::size_t hits_per_point, double noise,
                       const std::function<void(identify::FrfDataset& one, std::size_t point, std::size_t hit)>& add)
    : set(channels_without_modes(points)) {
  const identify::FrfDataset single = channels_without_modes(1);
  set.points.assign(points, single.points.front());
  frfs.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
  for (std::size_t p = 0; p < points; ++p) {
    set.channels[p].point = p;
    set.channels[p].channel = 0;
    for (std::size_t h = 0; h < hits_per_point; ++h) {
      identify::FrfDataset one = single;
      add(one, p, h);
      add_frf_noise(one, noise, 1 + p * hits_per_point + h);
      const Complex* const force = one.points.front().spectra.front().get();
      for (std::size_t k = 0; k < set.lines.count; ++k) {
        set.channels[p].frf[k] += one.channels[0].frf[k] / static_cast<double>(hits_per_point);
        one.channels[0].frf[k] *= force[k];
      }
      frfs.set.channels.push_back({.point = frfs.set.points.size(), .channel = 0, .frf = {}});
      frfs.set.points.push_back(one.points.front());
      frfs.points.push_back(p);
      spectra.push_back(one.channels[0].frf);
    }
  }
  frfs.accel.assign(spectra.begin(), spectra.end());
}

std::vector<identify::Mode> SingleHits::modes(const identify::JointFit& fit) const {
  std::vector<identify::Mode> out;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    identify::Mode& mode = out.emplace_back();
    mode.pole = fit.poles[m];
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const auto row = static_cast<Eigen::Index>(o), column = static_cast<Eigen::Index>(m);
      mode.residues.push_back(
          {.point = o, .channel = 0, .value = fit.residues(row, column), .std = fit.residue_std(row, column)});
    }
  }
  return out;
}

std::vector<identify::Mode> SingleHits::modes(const std::vector<identify::Pole>& poles) const {
  return modes(identify::fit_residues(set, poles));
}

}  // namespace percuss::test
