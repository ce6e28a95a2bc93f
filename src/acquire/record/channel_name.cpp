#include "acquire/record/channel_name.hpp"

namespace percuss::acquire {

std::string channel_name(std::size_t index) { return "accel " + std::to_string(index + 1); }

}  // namespace percuss::acquire
