#include "report/text/version.hpp"

namespace percuss::report {

const char* version() { return PERCUSS_VERSION; }

}  // namespace percuss::report
