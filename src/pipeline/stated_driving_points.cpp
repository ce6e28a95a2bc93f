#include "pipeline/stated_driving_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "core/error.hpp"

namespace percuss::pipeline {
namespace {

// One meaning of the numbers: the record's point for each number.
struct NumberMeaning {
  enum class Kind { names, geometry, record } kind;
  std::map<int, int> point_of;
};

std::vector<NumberMeaning> meanings_of(const PointNumbering& numbering) {
  using enum NumberMeaning::Kind;
  std::vector<NumberMeaning> out;
  if (const auto numbers = numbers_in_names(numbering.files, numbering.geometry)) {
    NumberMeaning named{.kind = names, .point_of = {}};
    for (std::size_t i = 0; i < numbers->size(); ++i) named.point_of[(*numbers)[i]] = static_cast<int>(i);
    out.push_back(std::move(named));
  }
  NumberMeaning own{.kind = record, .point_of = {}}, from_one{.kind = geometry, .point_of = {}};
  for (const int point : numbering.points) {
    own.point_of[point] = point;
    from_one.point_of[point + 1] = point;
  }
  if (numbering.files.empty()) out.push_back(own);
  if (numbering.geometry_from_one) out.push_back(std::move(from_one));
  if (!numbering.files.empty()) out.push_back(std::move(own));
  return out;
}

bool knows_all(const NumberMeaning& meaning, const std::vector<StatedDrivingPoint>& stated) {
  return std::all_of(stated.begin(), stated.end(),
                     [&](const auto& at) { return !at.file.empty() || meaning.point_of.contains(at.point); });
}

// The point's file where each file is one point, else its numbers.
std::string point_text(int point, const PointNumbering& numbering) {
  if (!numbering.files.empty()) return short_file_name(numbering.files.at(static_cast<std::size_t>(point)));
  return numbering.geometry_from_one ? fmt::format("point {} of the record, {} of the geometry", point, point + 1)
                                     : fmt::format("point {} of the record", point);
}

Warning several_meanings(const StatedDrivingPoint& at, const NumberMeaning& chosen,
                         const std::vector<const NumberMeaning*>& others, const PointNumbering& numbering) {
  using enum NumberMeaning::Kind;
  const char* const why = chosen.kind == names      ? ", by the numbers in the files' names"
                          : chosen.kind == geometry ? ", by the numbers of the geometry"
                                                    : "";
  std::string message = fmt::format("driving point {} is taken as {}{}", at.point,
                                    point_text(chosen.point_of.at(at.point), numbering), why);
  for (const NumberMeaning* other : others) {
    message +=
        fmt::format("; point {} of {} is {}", at.point,
                    other->kind == geometry ? "the geometry, which counts from 1," : "the results, which count from 0,",
                    point_text(other->point_of.at(at.point), numbering));
  }
  message += ". If that one is meant, modal masses and the scale of the shapes are wrong";
  Warning warning{"driving_point_numbers", std::move(message), {"driving_point"}};
  if (numbering.files.empty()) return with_remedy(std::move(warning), "number the geometry as the record to be sure");
  const std::string& path = numbering.files.at(static_cast<std::size_t>(chosen.point_of.at(at.point)));
  return with_remedy(std::move(warning),
                     fmt::format("name the file to be sure: {}:{}", short_file_name(path), at.channel));
}

int point_of_file(const std::string& stated, const PointNumbering& numbering, const std::string& source) {
  const auto refuse = [&](const std::string& problem, const std::string& remedy) {
    return InputError(problem, source, remedy, {"driving_point"});
  };
  const std::string shown = one_line(stated, kMaxNameBytes);
  if (numbering.files.empty())
    throw refuse(fmt::format("no file \"{}\" is a point of its own", shown), "give the number of the point");
  std::vector<int> found;
  for (std::size_t i = 0; i < numbering.files.size(); ++i) {
    const std::filesystem::path path(numbering.files[i]);
    if (stated == path.string() || stated == path.filename().string() || stated == path.stem().string())
      found.push_back(static_cast<int>(i));
  }
  if (found.empty())
    throw refuse(fmt::format("no point has the file \"{}\"", shown), "give the name of a file, or the point's number");
  if (found.size() > 1)
    throw refuse(fmt::format("{} points have a file \"{}\"", found.size(), shown), "give the path of the file");
  return found.front();
}

}  // namespace

DrivingPoints driving_points_of(const std::vector<StatedDrivingPoint>& stated, const PointNumbering& numbering,
                                const std::string& source) {
  const std::vector<NumberMeaning> meanings = meanings_of(numbering);
  const auto chosen = std::find_if(meanings.begin(), meanings.end(),
                                   [&](const NumberMeaning& meaning) { return knows_all(meaning, stated); });
  DrivingPoints out;
  for (const StatedDrivingPoint& at : stated) {
    int point = 0;
    if (!at.file.empty()) {
      point = point_of_file(at.file, numbering, source);
    } else if (chosen != meanings.end()) {
      point = chosen->point_of.at(at.point);
    } else if (!meanings.front().point_of.contains(at.point)) {
      const std::map<int, int>& numbers = meanings.front().point_of;
      throw InputError(fmt::format("point {} was not measured", at.point), source,
                       fmt::format("choose from points {} to {}", numbers.begin()->first, numbers.rbegin()->first),
                       {"driving_point"});
    }
    out.points.push_back({.point = static_cast<std::size_t>(point), .channel = at.channel});
  }
  // One warning is enough: the numbers of all points have the same meaning.
  for (const StatedDrivingPoint& at : stated) {
    if (!at.file.empty() || !out.warnings.empty()) continue;
    std::vector<const NumberMeaning*> others;
    for (const NumberMeaning& meaning : meanings) {
      const bool differs = &meaning != &*chosen && knows_all(meaning, stated) &&
                           meaning.point_of.at(at.point) != chosen->point_of.at(at.point);
      if (differs) others.push_back(&meaning);
    }
    if (!others.empty()) out.warnings.push_back(several_meanings(at, *chosen, others, numbering));
  }
  return out;
}

}  // namespace percuss::pipeline
