#include "pipeline/channels/mass_loading.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "pipeline/channels/robust_slope.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinPoints = 6;
constexpr double kRoundingOfFreq = 1e-9;  // relative

// Relative frequencies against squared residues over the largest, both about their medians.
struct Course {
  std::vector<double> square, freq;
};

Course course_of(const identify::Mode& mode) {
  Course course;
  for (const identify::Residue& residue : mode.residues) {
    if (!residue.own_pole) continue;
    course.square.push_back(std::norm(residue.value));
    course.freq.push_back(residue.own_pole->freq_Hz / mode.pole.freq_Hz - 1);
  }
  if (course.square.size() < kMinPoints) return {};
  const double most = *std::max_element(course.square.begin(), course.square.end());
  if (!(most > 0)) return {};
  for (double& square : course.square) square /= most;
  for (std::vector<double>* values : {&course.square, &course.freq}) {
    const double middle = median(*values);
    for (double& value : *values) value -= middle;
  }
  return course;
}

// A value at the median says nothing about the slope, and has no quotient.
Course without_middle(const Course& course) {
  Course out;
  for (std::size_t i = 0; i < course.square.size(); ++i) {
    if (course.square[i] == 0) continue;
    out.square.push_back(course.square[i]);
    out.freq.push_back(course.freq[i]);
  }
  return out;
}

}  // namespace

std::vector<MassLoading> mass_loading(const std::vector<identify::Mode>& modes) {
  std::vector<MassLoading> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Course course = without_middle(course_of(modes[m]));
    if (course.square.size() + 1 < kMinPoints) continue;
    const std::vector<double> std(course.square.size(), kRoundingOfFreq);
    const RobustSlope slope = robust_slope(course.square, course.freq, std);
    if (slope.log_chance > kMaxLogChance || std::abs(slope.slope) < kSureSlope * slope.std) continue;
    if (slope.slope > 0) return {};
    out.push_back({.mode = m, .largest_fall = -slope.slope, .std = slope.std, .points = course.square.size()});
  }
  return out;
}

}  // namespace percuss::pipeline
