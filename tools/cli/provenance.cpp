#include "cli/provenance.hpp"

#include <fstream>
#include <iterator>
#include <string>

#include "acquire/channels/channel_setup.hpp"
#include "cli/shell_argument.hpp"
#include "report/text/creation_time.hpp"

namespace percuss::tools {
namespace {

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::string out = "percuss";
  std::size_t at = bytes.find('\0');  // skip the path of the program
  while (at != std::string::npos && at + 1 < bytes.size()) {
    const std::size_t end = bytes.find('\0', at + 1);
    out += ' ' + shell_quoted_argument(bytes.substr(at + 1, end - at - 1));
    at = end;
  }
  return out;
}

}  // namespace

report::Provenance provenance_now(const OutputFlags& flags) {
  return {.command = flags.equivalent_command.empty() ? command_line() : flags.equivalent_command,
          .made_at = report::creation_time(),
          .title_block = title_block(flags.title)};
}

report::Provenance provenance_now(const OutputFlags& flags, const std::string& setup_path) {
  report::Provenance provenance = provenance_now(flags);
  if (setup_path.empty()) return provenance;
  for (const acquire::ChannelInstrument& one : acquire::instruments_of_setup(setup_path))
    provenance.title_block.facts.emplace_back("Instrument of " + one.channel, one.instrument);
  return provenance;
}

}  // namespace percuss::tools
