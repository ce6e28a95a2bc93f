#include "report/html/trust_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "pipeline/warnings/ranking.hpp"
#include "report/html/page_elements.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

using acquire::Severity;

constexpr std::size_t kMaxBytes = 4000;  // of one statement

// A property of the structure puts no result in doubt.
bool concerns_the_structure(std::string_view code) { return code == "double_peak" || code == "nonlinear"; }

const char* label_of(const pipeline::Warning& warning) {
  if (concerns_the_structure(warning.code)) return "A property of the structure";
  switch (warning.severity.value_or(Severity::warn)) {
    case Severity::reject:
      return "Results are wrong";
    case Severity::warn:
      return "Results may be off";
    case Severity::info:
      return "For information";
  }
  return "";
}

// The message without the remedy that ends it, as a sentence.
std::string consequence_of(const pipeline::Warning& warning) {
  const std::string end = "; " + warning.remedy;
  if (warning.remedy.empty() || !warning.message.ends_with(end)) return warning.message;
  std::string consequence = warning.message.substr(0, warning.message.size() - end.size());
  if (!consequence.ends_with('.') && !consequence.ends_with('?')) consequence += '.';
  return consequence;
}

std::string statement_html(const pipeline::Warning& warning) {
  const Severity severity = warning.severity.value_or(Severity::warn);
  std::string out = fmt::format("<li class=\"{}\"><b>{}.</b> {}", name_of(severity), label_of(warning),
                                html_escape(one_line(consequence_of(warning), kMaxBytes)));
  if (!warning.remedy.empty())
    out += fmt::format(" <span class=\"remedy\">Remedy: {}.</span>", html_escape(one_line(warning.remedy, kMaxBytes)));
  return out + "</li>\n";
}

std::string list_html(const std::vector<pipeline::Warning>& statements, const char* kind) {
  std::string items;
  for (const pipeline::Warning& one : statements) items += statement_html(one);
  return items.empty() ? "" : fmt::format("<ol class=\"warnings {}\" aria-label=\"Warnings\">\n{}</ol>\n", kind, items);
}

struct PlacedCode {
  std::string_view code;
  PagePart part;
};

constexpr auto kPlaces = std::to_array<PlacedCode>({
    {"double_hit", PagePart::force},
    {"double_hits_used", PagePart::force},
    {"overload", PagePart::force},
    {"force_clipped", PagePart::force},
    {"late_trigger", PagePart::force},
    {"no_pulse", PagePart::force},
    {"weak", PagePart::force},
    {"implausible_force", PagePart::force},
    {"duplicate", PagePart::force},
    {"short_pretrigger", PagePart::force},
    {"dropped_points", PagePart::force},
    {"accept_refused", PagePart::force},
    {"rejected_hits", PagePart::force},
    {"rejected_live", PagePart::force},
    {"ac_coupling", PagePart::force},
    {"force_noise_unknown", PagePart::force},
    {"polarity", PagePart::response},
    {"response_clipped", PagePart::response},
    {"coarse_steps", PagePart::response},
    {"spike", PagePart::response},
    {"dropout", PagePart::response},
    {"lost_samples", PagePart::response},
    {"capture_lost_samples", PagePart::response},
    {"zero_shift", PagePart::response},
    {"offset", PagePart::response},
    {"drift", PagePart::response},
    {"low_bandwidth", PagePart::spectrum},
    {"truncated_decay", PagePart::decay},
    {"low_coherence", PagePart::decay},
    {"outlier", PagePart::decay},
    {"not_at_rest", PagePart::decay},
    {"earlier_ringing", PagePart::decay},
    {"no_rest", PagePart::decay},
    {"short_hit", PagePart::decay},
    {"hum", PagePart::fit},
    {"tone", PagePart::fit},
    {"frac", PagePart::fit},
    {"model_misfit", PagePart::fit},
    {"no_modes", PagePart::fit},
    {"unclaimed_peaks", PagePart::fit},
    {"local_fits", PagePart::fit},
    {"crowded", PagePart::fit},
    {"below_band", PagePart::fit},
    {"pair_or_scatter", PagePart::fit},
    {"uneven_decay", PagePart::fit},
    {"cut_decay", PagePart::response},
    {"disturbed_decay", PagePart::response},
    {"unmodelled_poles", PagePart::stabilisation},
    {"start_refused", PagePart::stabilisation},
    {"start_between", PagePart::stabilisation},
    {"repeated_modes", PagePart::shapes},
    {"sensor_on_node", PagePart::shapes},
    {"sensors_disagree", PagePart::shapes},
    {"driving_point_numbers", PagePart::shapes},
    {"driving_point_sign", PagePart::shapes},
    {"reciprocity", PagePart::shapes},
    {"no_geometry", PagePart::shapes},
    {"narrow_arc", PagePart::shapes},
    {"missing_points", PagePart::shapes},
    {"files_in_order", PagePart::shapes},
    {"missing_position", PagePart::shapes},
    {"misplaced_hits", PagePart::shapes},
    {"mass_loading", PagePart::shapes},
});

