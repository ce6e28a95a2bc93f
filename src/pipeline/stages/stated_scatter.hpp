#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// A relative variance as stated standard deviations show it, and the standard deviation of that number. Without
/// evidence both are 0.
struct StatedScatter {
  double variance = 0, std = 0;
};

/// The part of the stated variances of one FRF, σ²(k), that belongs to poles which differ between the averaged hits.
/// The deviations of a hit are taken as real multiples of the modes around `mode` (they differ by place, direction and
/// strength), of the rest of the FRF, of a constant, and of the change p with the relative frequency of these modes:
///   σ²(k) = Σ_ij c_ij Re(u_i(k) conj u_j(k)) + Σ_i d_i Re(p(k) conj u_i(k)) + v |p(k)|²
/// By least squares; `noise2`, the variance of the FRF's noise, sets the weights. The result is v, the variance of the
/// mean pole over its squared angular frequency.
/// `std`: of the lines of the set, as given with the FRF number `frf` of the set.
StatedScatter stated_pole_scatter(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                  std::size_t mode, std::size_t frf, std::span<const double> std, double noise2);

/// The stated variances of one FRF, of which the gain of a mode is a part that differs between the averaged hits. With
/// the mode's part u of the FRF and the rest r = H − u:
///   σ²(k) = g |u(k)|² + a |r(k)|² + b Re(u(k) conj r(k)) + c
/// by least squares over the lines near the mode. A gain that all modes share gives g = a = b/2; gains of their own
/// give b = 0. `std` and `noise2`: as in stated_pole_scatter.
struct StatedGain {
  StatedScatter gain;           // g, the relative variance of the residue
  StatedScatter constant;       // c, ((m/s²)/N)²
  double constant_to_gain = 0;  // Σ|u|² / Σ|u|⁴: c that the lines share, as a relative variance of the residue
};
StatedGain stated_gain(const identify::FrfDataset& set, const identify::Mode& mode, std::size_t frf,
                       std::span<const double> std, double noise2);

}  // namespace percuss::pipeline
