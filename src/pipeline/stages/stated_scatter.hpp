#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// Variance of a mean pole over its squared angular frequency, as stated standard deviations show it, and the standard
/// deviation of that number. Without evidence both are 0.
struct PoleScatter {
  double variance = 0, std = 0;
};

/// The part of the stated variances of one FRF, σ²(k), that belongs to poles which differ between the averaged hits.
/// The deviations of a hit are taken as real multiples of the modes around `mode` (they differ by place, direction and
/// strength), of the rest of the FRF, of a constant, and of the change p with the relative frequency of these modes:
///   σ²(k) = Σ_ij c_ij Re(u_i(k) conj u_j(k)) + Σ_i d_i Re(p(k) conj u_i(k)) + v |p(k)|²
/// By least squares; `noise2`, the variance of the FRF's noise, sets the weights.
/// `std`: of the lines of the set, as given with the FRF number `frf` of the set.
PoleScatter stated_pole_scatter(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                std::size_t mode, std::size_t frf, std::span<const double> std, double noise2);

}  // namespace percuss::pipeline