const char* name_of_part(PagePart part) {
  switch (part) {
    case PagePart::whole:
      return "";
    case PagePart::force:
      return "the force";
    case PagePart::response:
      return "the response";
    case PagePart::spectrum:
      return "the spectrum of the force";
    case PagePart::decay:
      return "the decay";
    case PagePart::fit:
      return "the fit";
    case PagePart::stabilisation:
      return "the stabilisation diagram";
    case PagePart::shapes:
      return "the mode shapes";
  }
  return "";
}

}  // namespace

PagePart part_of(const std::string& code) {
  const auto* const it =
      std::find_if(kPlaces.begin(), kPlaces.end(), [&](const PlacedCode& known) { return known.code == code; });
  return it == kPlaces.end() ? PagePart::whole : it->part;
}

PageWarnings::PageWarnings(const std::vector<pipeline::Warning>& warnings,
                           const std::vector<pipeline::AnalysedHit>& hits, std::set<PagePart> shown)
    : statements_(pipeline::trust_statements(warnings, hits)),
      no_hit_is_used_(!hits.empty() &&
                      std::none_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.accepted; })),
      shown_(std::move(shown)) {}

std::vector<pipeline::Warning> PageWarnings::of(PagePart part) const {
  std::vector<pipeline::Warning> out;
  for (const pipeline::Warning& one : statements_) {
    const PagePart own = part_of(one.code);
    const bool beside = one.severity != Severity::reject && shown_.contains(own);
    if ((beside ? own : PagePart::whole) == part) out.push_back(one);
  }
  return out;
}

std::string PageWarnings::caution() const {
  const bool wrong = std::any_of(statements_.begin(), statements_.end(), [](const pipeline::Warning& one) {
    return one.severity == Severity::reject && !concerns_the_structure(one.code);
  });
  return wrong ? "<p class=\"verdict\">Some of these results are wrong; <a href=\"#trust\">the reason</a> is stated "
                 "below.</p>\n"
               : "";
}

std::string PageWarnings::beside(PagePart part) const { return list_html(of(part), "trust beside"); }

std::string PageWarnings::section() const {
  std::string content = list_html(of(PagePart::whole), "trust"), elsewhere;
  for (const PagePart part : shown_) {
    if (const std::size_t count = part == PagePart::whole ? 0 : of(part).size(); count > 0)
      elsewhere += fmt::format("{}{} ({})", elsewhere.empty() ? "" : ", ", name_of_part(part), count);
  }
  if (no_hit_is_used_ && content.empty()) {
    content = page_paragraph("No hit is used, so there are no results to trust.");
  } else if (statements_.empty()) {
    content = page_paragraph("Nothing was found that puts the results or their ± in doubt.");
  } else if (content.empty()) {
    content = page_paragraph("Nothing was found that makes the results wrong.");
  }
  if (!elsewhere.empty())
    content += page_paragraph("Further warnings stand beside what they concern: " + elsewhere + ".");
  return page_section("trust", "How far can this test be trusted?", content);
}

}  // namespace percuss::report
