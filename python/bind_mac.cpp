#include "bindings.hpp"
#include "core/error.hpp"
#include "identify/shapes/mac.hpp"
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

}  // namespace percuss::python
