#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "numpy_views.hpp"
#include "pipeline/survey.hpp"

namespace percuss::python {

namespace py = pybind11;

py::dict stabilisation_of(const SharedResult& held, std::size_t test) {
  const pipeline::Analysis& analysis = *analysis_of(held, test);
  const identify::Stabilisation& diagram =
      without_gil(held, [&]() -> const identify::Stabilisation& { return analysis.stabilisation(); });
  std::vector<double> freq_Hz, damping;
  std::vector<std::int64_t> order;
  py::list stability;
  for (const identify::StabilisationPole& one : diagram.poles) {
    freq_Hz.push_back(one.pole.freq_Hz);
    damping.push_back(one.pole.damping_ratio);
    order.push_back(static_cast<std::int64_t>(one.order));
    stability.append(name_of(one.stability));
  }
  py::dict out;
  out["order"] = copy_of(std::span<const std::int64_t>(order));
  out["frequency_hz"] = copy_of(std::span<const double>(freq_Hz));
  out["damping_ratio"] = copy_of(std::span<const double>(damping));
  out["stability"] = stability;
  return out;
}

py::dict shapes_of(const SharedResult& held) {
  const pipeline::Survey* const survey = held->outcome.survey.get();
  if (survey == nullptr) throw py::type_error("only the result of a survey has shapes");
  const auto& shapes = without_gil(
      held, [&]() -> const auto& { return survey->shapes(); });
  const auto& macs = without_gil(
      held, [&]() -> const auto& { return survey->macs(); });
  const std::size_t places = shapes.empty() ? 0 : shapes.front().places.size();
  py::array_t<Complex> values({shapes.size(), places});
  py::array_t<double> value_std({shapes.size(), places});
  py::list points, channels;
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    for (std::size_t p = 0; p < places; ++p) {
      const identify::ShapePlace& place = shapes[m].places.at(p);
      values.mutable_at(m, p) = place.value;
      value_std.mutable_at(m, p) = place.std;
      if (m == 0) points.append(place.point);
      if (m == 0) channels.append(place.channel);
    }
  }
  py::array_t<double> mac({macs.size(), macs.size()});
  for (std::size_t a = 0; a < macs.size(); ++a) {
    for (std::size_t b = 0; b < macs.size(); ++b) mac.mutable_at(a, b) = macs[a][b].value;
  }
  const Eigen::MatrixXd& indicator = without_gil(
      held, [&]() -> const auto& { return survey->indicator(); });
  const acquire::LineRange band = without_gil(held, [&] { return survey->band(); });
  py::array_t<double> cmif({indicator.rows(), indicator.cols()});
  for (Eigen::Index i = 0; i < indicator.rows(); ++i) {
    for (Eigen::Index j = 0; j < indicator.cols(); ++j) cmif.mutable_at(i, j) = indicator(i, j);
  }
  const std::vector<double> freq_Hz = freq_Hz_of(band);
  py::dict out;
  out["shapes"] = read_only(values);
  out["shapes_std"] = read_only(value_std);
  out["points"] = points;
  out["channels"] = channels;
  out["mac"] = read_only(mac);
  out["cmif"] = read_only(cmif);
  out["cmif_frequency_hz"] = copy_of(std::span<const double>(freq_Hz));
  return out;
}

}  // namespace percuss::python
