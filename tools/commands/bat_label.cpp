#include "commands/bat_label.hpp"

#include "cli/option_error.hpp"

namespace percuss::tools {

std::optional<report::BatLabel> bat_label(const std::string& id, const std::vector<std::string>& properties) {
  if (id.empty() && !properties.empty())
    throw OptionError({"bat"}, "is given without an id of the bat", "name the bat", {"bat_id"});
  if (id.empty()) return std::nullopt;
  report::BatLabel label{.id = id, .properties = {}};
  for (const std::string& text : properties) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
      throw OptionError::wrong_value("bat", text, "give KEY=VALUE, such as length_in=33");
    if (!label.properties.emplace(text.substr(0, equals), text.substr(equals + 1)).second)
      throw OptionError::wrong_value("bat", text, "keep one", "its key is given twice");
  }
  return label;
}

}  // namespace percuss::tools
