#include "report/text/report_sections.hpp"

#include <map>

#include "core/error.hpp"

namespace percuss::report {

std::set<ReportSection> default_sections() {
  return {ReportSection::hits, ReportSection::frf, ReportSection::coherence, ReportSection::modes,
          ReportSection::classes};
}

std::set<ReportSection> parse_report_sections(const std::vector<std::string>& names) {
  using enum ReportSection;
  static const std::map<std::string, ReportSection> known{{"hits", hits},           {"frf", frf},
                                                          {"coherence", coherence}, {"modes", modes},
                                                          {"classes", classes},     {"deflection", deflection}};
  std::set<ReportSection> out;
  for (const std::string& name : names) {
    const auto it = known.find(name);
    if (it == known.end()) {
      throw UsageError("unknown section '" + name + "'", "use hits, frf, coherence, modes, classes or deflection");
    }
    out.insert(it->second);
  }
  return out;
}

}  // namespace percuss::report
