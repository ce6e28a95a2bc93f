#include "report/text/report_sections.hpp"

#include <map>

#include "core/error.hpp"

namespace percuss {

std::set<Section> all_sections() {
  return {Section::hits, Section::frf, Section::coherence, Section::modes, Section::classes};
}

std::set<Section> parse_sections(const std::vector<std::string>& names) {
  using enum Section;
  static const std::map<std::string, Section> known{{"hits", hits},   {"frf", frf},         {"coherence", coherence},
                                                    {"modes", modes}, {"classes", classes}, {"deflection", deflection}};
  std::set<Section> out;
  for (const std::string& name : names) {
    const auto it = known.find(name);
    if (it == known.end()) {
      throw UsageError("--only does not know the section '" + name + "'",
                       "use hits, frf, coherence, modes, classes or deflection");
    }
    out.insert(it->second);
  }
  return out;
}

}  // namespace percuss
