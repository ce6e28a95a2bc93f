#include "identify/model/effort.hpp"

namespace percuss::identify {

const char* name_of(Effort effort) {
  switch (effort) {
    case Effort::quick:
      return "quick";
    case Effort::standard:
      return "standard";
    case Effort::best:
      return "best";
  }
  return "";
}

}  // namespace percuss::identify
