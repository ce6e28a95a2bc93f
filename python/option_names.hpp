#pragma once
#include <string>
#include <string_view>

namespace percuss::python {

/// An option's identifier as Python writes it: "band=" for "band", "percuss.example('survey')" for "survey.example".
std::string option_in_python(std::string_view id);

}  // namespace percuss::python
