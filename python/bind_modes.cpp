#include <cmath>

#include "bindings.hpp"

namespace percuss::python {

Object modes_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = ResultClass::of(self);
  const pipeline::Analysis& analysis = *analysis_of(held, static_cast<std::size_t>(arguments[0].whole()));
  const pipeline::Survey* const survey = held->outcome.survey.get();
  const auto modes = compute(held, [&] { return survey == nullptr ? analysis.modes() : survey->modes(); });
  const std::size_t frf_channels = modes.empty() ? 0 : modes.front().residues.size();
  const auto column = [&](const auto& number) {
    std::vector<double> values;
    values.reserve(modes.size());
    for (const identify::Mode& mode : modes) values.push_back(number(mode));
    return array_of(std::move(values));
  };
  std::vector<Complex> residues;
  std::vector<double> residue_std;
  std::vector<Object> places;
  for (const identify::Mode& mode : modes) {
    for (std::size_t c = 0; c < frf_channels; ++c) {
      const identify::Residue& residue = mode.residues.at(c);
      residues.push_back(residue.value);
      residue_std.push_back(
          std::hypot(residue.std, residue.relative_std * std::abs(residue.value)));  // as the document
      if (&mode == &modes.front()) places.push_back(tuple_of(residue.point, residue.channel));
    }
  }
  const std::vector<std::size_t> shape{modes.size(), frf_channels};
  Dictionary out;
  out.set("frequency_hz", column([](const identify::Mode& m) { return m.pole.freq_Hz; }));
  out.set("frequency_std_hz", column([](const identify::Mode& m) { return m.freq_std_Hz; }));
  out.set("damping_ratio", column([](const identify::Mode& m) { return m.pole.damping_ratio; }));
  out.set("damping_ratio_std", column([](const identify::Mode& m) { return m.damping_std; }));
  out.set("residues", array_of(std::move(residues), shape));
  out.set("residues_std", array_of(std::move(residue_std), shape));
  out.set("places", places);
  return out;
}

Object residual_terms_of(PyObject* self, const Arguments& arguments) {
  const SharedResult& held = ResultClass::of(self);
  const pipeline::Analysis& analysis = *analysis_of(held, static_cast<std::size_t>(arguments[0].whole()));
  const auto& fit = compute(
      held, [&]() -> const auto& { return analysis.fit(); });
  const std::vector<int> points = compute(held, [&] { return analysis.frf_points(); });
  std::vector<Complex> lower, upper, upper_4, upper_6;
  std::vector<double> frac;
  std::vector<Object> places;
  for (const pipeline::FrfFit& frf : fit.frfs) {
    lower.push_back(frf.lower);
    upper.push_back(frf.upper);
    upper_4.push_back(frf.upper4);
    upper_6.push_back(frf.upper6);
    frac.push_back(frf.frac);
    places.push_back(tuple_of(points.at(frf.point), frf.channel));
  }
  Dictionary out;
  out.set("lower", array_of(std::move(lower)));
  out.set("upper", array_of(std::move(upper)));
  out.set("upper_4", array_of(std::move(upper_4)));
  out.set("upper_6", array_of(std::move(upper_6)));
  out.set("frac", array_of(std::move(frac)));
  out.set("places", places);
  return out;
}

}  // namespace percuss::python
