#include "core/math/assignment.hpp"

#include <limits>

namespace percuss {
inline namespace core {
namespace {

using Eigen::Index;

// Successive shortest paths with potentials. Row and column 0 are auxiliary; columns beyond the last are gaps.
class Assignment {
 public:
  Assignment(const Eigen::MatrixXd& cost, double gap)
      : cost_(cost),
        gap_(gap),
        columns_(static_cast<std::size_t>(cost.cols() + cost.rows())),
        row_of_(columns_ + 1),
        before_(columns_ + 1),
        row_potential_(static_cast<std::size_t>(cost.rows()) + 1),
        column_potential_(columns_ + 1) {}

  void add_row(std::size_t row) {
    row_of_[0] = row;
    std::vector<double> distance(columns_ + 1, std::numeric_limits<double>::infinity());
    std::vector<char> used(columns_ + 1, 0);
    std::size_t column = 0;
    do {
      used[column] = 1;
      column = next_column(column, distance, used);
    } while (row_of_[column] != 0);
    while (column != 0) {
      row_of_[column] = row_of_[before_[column]];
      column = before_[column];
    }
  }

  std::size_t row_of(std::size_t column) const { return row_of_[column]; }

 private:
  double cost(std::size_t row, std::size_t column) const {
    const auto c = static_cast<Index>(column - 1);
    return c < cost_.cols() ? cost_(static_cast<Index>(row - 1), c) : gap_;
  }

  // Extends the tree of shortest paths by the nearest column.
  std::size_t next_column(std::size_t from, std::vector<double>& distance, const std::vector<char>& used) {
    const std::size_t row = row_of_[from];
    double delta = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t j = 1; j <= columns_; ++j) {
      if (used[j]) continue;
      const double reduced = cost(row, j) - row_potential_[row] - column_potential_[j];
      if (reduced < distance[j]) {
        distance[j] = reduced;
        before_[j] = from;
      }
      if (distance[j] < delta) {
        delta = distance[j];
        nearest = j;
      }
    }
    for (std::size_t j = 0; j <= columns_; ++j) {
      if (used[j]) {
        row_potential_[row_of_[j]] += delta;
        column_potential_[j] -= delta;
      } else {
        distance[j] -= delta;
      }
    }
    return nearest;
  }

  const Eigen::MatrixXd& cost_;
  double gap_;
  std::size_t columns_;
  std::vector<std::size_t> row_of_, before_;  // [columns]; row 0: free
  std::vector<double> row_potential_, column_potential_;
};

}  // namespace

std::vector<std::optional<std::size_t>> assign_rows(const Eigen::MatrixXd& cost, double gap) {
  const auto rows = static_cast<std::size_t>(cost.rows()), columns = static_cast<std::size_t>(cost.cols());
  std::vector<std::optional<std::size_t>> partner(rows);
  Assignment assignment(cost, gap);
  for (std::size_t row = 1; row <= rows; ++row) assignment.add_row(row);
  for (std::size_t column = 1; column <= columns; ++column) {
    const std::size_t row = assignment.row_of(column);
    if (row != 0 && cost(static_cast<Index>(row - 1), static_cast<Index>(column - 1)) < gap)
      partner[row - 1] = column - 1;
  }
  return partner;
}

}  // namespace core
}  // namespace percuss
