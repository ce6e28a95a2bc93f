#include "identify/start/cmif.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "core/math/decompositions.hpp"

namespace percuss::identify {

Eigen::MatrixXd cmif(const FrfDataset& set, const acquire::LineRange& band) {
  assert(band.first >= set.lines.first && band.first + band.count <= set.lines.first + set.lines.count);
  std::set<std::size_t> sensor_channels;
  for (const FrfChannel& channel : set.channels) sensor_channels.insert(channel.channel);
  const auto rows = static_cast<Eigen::Index>(set.points.size()),
             columns = static_cast<Eigen::Index>(sensor_channels.size());
  Eigen::MatrixXd out(static_cast<Eigen::Index>(band.count), std::min(rows, columns));
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    Eigen::MatrixXcd frf = Eigen::MatrixXcd::Zero(rows, columns);
    for (const FrfChannel& channel : set.channels) {
      const auto column = std::distance(sensor_channels.begin(), sensor_channels.find(channel.channel));
      frf(static_cast<Eigen::Index>(channel.point), column) =
          channel.frf[band.first - set.lines.first + static_cast<std::size_t>(k)];
    }
    out.row(k) = singular_values(frf).transpose();
  }
  return out;
}

}  // namespace percuss::identify
