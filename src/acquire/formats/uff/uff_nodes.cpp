#include "acquire/formats/uff/uff_nodes.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

enum class System { cartesian = 0, cylindrical = 1, spherical = 2 };

// A coordinate system: origin and axes (columns) in its reference system.
struct Frame {
  System kind = System::cartesian;
  int refers_to = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

class NodeReader {
 public:
  NodeReader(const FileBytes& file, double length_factor) : file_(file), length_factor_(length_factor) {}

  // Set 18: number, kind, reference; name; origin and a point on +x; a point on the +xz plane.
  void read_frames(const UffSet& set) {
    std::string_view rest = set.text;
    while (!rest.empty()) {
      Fields head = next(rest);
      const int number = whole_number(head, 10), kind = whole_number(head, 10), reference = whole_number(head, 10);
      take_uff_line(rest);
      Fields first = next(rest);
      Frame frame{.kind = static_cast<System>(kind), .refers_to = reference};
      frame.origin = vector(first, 13);
      const Eigen::Vector3d x = vector(first, 13) - frame.origin;
      Fields second = next(rest);
      const Eigen::Vector3d xz = vector(second, 13) - frame.origin, y = xz.cross(x);
      if (kind < 0 || kind > 2 || !(y.norm() > 0)) fail(18, head.line, "a coordinate system without directions");
      frame.axes.col(0) = x.normalized();
      frame.axes.col(1) = y.normalized();
      frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));
      frames_[number] = frame;
    }
  }

  // Set 2420: number of the part; its name. Then for each system: label, kind and colour; its name; four lines of
  // numbers (three of the rotation, one of the origin). Only systems that equal the global one are understood.
  void read_other_frames(const UffSet& set) {
    std::string_view rest = set.text;
    take_uff_line(rest);
    take_uff_line(rest);
    while (!rest.empty()) {
      Fields head = next(rest);
      if (head.cells.blank()) continue;
      const auto label = head.cells.integer(10), kind = head.cells.integer(10);
      take_uff_line(rest);
      bool global = label && kind && *kind == 0;
      for (int row = 0; row < 4; ++row) {
        Fields numbers = next(rest);
        for (int column = 0; column < 3; ++column)
          global = numbers.cells.number(25) == std::optional(row == column ? 1.0 : 0.0) && global;
      }
      if (!label) unlabelled_2420_ = true;
      if (label && global) global_2420_.insert(*label);
      if (label && !global) unread_2420_.insert(*label);
    }
  }

  // Set 15: a node per line. Set 2411: its coordinates on a second line.
  void read_nodes(const UffSet& set, UffNodes& out) {
    std::string_view rest = set.text;
    while (!rest.empty()) {
      Fields fields = next(rest);
      if (fields.cells.blank()) continue;
      const int label = whole_number(fields, 10), system = whole_number(fields, 10);
      const int displacements = whole_number(fields, 10);
      whole_number(fields, 10);
      Eigen::Vector3d at;
      if (set.number == 15) {
        at = vector(fields, 13);
      } else {
        if (rest.empty()) fail(set.number, fields.line, "a node without coordinates");
        Fields second = next(rest);
        at = vector(second, 25);
      }
      if (in_other_frame(system)) {
        ++out.left_out;
        continue;
      }
      at = global(at, system, fields.line, set.number);
      const std::optional<UffAxes> axes = axes_at(at, displacements);
      at /= length_factor_;
      if (!at.allFinite()) fail(set.number, fields.line, "coordinates that are not finite");
      out.nodes_m[label] = {at.x(), at.y(), at.z()};
      out.axes.erase(label);
      if (!is_global(displacements)) out.axes[label] = axes;
    }
  }

 private:
  bool in_other_frame(int system) const {
    if (frames_.contains(system)) return false;
    return unread_2420_.contains(system) || (unlabelled_2420_ && system != 0);
  }

  // 0 is the global system; so is 1 unless the file defines it.
  bool is_global(int system) const {
    if (frames_.contains(system) || in_other_frame(system)) return false;
    return (system >= 0 && system <= 1) || global_2420_.contains(system);
  }

  // The directions 1, 2 and 3 of a system at a place in global coordinates: x, y, z; r, θ, z; or r, θ, φ. Nothing where
  // the system is not known, or on its axis.
  std::optional<UffAxes> axes_at(const Eigen::Vector3d& at, int system) const {
    constexpr int kMaxNested = 16;
    const auto leaf = frames_.find(system);
    if (leaf == frames_.end()) return std::nullopt;
    Eigen::Matrix3d turn = leaf->second.axes;
    Eigen::Vector3d origin = leaf->second.origin;
    int reference = leaf->second.refers_to;
    for (int depth = 0; reference != system && !is_global(reference); ++depth) {
      const auto frame = frames_.find(reference);
      if (frame == frames_.end() || frame->second.kind != System::cartesian || depth == kMaxNested) return std::nullopt;
      turn = frame->second.axes * turn;
      origin = frame->second.origin + frame->second.axes * origin;
      system = reference;
      reference = frame->second.refers_to;
    }
    const Eigen::Vector3d local = turn.transpose() * (at - origin);
    const double across = std::hypot(local.x(), local.y()), distance = local.norm();
    if (leaf->second.kind != System::cartesian) {
      if (!(across > 1e-9 * (1 + distance))) return std::nullopt;
      const double cos_around = local.x() / across, sin_around = local.y() / across;
      Eigen::Matrix3d own;
      if (leaf->second.kind == System::cylindrical) {
        own << cos_around, -sin_around, 0, sin_around, cos_around, 0, 0, 0, 1;
      } else {
        const double sin_down = across / distance, cos_down = local.z() / distance;
        own << sin_down * cos_around, cos_down * cos_around, -sin_around,  //
            sin_down * sin_around, cos_down * sin_around, cos_around,      //
            cos_down, -sin_down, 0;
      }
      turn = turn * own;
    }
    UffAxes out{};
    for (int direction = 0; direction < 3; ++direction) {
      for (int i = 0; i < 3; ++i)
        out.at(static_cast<std::size_t>(direction)).at(static_cast<std::size_t>(i)) = turn(i, direction);
    }
    return out;
  }

  struct Fields {
    std::string_view line;
    UffFields cells;
  };

  static Fields next(std::string_view& rest) {
    const std::string_view line = take_uff_line(rest);
    return {line, UffFields(line)};
  }

  [[noreturn]] void fail(int set, std::string_view at, const char* problem) const {
    const std::string what = set == 0 ? "nodes or coordinate systems" : fmt::format("data set {}", set);
    throw InputError(fmt::format("{}: {}", what, problem), uff_location(file_, at), "export the file again");
  }

  int whole_number(Fields& fields, std::size_t width) const {
    const auto value = fields.cells.integer(width);
    if (!value || std::abs(*value) > std::numeric_limits<int>::max() / 2)
      fail(0, fields.line, "cannot read a whole number");
    return static_cast<int>(*value);
  }

  Eigen::Vector3d vector(Fields& fields, std::size_t width) const {
    Eigen::Vector3d out;
    for (double& x : out) {
      const auto value = fields.cells.number(width);
      if (!value) fail(0, fields.line, "cannot read a coordinate");
      x = *value;
    }
    return out;
  }

  static Eigen::Vector3d cartesian(System kind, const Eigen::Vector3d& at) {
    const double first = at.y() * kDegree_rad, second = at.z() * kDegree_rad;
    if (kind == System::cylindrical) return {at.x() * std::cos(first), at.x() * std::sin(first), at.z()};
    if (kind == System::spherical) {
      return {at.x() * std::sin(first) * std::cos(second), at.x() * std::sin(first) * std::sin(second),
              at.x() * std::cos(first)};
    }
    return at;
  }

  // Systems may refer to one another, but not in circles.
  Eigen::Vector3d global(Eigen::Vector3d at, int system, std::string_view line, int set) const {
    constexpr int kMaxNested = 16;
    for (int depth = 0; depth < kMaxNested; ++depth) {
      const auto frame = frames_.find(system);
      if (frame == frames_.end()) {
        // 0 is the global system; so is 1 unless the file defines it.
        if (system <= 1 || global_2420_.contains(system)) return at;
        fail(set, line, "a node in an undefined coordinate system");
      }
      at = frame->second.origin + frame->second.axes * cartesian(frame->second.kind, at);
      if (frame->second.refers_to == system) return at;
      system = frame->second.refers_to;
    }
    fail(set, line, "coordinate systems that refer to one another");
  }

  const FileBytes& file_;
  double length_factor_;
  std::map<int, Frame> frames_;
  std::set<std::int64_t> unread_2420_, global_2420_;  // labels of the systems of set 2420
  bool unlabelled_2420_ = false;
};

}  // namespace

UffNodes read_uff_nodes(const std::vector<UffSet>& sets, const FileBytes& file, double length_factor) {
  NodeReader reader(file, length_factor);
  for (const UffSet& set : sets) {
    if (set.number == 18 && !set.binary) reader.read_frames(set);
    if (set.number == 2420 && !set.binary) reader.read_other_frames(set);
  }
  UffNodes out;
  for (const UffSet& set : sets) {
    if ((set.number == 15 || set.number == 2411) && !set.binary) reader.read_nodes(set, out);
  }
  return out;
}

}  // namespace percuss::acquire
