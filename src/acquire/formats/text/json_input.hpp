#pragma once
#include <string>
#include <string_view>

namespace percuss::acquire {

/// Refuses a JSON text in the place of a record, and names the command that reads this kind of document.
/// errors  InputError where the first bytes are JSON.
void refuse_json(std::string_view head, const std::string& name);

}  // namespace percuss::acquire
