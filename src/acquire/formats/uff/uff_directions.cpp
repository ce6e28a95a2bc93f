#include "acquire/formats/uff/uff_directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace percuss::acquire {
namespace {

const char* direction_name(int direction) {
  constexpr std::array names{"no stated direction", "x", "y", "z", "rotation about x", "rotation about y",
                             "rotation about z"};
  const auto index = static_cast<std::size_t>(direction);
  return index < names.size() ? names.at(index) : "another direction";
}

}  // namespace

double uff_sign(const UffDof& dof) { return dof.direction < 0 ? -1 : 1; }

double uff_sign(const UffFunction& response, const UffDof& struck) {
  const bool scalar = response.ordinate.quantity == Uff58::pressure;
  return (scalar ? 1 : uff_sign(response.response)) * uff_sign(struck);
}

std::optional<Direction> uff_axis(const UffContents& contents, const UffDof& dof) {
  const int direction = std::abs(dof.direction);
  if (direction < 1 || direction > 3) return std::nullopt;
  const auto index = static_cast<std::size_t>(direction - 1);
  const auto own = contents.axes.find(dof.node);
  if (own != contents.axes.end()) return own->second ? std::optional((*own->second).at(index)) : std::nullopt;
  Direction out{};
  out.at(index) = 1;
  return out;
}

UffStruckPoints::UffStruckPoints(const std::set<std::pair<int, int>>& struck, const UffContents& contents) {
  std::set<int> nodes, directions;
  int highest = contents.nodes_m.empty() ? 0 : contents.nodes_m.rbegin()->first;
  for (const auto& [node, direction] : struck) {
    nodes.insert(node);
    directions.insert(direction);
    highest = std::max(highest, node);
  }
  if (nodes.size() == struck.size()) return;
  directions_.assign(directions.begin(), directions.end());
  for (step_ = 10; step_ <= highest;) step_ *= 10;
}

std::int64_t UffStruckPoints::point(const UffDof& struck) const {
  if (!several_per_node()) return struck.node;
  const auto found = std::find(directions_.begin(), directions_.end(), std::abs(struck.direction));
  return struck.node + step_ * (found - directions_.begin());
}

std::string UffStruckPoints::note() const {
  std::string out = "a node was struck in several directions, each of which is a point: ";
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const std::string number = i == 0 ? "n" : fmt::format("{} + n", step_ * static_cast<std::int64_t>(i));
    out += fmt::format("{}{} is node n{}{}", i == 0 ? "point " : ", ", number, directions_[i] == 0 ? " with " : " in ",
                       direction_name(directions_[i]));
  }
  return out;
}

void add_uff_motion(const UffContents& contents, const UffDof& dof, int point, std::size_t channel, int place,
                    std::vector<PointMotion>& motions) {
  const auto axis = uff_axis(contents, dof);
  if (axis || place != point) motions.push_back({.point = point, .channel = channel, .place = place, .along = axis});
}

std::string uff_sign_note(std::size_t changed, std::size_t all, const char* what) {
  return fmt::format("the sign of {} of {} {} is changed, because one of their directions is −x, −y or −z", changed,
                     all, what);
}

}  // namespace percuss::acquire
