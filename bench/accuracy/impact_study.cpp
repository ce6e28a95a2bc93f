#include "impact_study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fft_read_baseline.hpp"
#include "impact_truth.hpp"

namespace percuss::accuracy {
namespace {

constexpr double kFloor = 1e-13;  // errors below it are rounding

struct Variant {
  model::ImpactMethod method;
  double step_s;  // 0: chosen by the method
};

const char* method_name(model::ImpactMethod method) {
  return method == model::ImpactMethod::modal ? "modal" : "small-increment";
}

std::string step_label(const Variant& variant) {
  if (variant.step_s > 0) return fmt::format("{:g} µs", 1e6 * variant.step_s);
  return variant.method == model::ImpactMethod::modal ? "controlled" : "10 µs";
}

Case measured_impacts(std::string value, const model::Impact& impact, const std::vector<Variant>& variants,
                      const TimingOptions& timing) {
  const double truth = exact_cor(impact);
  std::vector<std::function<void()>> works{[] { transform_once(kUnit_samples); }};
  std::vector<Figure> figures;
  for (const Variant& variant : variants) {
    const model::ImpactOptions options{.method = variant.method, .step_s = variant.step_s};
    const double error = std::max(kFloor, std::abs(model::simulate_impact(impact, options).cor - truth));
    figures.push_back(
        {.method = method_name(variant.method), .label = step_label(variant), .error = error, .more = {}});
    works.emplace_back([&impact, options] { model::simulate_impact(impact, options); });
  }
  const std::vector<double> best_s = best_interleaved_s(works, timing);
  for (std::size_t i = 0; i < figures.size(); ++i) figures[i].time_ratio = best_s[1 + i] / best_s[0];
  mark_pareto_front(figures);
  return {std::move(value), std::move(figures)};
}

std::vector<Variant> steps(Extent extent) {
  std::vector<Variant> variants{{model::ImpactMethod::modal, 0}};
  for (const double step_s : {64e-6, 16e-6, 2e-6, 0.25e-6}) {
    variants.push_back({model::ImpactMethod::modal, step_s});
    variants.push_back({model::ImpactMethod::small_increment, step_s});
    if (extent == Extent::quick) break;
  }
  return variants;
}

}  // namespace

TaskFigures study_impact(Extent extent, const TimingOptions& timing) {
  TaskFigures task{.name = "impact",
                   .title = "Ball on a beam",
                   .error = "error of the restitution",
                   .time = fmt::format("one bare transform of {} values", kUnit_samples),
                   .more = {},
                   .sweeps = {{"step", {}}, {"modes", {}}}};
  task.sweeps[0].cases.push_back(measured_impacts("10 modes", {}, steps(extent), timing));
  const std::vector<Variant> defaults{{model::ImpactMethod::modal, 0}, {model::ImpactMethod::small_increment, 0}};
  for (const std::size_t modes : {1U, 3U, 10U, 30U, 60U}) {
    model::Impact impact;
    impact.modes = modes;
    task.sweeps[1].cases.push_back(
        measured_impacts(fmt::format("{} mode{}", modes, modes == 1 ? "" : "s"), impact, defaults, timing));
    if (extent == Extent::quick) break;
  }
  return task;
}

}  // namespace percuss::accuracy
