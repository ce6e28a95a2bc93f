#include "acquire/formats/uff/uff_row_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>

#include "acquire/formats/uff/uff_directions.hpp"
#include "acquire/record/point_number.hpp"

namespace percuss::acquire {
namespace {

// The place and direction of the hammer: the reference of a response, completed by the force's own.
UffDof struck_place(const UffFunction& force, const UffFunction& response) {
  if (response.reference.node == 0) return force.response;
  UffDof out = response.reference;
  if (out.direction == 0 && out.node == force.response.node) out.direction = force.response.direction;
  return out;
}

UffDof struck_place(const UffRow& row) { return struck_place(*row.front(), *row.back()); }

// The node and unsigned direction of each row's force.
std::set<std::pair<int, int>> struck_in(const std::vector<UffRow>& rows) {
  std::set<std::pair<int, int>> out;
  for (const UffRow& row : rows) {
    const UffDof at = struck_place(row);
    out.emplace(at.node, std::abs(at.direction));
  }
  return out;
}

// The point of a row: the node of a roving sensor. Otherwise the struck point: the reference node, else the node of the
// force.
int point_of_row(const UffRow& row, bool sensor_roves, const UffStruckPoints& points, const FileBytes& file) {
  const int offset = uff_annotation(*row.front()).node_offset;
  const UffDof struck = struck_place(row);
  // Node 0 means that no node is stated: the row then belongs to the first point.
  const int place = sensor_roves ? row.back()->response.node : struck.node == 0 ? offset : struck.node;
  const std::int64_t point = (sensor_roves ? 0 : points.point(struck) - struck.node) + place - offset;
  require_point_number(place - offset, uff_location(file, row.front()->at));
  require_point_number(point, uff_location(file, row.front()->at));
  return static_cast<int>(point);
}

// Adds the responses of a row that were measured at the struck place and in the struck direction.
void add_driving_places(const UffRow& row, int point, std::vector<DrivingPlace>& driving) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    const DrivingPlace at{point, i};
    const bool known = std::find(driving.begin(), driving.end(), at) != driving.end();
    if (!known && same_place(row[i]->response, struck_place(*row.front(), *row[i]))) driving.push_back(at);
  }
}

// Whether one place was struck in one direction, and the sensors moved from row to row, all to the same node.
bool roving_sensors(const std::vector<UffRow>& rows, const std::set<std::pair<int, int>>& struck) {
  std::set<int> sensed;
  for (const UffRow& row : rows) {
    if (row.size() < 2) return false;
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (row[i]->response.node != row[1]->response.node) return false;
    }
    sensed.insert(row[1]->response.node);
  }
  return sensed.size() > 1 && struck.size() == 1;
}

// Requires that each sensor stays at its node in all rows, if one place was struck and the sensors did not rove. All
// rows then belong to one point, at which a channel has only one place.
void require_fixed_sensors(const std::vector<UffRow>& rows, const std::string& file) {
  const UffRow& first = rows.front();
  for (std::size_t r = 1; r < rows.size(); ++r) {
    for (std::size_t i = 1; i < first.size(); ++i) {
      const int before = first[i]->response.node, now = rows[r][i]->response.node;
      if (before == now || before == 0 || now == 0) continue;
      throw InputError(
          fmt::format("response {} is at node {} in hit 1 and at node {} in hit {}", i, before, now, r + 1), file,
          "export the FRFs (function type 4): their response nodes are the points");
    }
  }
}

// Adds the places and directions of the struck points or of the roving sensors, as the file states them.
void add_motions(const UffContents& contents, const UffRow& row, int point, int offset, SignalTable& table) {
  if (!table.sensor_roves) {
    const UffDof struck = struck_place(row);
    const int place = struck.node == 0 ? 0 : struck.node - offset;
    return add_uff_motion(contents, struck, point, 0, place, table.motions);
  }
  for (std::size_t i = 1; i < row.size(); ++i)
    add_uff_motion(contents, row[i]->response, point, i, row[i]->response.node - offset, table.motions);
}

}  // namespace

void add_uff_rows(const std::vector<UffRow>& rows, const UffContents& contents, const FileBytes& file,
                  SignalTable& table) {
  const UffAnnotation stated = uff_annotation(*rows.front().front());
  const auto struck = struck_in(rows);
  const UffStruckPoints points(struck, contents);
  table.sensor_roves = roving_sensors(rows, struck);
  if (table.sensor_roves) {
    for (TableSignal& signal : table.signals) signal.axis.reset();
  } else if (struck.size() == 1) {
    require_fixed_sensors(rows, input_name(file.path));
  }
  if (points.several_per_node()) table.notes.push_back(information(points.note()));
  for (const UffRow& row : rows) {
    const int point = point_of_row(row, table.sensor_roves, points, file);
    table.rows.push_back(
        {.samples = row.front()->count, .point = point, .run = stated.by_percuss ? row.front()->load_case : 0});
    add_driving_places(row, point, table.driving);
    if (!stated.by_percuss) add_motions(contents, row, point, stated.node_offset, table);
  }
}

double uff_sign_in_row(const UffRow& row, const SignalRoles& roles, std::size_t signal) {
  const UffFunction& response = *row[signal];
  return uff_sign(response, roles.has_force ? struck_place(*row[roles.force], response) : UffDof{});
}

void note_uff_signs(const std::vector<UffRow>& rows, const SignalRoles& roles, std::vector<Message>& notes) {
  std::size_t changed = 0;
  for (const UffRow& row : rows) {
    for (const std::size_t signal : roles.accel) changed += uff_sign_in_row(row, roles, signal) < 0 ? 1U : 0U;
  }
  if (changed > 0) notes.push_back(information(uff_sign_note(changed, rows.size() * roles.accel.size(), "responses")));
}

}  // namespace percuss::acquire
