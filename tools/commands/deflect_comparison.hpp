#pragma once
#include <optional>
#include <string>
#include <vector>

#include "metrics/compare.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/response/response_test.hpp"
#include "report/html/command_report.hpp"

namespace percuss::tools {
struct Host;

/// What an impact test is compared with.
struct ComparisonFlags {
  std::vector<std::string> compared;  // documents
  std::vector<std::string> beam;      // KEY=VALUE of a model beam
  bool wanted() const { return !compared.empty() || !beam.empty(); }
};

/// The modes that the impacts of `deflect` excited: of the FRFs where the force is known, else of the free decays.
struct ImpactModes {
  std::vector<identify::Mode> modes;
  std::optional<pipeline::ResponseTest> responses;  // where no force is known
};
ImpactModes modes_of_impacts(const pipeline::Analysis& analysis);

/// The impact test beside documents and a model beam: frequencies, largest deflections and their ratio. The model's
/// ball has the stated speed, or else the measured one; without a speed, frequencies alone are compared.
/// errors  OptionError: an unknown key or a wrong value; InputError: as report::read_documents.
report::CommandReport impact_comparison(const ComparisonFlags& flags, const Host* host,
                                        const pipeline::Analysis& analysis, const pipeline::ImpactTest& test,
                                        const ImpactModes& modes);

}  // namespace percuss::tools
