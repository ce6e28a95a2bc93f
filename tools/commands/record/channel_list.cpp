#include "commands/record/channel_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/hit_list.hpp"
#include "cli/option_error.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxListedChannels = 4096;

}  // namespace

bool names_channels(const std::string& piece) { return number_range(piece).has_value(); }

std::vector<std::size_t> parse_channels(const std::vector<std::string>& pieces) {
  std::vector<std::size_t> channels;
  for (const std::string& piece : pieces) {
    const auto range = number_range(piece);
    if (range && range->first == 0) throw OptionError::wrong_value("channels", piece, "count channels from 1");
    if (!range || channels.size() + (range->second - range->first) >= kMaxListedChannels)
      throw OptionError::wrong_value("channels", piece, std::string("give ") + kChannelsRequirement);
    for (std::size_t channel = range->first; channel <= range->second; ++channel) {
      if (std::find(channels.begin(), channels.end(), channel) != channels.end()) {
        throw OptionError::wrong_value("channels", piece, "name each channel once",
                                       fmt::format("channel {} is named twice", channel));
      }
      channels.push_back(channel);
    }
  }
  return channels;
}

}  // namespace percuss::tools
