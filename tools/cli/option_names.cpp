#include "cli/option_names.hpp"

#include <algorithm>

namespace percuss::tools {

std::string flag_of(std::string_view id) {
  if (!id.empty() && id.front() >= 'A' && id.front() <= 'Z') return std::string(id);
  const std::size_t dot = id.rfind('.');
  std::string command(id.substr(0, dot == std::string_view::npos ? 0 : dot));
  std::string option(dot == std::string_view::npos ? id : id.substr(dot + 1));
  std::replace(command.begin(), command.end(), '.', ' ');
  std::replace(option.begin(), option.end(), '_', '-');
  return command.empty() ? "--" + option : "percuss " + command + " --" + option;
}

OptionId option_id(std::string_view flag) {
  flag.remove_prefix(std::min(flag.find_first_not_of('-'), flag.size()));
  std::string id(flag);
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
}

}  // namespace percuss::tools
