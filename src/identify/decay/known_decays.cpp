#include "identify/decay/known_decays.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kMinLinesPerRate = 3;
constexpr double kNearBandwidths = 5, kNearLines = 20;  // on either side of a decay: the lines that show its noise

// Mean power of the residual's real and imaginary part near a rate, [hits × channels].
Eigen::RowVectorXd noise_near(const DecayRate& rate, const DecaySpectra& spectra, std::size_t first,
                              const Eigen::MatrixXcd& residual) {
  const double at = rate.pole().freq_Hz / spectra.df_Hz() - static_cast<double>(first);
  const double reach = std::max(kNearLines, kNearBandwidths * rate.pole().half_power_Hz() / spectra.df_Hz());
  const auto last = static_cast<double>(residual.rows() - 1);
  const auto low = static_cast<Index>(std::clamp(at - reach, 0.0, last));
  const auto high = static_cast<Index>(std::clamp(at + reach, 0.0, last));
  return residual.middleRows(low, high - low + 1).cwiseAbs2().colwise().mean() / 2;
}

}  // namespace

KnownDecays fit_known_decays(const std::vector<DecayRate>& rates, const DecaySpectra& spectra, std::size_t first,
                             std::size_t count) {
  KnownDecays out;
  if (rates.empty() || count < kMinLinesPerRate * rates.size()) return out;
  const auto lines = static_cast<Index>(count), modes = static_cast<Index>(rates.size());
  Eigen::MatrixXd columns(2 * lines, 2 * modes);
  for (Index m = 0; m < modes; ++m) {
    const Eigen::MatrixX2cd values = decay_values(rates[static_cast<std::size_t>(m)], spectra, first, count);
    columns.block(0, 2 * m, lines, 2) = values.real();
    columns.block(lines, 2 * m, lines, 2) = values.imag();
  }
  Eigen::MatrixXd data(2 * lines, spectra.lines.cols());
  data.topRows(lines) = spectra.lines.middleRows(static_cast<Index>(first), lines).real();
  data.bottomRows(lines) = spectra.lines.middleRows(static_cast<Index>(first), lines).imag();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  const Eigen::MatrixXd parts = qr.solve(data);  // [2 modes, hits × channels]
  const Eigen::MatrixXd left = data - columns * parts;
  Eigen::MatrixXcd residual(lines, data.cols());
  residual.real() = left.topRows(lines);
  residual.imag() = left.bottomRows(lines);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(2 * modes).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd inverse =
      r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(2 * modes, 2 * modes));
  const double freedom = static_cast<double>(lines) / static_cast<double>(lines - modes);
  out.amplitude.resize(modes, data.cols());
  out.variance.resize(modes, data.cols());
  for (Index m = 0; m < modes; ++m) {
    out.amplitude.row(m).real() = parts.row(2 * m);
    out.amplitude.row(m).imag() = parts.row(2 * m + 1);
    const double of_unit_noise = inverse.middleRows(2 * m, 2).squaredNorm() / 2;
    out.variance.row(m) =
        of_unit_noise * freedom * noise_near(rates[static_cast<std::size_t>(m)], spectra, first, residual);
  }
  out.explained = 1 - left.squaredNorm() / data.squaredNorm();
  return out;
}

}  // namespace percuss::identify
