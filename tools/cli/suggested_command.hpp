#pragma once
#include <string>
#include <vector>

#include "acquire/channels/role_guess.hpp"

namespace percuss::tools {

/// "--force-channel 2 --accel-channel 3", quoted for a shell; empty without a guess.
std::string suggested_options(const acquire::RoleGuess& guess);

/// "; the samples suggest: percuss analyze x.csv --force-channel 2 --accel-channel 3": the typed command with the
/// guessed roles, quoted for a shell. A rate that nothing states appears as --fs HZ. If the command would be longer
/// than 300 bytes, only the options are shown. If the command needs a force and no channel looks like one, the text
/// says so. Empty without a guess.
std::string suggested_command(const std::vector<std::string>& typed, const acquire::RoleGuess& guess);

}  // namespace percuss::tools
