#include "report/text/survey_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/units.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/analysis_text.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/warnings_text.hpp"

namespace percuss::report {
namespace {

constexpr double kMinMac = 0.2;  // of a listed pair of modes; if no pair is listed, the largest MAC is stated

std::string plane_cell(const std::optional<identify::TubeShape>& tube) {
  if (!tube || !tube->plane_rad) return "–";
  return value_with_std(*tube->plane_rad * kRadian_deg, tube->plane_std_rad * kRadian_deg) + "°";
}

std::string note_cell(const identify::ModeClassification& classification) {
  std::string note;
  if (classification.split_mode && classification.split_mode->separation_Hz == 0) {
    note = "one of two modes at this frequency";
  } else if (classification.split_mode) {
    note = fmt::format("split mode, {:.3g} Hz apart{}", classification.split_mode->separation_Hz,
                       classification.split_mode->quoted ? ": its frequency stands for the mode" : "");
  }
  if (const std::string other = other_types(classification); !other.empty()) note += (note.empty() ? "" : "; ") + other;
  return note;
}

}  // namespace

TextTable survey_modes_table(const pipeline::Survey& survey) {
  const auto& modes = survey.modes();
  const bool tube =
      std::any_of(survey.tubes().begin(), survey.tubes().end(), [](const auto& t) { return t.has_value(); });
  const bool mass = std::any_of(survey.shapes().begin(), survey.shapes().end(),
                                [](const identify::ModeShape& s) { return s.modal_mass_kg.has_value(); });
  constexpr auto kRight = TextTable::Align::right;
  const bool named = std::any_of(survey.classifications().begin(), survey.classifications().end(),
                                 [](const auto& c) { return c.type != identify::ModeType::unknown; });
  std::vector<TextTable::Column> columns{{"mode", kRight}};
  if (named) columns.insert(columns.end(), {{"family"}, {"confidence", kRight}});
  columns.insert(columns.end(), {{"frequency", kRight}, {"damping", kRight}});
  if (tube) columns.insert(columns.end(), {{"n", kRight}, {"share", kRight}, {"nodes", kRight}, {"plane", kRight}});
  columns.push_back({"MPC", kRight});
  if (mass) columns.push_back({"modal mass", kRight});
  columns.push_back({"note"});
  TextTable table(columns);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const identify::Mode& mode = modes[m];
    const identify::ModeShape& shape = survey.shapes()[m];
    std::vector<std::string> cells{fmt::format("{}", m + 1)};
    if (named) {
      cells.push_back(mode_type_of(survey.classifications()[m]));
      cells.push_back(confidence_text(survey.classifications()[m]));
    }
    cells.push_back(value_with_std(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz");
    cells.push_back(value_with_std(mode.pole.damping_ratio * 100, mode.damping_std * 100) + " %");
    if (tube) {
      const auto& t = survey.tubes()[m];
      cells.push_back(t ? fmt::format("{}", t->order) : "–");
      cells.push_back(t ? fmt::format("{:.1f} %", t->energy[static_cast<std::size_t>(t->order)] * 100) : "–");
      cells.push_back(t && t->sign_changes ? fmt::format("{}", *t->sign_changes) : "–");
      cells.push_back(plane_cell(t));
    }
    cells.push_back(fmt::format("{:.4f}", shape.mpc));
    if (mass) {
      cells.push_back(shape.modal_mass_kg ? value_with_std(*shape.modal_mass_kg, shape.modal_mass_std_kg) + " kg"
                                          : "–");
    }
    cells.push_back(note_cell(survey.classifications()[m]));
    table.add(std::move(cells), is_quoted(survey.classifications()[m]));
  }
  return table;
}

namespace {

std::string modes_text(const pipeline::Survey& survey, std::size_t width) {
  if (survey.analysis().modes().empty()) return no_modes_text(survey.analysis());
  return survey_modes_table(survey).text(width);
}

std::string scale_text(const pipeline::Survey& survey) {
  const auto& shapes = survey.shapes();
  const auto unit = std::count_if(shapes.begin(), shapes.end(), [](const identify::ModeShape& s) {
    return s.normalisation == identify::Normalisation::unit_modal_mass;
  });
  std::string points;
  const pipeline::Analysis& analysis = survey.analysis();
  for (const identify::DrivingPoint& at : survey.driving_points()) {
    std::string name = analysis.point_names().name(static_cast<int>(at.point));
    const std::string& sensor = analysis.record().accel.at(at.channel).name;
    if (name.ends_with(')')) {
      name.pop_back();
      name += ", " + sensor + ")";  // "7 (P7.csv, accel 1)"
    } else {
      name += " (" + sensor + ")";
    }
    points += fmt::format("{}point {}", points.empty() ? "" : ", ", name);
  }
  if (unit == 0) {
    const auto checks = survey.driving_checks();
    const bool wrong = std::any_of(checks.begin(), checks.end(), [](const auto& check) { return check.wrong_sign; });
    const std::string reason = points.empty() ? "no driving point is known"
                                              : fmt::format("the residues at the driving {} {}", points,
                                                            wrong ? "have the wrong sign" : "are within their noise");
    return fmt::format("shapes: scaled to 1 at their largest component, because {}\n", reason);
  }
  return fmt::format(
      "shapes: unit modal mass, from the driving {}{}\n", points,
      static_cast<std::size_t>(unit) < shapes.size() ? "; the others are scaled to 1 at their largest component" : "");
}

// Errors of the place and direction of the hits show in the scatter between hits, which one hit per point cannot show.
std::string one_hit_text(const pipeline::Analysis& analysis) {
  const auto& frfs = analysis.frfs();
  const bool one_each = std::all_of(frfs.begin(), frfs.end(), [](const auto& one) { return one.frf.averages == 1; });
  if (analysis.given_frfs() != nullptr || !one_each) return "";
  return "one hit per point: each ± leaves out errors of the place and direction of the hits; repeat hits\n";
}

std::string mac_text(const pipeline::Survey& survey) {
  std::string text;
  double most = 0;
  for (std::size_t i = 0; i < survey.macs().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const identify::Mac& mac = survey.macs()[i][j];
      most = std::max(most, mac.value);
      if (mac.value > kMinMac) {
        text +=
            fmt::format("{}{} and {} ({})", text.empty() ? "" : ", ", j + 1, i + 1, value_with_std(mac.value, mac.std));
      }
    }
  }
  if (survey.macs().size() < 2) return "";
  return text.empty() ? fmt::format("MAC between different modes: {:.4f} at most\n", most)
                      : "similar shapes on these points (MAC): modes " + text + "\n";
}

std::string frac_text(const pipeline::Survey& survey) {
  if (survey.synthesis().empty()) return "";
  const auto worst = std::min_element(survey.synthesis().begin(), survey.synthesis().end(),
                                      [](const identify::SynthesisedFrf& a, const identify::SynthesisedFrf& b) {
                                        const bool a_strong = a.level_dB >= -20, b_strong = b.level_dB >= -20;
                                        return a_strong != b_strong ? a_strong : a.frac < b.frac;
                                      });
  const auto poor = std::count_if(survey.synthesis().begin(), survey.synthesis().end(), pipeline::poorly_explained);
  const pipeline::Analysis& analysis = survey.analysis();
  const std::size_t others = analysis.fitted_modes().size() - analysis.modes().size();
  return fmt::format("FRFs synthesised from the modes{}: lowest FRAC of the strong FRFs {:.4f}{}\n",
                     others > 0 ? fmt::format(" and the {} not listed", others) : "", worst->frac,
                     poor > 0 ? fmt::format("; {} below 0.99", poor) : "");
}

}  // namespace

std::string survey_text(const pipeline::Survey& survey, bool hits, std::size_t width, OptionWriter write_option,
                        bool warnings) {
  std::set<ReportSection> sections{ReportSection::frf, ReportSection::coherence};
  if (hits || !survey.analysis().possible()) sections.insert(ReportSection::hits);
  std::string text = analysis_text(
      survey.analysis(), {.sections = sections, .width = width, .warnings = false, .write_option = write_option});
  if (survey.analysis().possible()) {
    text += "\n" + modes_text(survey, width) + "\n";
    if (!survey.shapes().empty()) text += scale_text(survey) + one_hit_text(survey.analysis());
    text += mac_text(survey) + frac_text(survey);
  }
  text += "\n";
  if (warnings) text += warnings_text(survey.warnings()).text(width, write_option);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace percuss::report
