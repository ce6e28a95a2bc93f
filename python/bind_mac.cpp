#include <cmath>

#include "bindings.hpp"
#include "core/error.hpp"
#include "identify/shapes/mac.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "metrics/common_places.hpp"
#include "report/json/read_document.hpp"

namespace percuss::python {
namespace {

// Shapes (modes, places).
std::vector<identify::ShapeValues> shapes_in(const Object& array) {
  const GivenArray given = given_array(array);
  const std::vector<Complex> values = copied_values<Complex>(array);
  if (given.shape.size() != 2) throw InputError("no shapes", "mac", "give two arrays (modes, places)");
  std::vector<identify::ShapeValues> shapes(given.shape[0]);
  const std::size_t places = given.shape[1];
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    for (std::size_t p = 0; p < places; ++p) shapes[mode].value.push_back(values[mode * places + p]);
    shapes[mode].std.assign(places, 0);
  }
  return shapes;
}

}  // namespace

Object mac_between(PyObject* /*module*/, const Arguments& arguments) {
  const auto a = shapes_in(arguments[0]), b = shapes_in(arguments[1]);
  std::vector<double> out;
  for (const auto& left : a) {
    for (const auto& right : b) {
      if (left.value.size() != right.value.size())
        throw InputError("the shapes have different numbers of places", "mac",
                         "give two arrays (modes, places) of the same places");
      out.push_back(identify::mac(left, right).value);
    }
  }
  return array_of(std::move(out), {a.size(), b.size()});
}

Object common_points_of(PyObject* /*module*/, const Arguments& arguments) {
  const auto a = report::parse_documents(arguments[0].text(), "a").at(0);
  const auto b = report::parse_documents(arguments[1].text(), "b").at(0);
  std::vector<Object> out;
  for (const auto& [point, matched] : metrics::common_places(a, b).of_b)
    out.push_back(tuple_of(matched.point, point, matched.sign));
  return object_of(out);
}

// Rows of point, channel, real and imaginary part and standard deviation.
Object shape_over_points(PyObject* /*module*/, const Arguments& arguments) {
  constexpr std::size_t kColumns = 5;
  const GivenArray given = given_array(arguments[0]);
  const std::vector<double> values = copied_values<double>(arguments[0]);
  const bool table = given.shape.size() == 2 && given.shape[1] == kColumns && !values.empty();
  const auto is_index = [](double number) { return number >= 0 && number <= 1e9 && std::floor(number) == number; };
  identify::Mode mode;
  for (std::size_t at = 0; table && at < values.size(); at += kColumns) {
    if (!is_index(values[at]) || !is_index(values[at + 1]))
      throw InputError("a point or channel is no index", "mac", "number points and channels from 0");
    mode.residues.push_back({.point = static_cast<std::size_t>(values[at]),
                             .channel = static_cast<std::size_t>(values[at + 1]),
                             .value = {values[at + 2], values[at + 3]},
                             .std = values[at + 4]});
  }
  std::vector<Complex> out;
  if (table) {
    for (const identify::ShapePlace& place : identify::shape_of(mode).places) out.push_back(place.value);
  }
  const std::size_t places = out.size();
  return array_of(std::move(out), {places});
}

}  // namespace percuss::python
