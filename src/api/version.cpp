#include "percuss/version.hpp"

#include "report/text/version.hpp"

namespace percuss {

const char* version() { return report::version(); }

}  // namespace percuss
