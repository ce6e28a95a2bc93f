#pragma once
#include "acquire/record/record.hpp"
#include "objects.hpp"

namespace percuss::python {

/// The description of a signal as a dictionary.
inline Object object_of(const acquire::SignalInfo& signal) {
  Dictionary out;
  out.set("name", signal.name);
  out.set("unit", signal.unit);
  out.set("to_si", signal.to_SI);
  out.set("angle_rad", signal.angle_rad);
  out.set("position_m", signal.position_m);
  return out;
}

}  // namespace percuss::python
