#include "commands/model/frequency_fit_flags.hpp"

#include <algorithm>
#include <array>

#include "cli/option_error.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxFittedModes = 200;

struct StructureParameterName {
  const char* name;
  model::StructureParameter which;
};
constexpr std::array<StructureParameterName, 5> kStructureNames{{{"young", model::StructureParameter::young},
                                                                 {"shear", model::StructureParameter::shear},
                                                                 {"density", model::StructureParameter::density},
                                                                 {"torsion", model::StructureParameter::torsion},
                                                                 {"added-mass", model::StructureParameter::mass}}};

}  // namespace

void add_frequency_fit_flags(Command& command, FrequencyFitFlags& flags, const std::vector<std::string>& names,
                             const char* numbers) {
  const std::string previous = command.heading("Fit to measurements");
  command.list("--fit", flags.names, "Fit these parameters to --measured; their values are the start")
      .type("NAME,...")
      .one_of(names);
  command.list("--measured", flags.measured_Hz, "Set the measured frequencies, lowest first")
      .above_zero()
      .type("HZ,...");
  command
      .list("--measured-std", flags.measured_std_Hz,
            "Set the standard deviations of the measured frequencies; one each, or one for all")
      .above_zero()
      .type("HZ,...");
  command.list("--measured-modes", flags.measured_modes, numbers).type("N,...");
  command.heading(previous);
}

std::vector<model::MeasuredMode> measured_modes(const FrequencyFitFlags& flags, std::size_t first) {
  const std::size_t count = flags.measured_Hz.size();
  const auto& std_Hz = flags.measured_std_Hz;
  if (flags.names.empty()) {
    throw OptionError({"measured"}, "is given, but no parameter to fit", "name the parameters", {"fit"});
  }
  if (!flags.measured_modes.empty() && flags.measured_modes.size() != count) {
    throw OptionError({"measured_modes"}, "does not have one number per frequency", "give one for each frequency",
                      {"measured"});
  }
  if (std_Hz.size() > 1 && std_Hz.size() != count) {
    throw OptionError({"measured_std"}, "does not have one value per frequency",
                      "give one for each frequency, or one for all", {"measured"});
  }
  if (count < flags.names.size()) {
    throw OptionError({"fit"}, "has more parameters than there are frequencies", "measure at least as many frequencies",
                      {"measured"});
  }
  std::vector<model::MeasuredMode> measured;
  measured.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t mode = flags.measured_modes.empty() ? first + i : flags.measured_modes[i];
    if (mode < first || mode - first >= kMaxFittedModes) {
      throw OptionError({"measured_modes"}, "names a mode that is not elastic, or one after the first 200 elastic ones",
                        "use the numbers of the table");
    }
    if (i > 0 && !(flags.measured_Hz[i] > flags.measured_Hz[i - 1] && mode - first > measured.back().elastic))
      throw OptionError({"measured", "measured_modes"}, "must rise", "sort the frequencies and their modes");
    measured.push_back({.elastic = mode - first,
                        .freq_Hz = flags.measured_Hz[i],
                        .std_Hz = std_Hz.empty() ? 0 : std_Hz[std::min(i, std_Hz.size() - 1)]});
  }
  return measured;
}

std::vector<model::StructureParameter> structure_parameters(const FrequencyFitFlags& flags,
                                                            const model::BeamStructure& structure, bool total_mass) {
  std::vector<model::StructureParameter> fitted;
  for (const std::string& name : flags.names) {
    const auto refuse = [&](const char* remedy, const char* problem, const std::vector<OptionId>& see) {
      return OptionError::wrong_value("fit", name, remedy, problem, see);
    };
    const auto found = std::find_if(kStructureNames.begin(), kStructureNames.end(),
                                    [&](const StructureParameterName& one) { return name == one.name; });
    if (found == kStructureNames.end())
      throw refuse("fit young, shear, density, torsion or added-mass", "a profile has no such value", {"profile"});
    if (found->which == model::StructureParameter::torsion && structure.support.kind != model::BeamSupport::torsion)
      throw refuse("choose the torsion support", "there is no torsion spring", {"support"});
    if (found->which == model::StructureParameter::mass && structure.added.empty())
      throw refuse("give it a start value", "there is no added mass", {"add_mass"});
    if (found->which == model::StructureParameter::density && total_mass)
      throw refuse("omit one", "the mass gives the density", {"total_mass"});
    if (found->which == model::StructureParameter::shear && structure.slender)
      throw refuse("give it a start value", "the beam has no shear deformation", {"shear"});
    if (std::find(fitted.begin(), fitted.end(), found->which) != fitted.end())
      throw refuse("name each parameter once", "it is named twice", {});
    fitted.push_back(found->which);
  }
  return fitted;
}

}  // namespace percuss::tools
