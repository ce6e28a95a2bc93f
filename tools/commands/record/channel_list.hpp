#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::tools {

/// What a list of channels may hold. Error messages put it after the word "give".
inline constexpr const char* kChannelsRequirement = "whole numbers from 1 up, or ranges such as 1-3";

/// Whether the text is a piece of a list of channels: "8" or "1-5".
bool names_channels(const std::string& piece);

/// The channel numbers, from 1, that a list of pieces such as "1-5" and "8" names.
/// errors  OptionError: other texts, channel 0, a channel twice, more than 4096 channels
std::vector<std::size_t> parse_channels(const std::vector<std::string>& pieces);

}  // namespace percuss::tools
