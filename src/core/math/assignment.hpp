#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace percuss {
inline namespace core {

/// The partner of each row among the columns, at the least total cost (Hungarian method). No column has two rows. A
/// row without a partner costs `gap`, so that each pair costs less than `gap`.
/// shapes  cost [rows, columns], finite; result [rows].
std::vector<std::optional<std::size_t>> assign_rows(const Eigen::MatrixXd& cost, double gap);

}  // namespace core
}  // namespace percuss
