#pragma once
#include <functional>
#include <vector>

namespace percuss::model {

struct MaximumPoint {
  double x = 0, y = 0;
};

/// The largest value of f near the largest of its values y at x: Brent's minimisation of −f between that one's
/// neighbours, to a hundred-millionth of x's range; the largest itself where it is the first or the last, or where a
/// neighbour equals it. shapes: x ascending, y alike long, at least one.
MaximumPoint brent_maximum(const std::function<double(double)>& f, const std::vector<double>& x,
                           const std::vector<double>& y);

}  // namespace percuss::model
