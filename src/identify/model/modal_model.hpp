#pragma once
#include <Eigen/Core>
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
  double half_power_Hz() const { return 2 * damping_ratio * freq_Hz; }  // bandwidth, 3 dB down
  bool operator==(const Pole&) const = default;
};

inline constexpr double kMaxDampingRatio = 0.3;  // a ratio beyond it is the background's

/// The averaged hits of one impact point, as far as the model of a truncated record needs them. Without blocks, or with
/// blocks without force, nothing is known of the force: the FRF is taken as it is, `ff` is empty. A block's decay is
/// that of the exponential window in any case.
struct PointForce {
  std::vector<frf::ForceBlock> blocks;  // [hits]
  std::vector<frf::Spectrum> spectra;   // F_h [hits]
  std::vector<double> ff;               // Σ |F|² [lines]
  double noise_N = 0;                   // deviation of the force channel's noise
  bool complete = false;                // the FRFs are as records would have given them that hold the whole decay
  double window_decay_per_s() const { return blocks.empty() ? 0 : blocks.front().decay_per_s; }  // 0: none is known of
};
/// spectra [hits]: force_spectrum of each block.
/// errors  InputError when the force never excited one of the lines.
PointForce point_force(std::vector<frf::ForceBlock> blocks, std::vector<frf::Spectrum> spectra,
                       const frf::LineRange& lines, double noise_N);
/// H1 of a response to that point's hits. shapes  accel [hits] point to [lines]; result [lines], (m/s²)/N
std::vector<Complex> h1_at(const PointForce& force, std::span<const std::span<const Complex>> accel);

/// A mode's share of an H1 estimate, for residue 1, and its derivatives, at lines first … first + count − 1 of `lines`.
struct ModeColumn {
  Eigen::VectorXcd value;                // dimensionless
  Eigen::VectorXcd by_freq, by_damping;  // per Hz, per unit of damping ratio
};

/// What is left of a mode's amplitude when a record of lines.samples ends, as a fraction of its start; with an
/// exponential window of that decay.
/// theory (3.4)
double remaining_amplitude(const Pole& pole, const frf::LineRange& lines, double window_decay_per_s = 0);

/// True when nothing is missing of the mode: it has decayed by the record's end, the FRFs were completed, or nothing is
/// known of the force. Then its column is H(jω) itself, the same for every point.
bool decays_within_record(const Pole& pole, const PointForce& force, const frf::LineRange& lines);

/// Operations of one line of such a column, about, for parallel_for_cost.
inline constexpr std::size_t kFlopsPerColumnLine = 40;

/// The accelerance of one mode as H1 sees it when the structure was at rest before each hit and the record ends before
/// the decay:
///   φ(k) = H(jω) − Σ_h conj(F_h(k)) [c q_h D(k) + conj(c q_h) D̃(k)] / Σ_h |F_h(k)|²                        (1)
///   H(jω) = (jω)² / ((jω)² + 2ζω_r jω + ω_r²),  c = s²/(2jω_d),  q_h = Δ Σ_n f_h[n] exp(s(N − n)Δ)
///   D = 1/(1 − exp((s − jω)Δ)),  D̃ the same with conj(s)
/// With an exponential window of decay σ, jω + σ stands for jω in H, s − σ for s in q and D.
/// What is missing after the record's end is thereby part of the model: no leakage, no bias of the damping.
/// source  [5], [6] in docs/theory/sources.md.
/// theory (3.3), (3.5)
/// Need::value leaves the derivatives empty, at half the work.
enum class ColumnContent { value, derivatives };
ModeColumn mode_column(const Pole& pole, const PointForce& force, const frf::LineRange& lines, std::size_t first,
                       std::size_t count, ColumnContent need = ColumnContent::derivatives);

/// H of (1) alone: what the columns of all points have in common.
ModeColumn untruncated_column(const Pole& pole, double window_decay_per_s, const frf::LineRange& lines,
                              std::size_t first, std::size_t count, ColumnContent need = ColumnContent::derivatives);

/// φ of (1) from H.
ModeColumn subtract_truncation(ModeColumn whole, const Pole& pole, const PointForce& force, const frf::LineRange& lines,
                               std::size_t first);

/// H − φ of (1) at lines first … first + count − 1: what a mode's decay lacks of what comes after the records' end.
/// What all points have in common of it is worked out once.
class TruncatedDecay {
 public:
  TruncatedDecay(const Pole& pole, double window_decay_per_s, const frf::LineRange& lines, std::size_t first,
                 std::size_t count);
  /// Adds residue·(H − φ) of hits at that point. shape  sum [count]
  void add_to(std::span<Complex> sum, Complex residue, const PointForce& force) const;

 private:
  frf::LineRange lines_;
  std::size_t first_;
  Complex windowed_;                      // s − σ
  std::vector<Complex> kernel_, mirror_;  // [count] c·D and conj(c)·D̃
};

}  // namespace percuss::identify
