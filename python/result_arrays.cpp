#include <cmath>

#include "bindings.hpp"
#include "pipeline/survey.hpp"

namespace percuss::python {

Object stabilisation_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = ResultClass::of(self);
  const pipeline::Analysis& analysis = *analysis_of(held, static_cast<std::size_t>(arguments[0].whole()));
  const identify::Stabilisation& diagram =
      compute(held, [&]() -> const identify::Stabilisation& { return analysis.stabilisation(); });
  std::vector<double> freq_Hz, damping;
  std::vector<std::int64_t> order;
  std::vector<std::string> stability;
  for (const identify::StabilisationPole& one : diagram.poles) {
    freq_Hz.push_back(one.pole.freq_Hz);
    damping.push_back(one.pole.damping_ratio);
    order.push_back(static_cast<std::int64_t>(one.order));
    stability.emplace_back(name_of(one.stability));
  }
  Dictionary out;
  out.set("order", array_of(std::move(order)));
  out.set("frequency_hz", array_of(std::move(freq_Hz)));
  out.set("damping_ratio", array_of(std::move(damping)));
  out.set("stability", stability);
  return out;
}

Object shapes_of(PyObject* self, const Arguments& /*arguments*/) {
  const SharedResult& held = ResultClass::of(self);
  const pipeline::Survey* const survey = held->outcome.survey.get();
  if (survey == nullptr) raise_builtin(PyExc_TypeError, "only the result of a survey has shapes");
  const auto& shapes = compute(
      held, [&]() -> const auto& { return survey->shapes(); });
  const auto& macs = compute(
      held, [&]() -> const auto& { return survey->macs(); });
  const std::size_t places = shapes.empty() ? 0 : shapes.front().places.size();
  std::vector<Complex> values;
  std::vector<double> value_std, scale_std, mac, cmif;
  std::vector<std::int64_t> points, channels;
  for (const auto& shape : shapes) {
    scale_std.push_back(shape.scale_std);
    for (std::size_t p = 0; p < places; ++p) {
      const identify::ShapePlace& place = shape.places.at(p);
      values.push_back(place.value);
      const double of_scale = shape.scale_std * std::abs(place.value);
      value_std.push_back(place.sets_scale ? of_scale : std::hypot(place.std, of_scale));
      if (&shape != &shapes.front()) continue;
      points.push_back(static_cast<std::int64_t>(place.point));
      channels.push_back(static_cast<std::int64_t>(place.channel));
    }
  }
  for (const auto& row : macs) {
    for (const auto& one : row) mac.push_back(one.value);
  }
  const Eigen::MatrixXd& indicator = compute(
      held, [&]() -> const auto& { return survey->indicator(); });
  const acquire::LineRange band = compute(held, [&] { return survey->band(); });
  for (Eigen::Index i = 0; i < indicator.rows(); ++i) {
    for (Eigen::Index j = 0; j < indicator.cols(); ++j) cmif.push_back(indicator(i, j));
  }
  const auto rows = static_cast<std::size_t>(indicator.rows()), columns = static_cast<std::size_t>(indicator.cols());
  Dictionary out;
  out.set("shapes", array_of(std::move(values), {shapes.size(), places}));
  out.set("shapes_std", array_of(std::move(value_std), {shapes.size(), places}));
  out.set("scale_std", array_of(std::move(scale_std)));
  out.set("points", array_of(std::move(points)));
  out.set("channels", array_of(std::move(channels)));
  out.set("mac", array_of(std::move(mac), {macs.size(), macs.size()}));
  out.set("cmif", array_of(std::move(cmif), {rows, columns}));
  out.set("cmif_frequency_hz", array_of(acquire::frequencies_Hz(band)));
  return out;
}

}  // namespace percuss::python
