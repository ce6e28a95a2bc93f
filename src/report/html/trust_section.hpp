#pragma once
#include <set>
#include <string>
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::report {

/// A part of a page that warnings can stand beside. `whole` is the section "How far can this test be trusted?".
enum class PagePart { whole, force, response, spectrum, decay, fit, stabilisation, shapes };

/// The part that shows what a warning or finding of this code concerns.
PagePart part_of(const std::string& code);

/// The warnings and findings of a page, each once, in the order of pipeline::trust_statements. Statements that results
/// are wrong, and statements that no part shows, stand in the section on trust. The others stand beside the part that
/// shows what they concern.
class PageWarnings {
 public:
  /// `shown`: the parts that the page has. Statements on other parts stand in the section on trust.
  PageWarnings(const std::vector<pipeline::Warning>& warnings, const std::vector<pipeline::AnalysedHit>& hits,
               std::set<PagePart> shown);
  /// The section "How far can this test be trusted?": its own statements, and how many stand beside which part.
  std::string section() const;
  /// A sentence for the head of the page where results are wrong; else nothing.
  std::string caution() const;
  /// The statements beside a part, or nothing.
  std::string beside(PagePart part) const;

 private:
  std::vector<pipeline::Warning> of(PagePart part) const;

  std::vector<pipeline::Warning> statements_;
  bool no_hit_is_used_;
  std::set<PagePart> shown_;
};

}  // namespace percuss::report
