#include "option_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "cli/option_names.hpp"

namespace percuss::python {
namespace {

using Names = std::pair<std::string_view, std::string_view>;

// Options of the command line that have another form in Python.
constexpr std::array kCalls{Names{"force", "force=True"}, Names{"json", "to_dict()"}, Names{"output", "save()"},
                            Names{"synth.list", "percuss.presets()"}};

// Commands whose function has another name, or is in a module of the package.
constexpr std::array kFunctions{Names{"metrics", "metrics.performance"}, Names{"certify", "metrics.certify"},
                                Names{"abi", "metrics.abi"}, Names{"study", "metrics.study"}};

template <std::size_t count>
std::string renamed(const std::array<Names, count>& names, std::string_view id) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const Names& one) { return one.first == id; });
  return std::string(found == names.end() ? id : found->second);
}

std::string keyword(std::string_view option) { return std::string(option) + (option == "from" ? "_=" : "="); }

std::string function_of(const std::string& command) {
  constexpr std::string_view kModel = "model.";
  return command.starts_with(kModel) ? "models." + command.substr(kModel.size()) : renamed(kFunctions, command);
}

}  // namespace

std::string option_in_python(std::string_view id) {
  if (std::string call = renamed(kCalls, id); call != id) return call;
  const std::size_t dot = id.rfind('.');
  if (dot == std::string_view::npos) {
    std::string name(id);
    const bool is_argument = name.size() > 1 && std::isupper(static_cast<unsigned char>(name[0])) != 0;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return is_argument ? name : keyword(id);
  }
  const std::string command(id.substr(0, dot));
  const std::string_view option = id.substr(dot + 1);
  if (option == "example") return "percuss.example('" + command + "')";
  if (command.starts_with("batch")) return tools::flag_of(id);  // a command of the command line only
  return "percuss." + function_of(command) + "(" + (option == "json" ? "" : keyword(option)) + ")";
}

}  // namespace percuss::python
