#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "frf/estimators.hpp"
#include "frf/spectra.hpp"

namespace percuss::identify {

/// A mode's pole: s = −ζω + jω√(1 − ζ²), ω = 2π·freq_Hz the undamped natural frequency.
/// theory (3.1)
struct Pole {
  double freq_Hz = 0;
  double damping_ratio = 0;
  double half_power_Hz() const { return 2 * damping_ratio * freq_Hz; }  // half-power (−3 dB) bandwidth
  bool operator==(const Pole&) const = default;
};

/// The half-power bandwidth, at least half the line spacing.
inline double resolved_width_Hz(const Pole& pole, const acquire::LineRange& lines) {
  return std::max(pole.half_power_Hz(), 0.5 * lines.df_Hz());
}

inline constexpr double kMaxDampingRatio = 0.3;  // a pole with more damping describes the background, not a mode

/// The force of the averaged hits of one impact point, for the model of truncated records. Without blocks, or with
/// blocks without force, the force is unknown: the FRFs count as untruncated, and `ff` is empty. Blocks without force
/// still hold the decay rate of the exponential window.
struct PointForce {
  std::vector<frf::ForceBlock> blocks;  // [hits]
  std::vector<frf::Spectrum> spectra;   // F_h [hits]
  std::vector<double> ff;               // Σ |F|² [lines]
  double noise_N = 0;                   // standard deviation of the force channel's noise
  bool complete = false;                // the FRFs are free of truncation: the missing decay was added
  double window_decay_per_s() const {
    return blocks.empty() ? 0 : blocks.front().decay_per_s;
  }  // 0: no window is known
};
/// spectra [hits]: the force_spectrum of each block.
/// errors  InputError: the force has no energy at some spectral line.
PointForce point_force(std::vector<frf::ForceBlock> blocks, std::vector<frf::Spectrum> spectra,
                       const acquire::LineRange& lines, double noise_N);
/// H1 of a response to the hits at this point. shapes  accel [hits][lines]; result [lines], (m/s²)/N
std::vector<Complex> h1_at(const PointForce& force, std::span<const std::span<const Complex>> accel);

/// The contribution of a mode with residue 1 to an H1 estimate, and its derivatives, at some spectral lines.
struct ModeColumn {
  Eigen::VectorXcd value;                // dimensionless
  Eigen::VectorXcd by_freq, by_damping;  // per Hz, per unit of damping ratio
};

/// A mode's amplitude at the end of a record of lines.samples, as a fraction of its start. An exponential window of
/// this decay is included.
/// theory (3.4)
double remaining_amplitude(const Pole& pole, const acquire::LineRange& lines, double window_decay_per_s = 0);

/// True where truncation does not change the mode's column: the mode has decayed by the record's end, the FRFs are
/// complete, or the force is unknown. The column is then H(jω), the same for every point.
bool decays_within_record(const Pole& pole, const PointForce& force, const acquire::LineRange& lines);

/// Approximate operations per spectral line of a ModeColumn, for parallel_for_cost.
inline constexpr std::size_t kFlopsPerColumnLine = 40;

/// ColumnContent::value leaves the derivatives empty, at half the work.
enum class ColumnContent { value, derivatives };

/// The accelerance of one mode in an H1 estimate from truncated records, at lines first … first + count − 1 of
/// `lines`. The structure was at rest before each hit:
///   φ(k) = H(jω) − Σ_h conj(F_h(k)) [c q_h D(k) + conj(c q_h) D̃(k)] / Σ_h |F_h(k)|²                        (1)
///   H(jω) = (jω)² / ((jω)² + 2ζω_r jω + ω_r²),  c = s²/(2jω_d),  q_h = Δ Σ_n f_h[n] exp(s(N − n)Δ)
///   D = 1/(1 − exp((s − jω)Δ)),  D̃ the same with conj(s)
/// An exponential window of decay σ replaces jω by jω + σ in H, and s by s − σ in q and D.
/// The model contains the truncation, so that there is no leakage and no bias of the damping.
/// source  [5] in docs/theory/sources.md.
/// theory (3.3), (3.5)
ModeColumn mode_column(const Pole& pole, const PointForce& force, const acquire::LineRange& lines, std::size_t first,
                       std::size_t count, ColumnContent need = ColumnContent::derivatives);

/// H of (1), which is common to all points.
ModeColumn untruncated_column(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines,
                              std::size_t first, std::size_t count, ColumnContent need = ColumnContent::derivatives);

/// φ of (1) from H, for one point.
ModeColumn subtract_truncation(ModeColumn whole, const Pole& pole, const PointForce& force,
                               const acquire::LineRange& lines, std::size_t first);

}  // namespace percuss::identify
