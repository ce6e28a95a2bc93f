#pragma once

namespace percuss::tools {

/// Exit codes of the tool, a contract with users' scripts.
enum ExitCode {
  kOk = 0,
  kInternalError = 1,
  kUsage = 2,
  kBadInput = 3,
  kImpossible = 4,
  kQualityGate = 5,
  kPartial = 6
};

}  // namespace percuss::tools
