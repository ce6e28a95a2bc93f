#pragma once
#include <string>
#include <string_view>

namespace percuss::acquire {

/// Refuses a JSON text in the place of a record, and says what to do with this kind of document: the command that
/// reads it, if there is one.
/// errors  InputError where the first bytes are JSON.
void refuse_json(std::string_view head, const std::string& name);

}  // namespace percuss::acquire
