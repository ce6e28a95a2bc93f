#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "core/error.hpp"
#include "identify/shapes/mac.hpp"

namespace percuss::python {
namespace {

namespace py = pybind11;
using Shapes = py::array_t<Complex, py::array::c_style | py::array::forcecast>;

identify::ShapeValues shape_at(const Shapes& shapes, py::ssize_t mode) {
  identify::ShapeValues out;
  for (py::ssize_t p = 0; p < shapes.shape(1); ++p) out.value.push_back(shapes.at(mode, p));
  out.std.assign(out.value.size(), 0);
  return out;
}

py::array_t<double> mac_between(const Shapes& a, const Shapes& b) {
  if (a.ndim() != 2 || b.ndim() != 2 || a.shape(1) != b.shape(1))
    throw InputError("the shapes have different places", "mac", "give two arrays (modes, places) of the same places");
  py::array_t<double> out({a.shape(0), b.shape(0)});
  for (py::ssize_t i = 0; i < a.shape(0); ++i) {
    for (py::ssize_t j = 0; j < b.shape(0); ++j)
      out.mutable_at(i, j) = identify::mac(shape_at(a, i), shape_at(b, j)).value;
  }
  return out;
}

}  // namespace

void bind_numbers(py::module_& module) { module.def("mac", &mac_between); }

}  // namespace percuss::python
