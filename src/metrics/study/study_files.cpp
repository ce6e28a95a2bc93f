#include "metrics/study/study_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"

namespace percuss::metrics {

StudyCurve parse_study_curve(std::string_view text, const std::string& where) {
  constexpr std::array<std::string_view, 4> kWanted{"schema", "curve", "hoop_hz", "cor"};
  const nlohmann::json document = json_if_valid<nlohmann::json>(text, kWanted);
  const bool object = document.is_object() && document.contains("curve") && document["curve"].is_array();
  if (!object || document.value("schema", nlohmann::json()) != "percuss/model-trampoline/1") {
    throw InputError("no curve over the hoop frequency", where, "give the JSON document of a trampoline model",
                     {"hoop_curve"});
  }
  StudyCurve curve{.name = "model"};
  for (const nlohmann::json& point : document["curve"]) {
    const bool pair = point.is_object() && point.contains("hoop_hz") && point["hoop_hz"].is_number() &&
                      point.contains("cor") && point["cor"].is_number();
    const double hoop_Hz = pair ? point["hoop_hz"].get<double>() : std::nan("");
    if (!pair || !(hoop_Hz > (curve.hoop_Hz.empty() ? 0 : curve.hoop_Hz.back()))) {
      throw InputError("a point without hoop_hz and cor, or hoop frequencies that do not rise", where,
                       "give the JSON document of a trampoline model", {"hoop_curve"});
    }
    curve.hoop_Hz.push_back(hoop_Hz);
    curve.value.push_back(point["cor"].get<double>());
  }
  if (curve.hoop_Hz.size() < 2) {
    throw InputError("a curve of fewer than two points", where, "give the JSON document of a trampoline model",
                     {"hoop_curve"});
  }
  return curve;
}

std::string anonymise_bats(std::vector<StudyBat>& bats, CsvFormulas formulas) {
  const auto cell = [&](const std::string& text) { return csv_cell(text, formulas); };
  std::string key = "neutral,id,bat,maker,model\n";
  std::map<std::string, std::string> neutral_of_bat;
  for (std::size_t b = 0; b < bats.size(); ++b) {
    StudyBat& bat = bats[b];
    const std::string neutral = fmt::format("AS{:03}", b + 1);
    key += fmt::format("{},{},{},{},{}\n", neutral, cell(bat.id), cell(bat.bat), cell(bat.maker), cell(bat.model));
    bat.id = neutral;
    bat.maker.clear();
    bat.model.clear();
    if (!bat.bat.empty()) bat.bat = neutral_of_bat.try_emplace(bat.bat, neutral).first->second;
  }
  return key;
}

std::string study_table_csv(const std::vector<StudyBat>& bats, CsvFormulas formulas) {
  const auto cell = [&](const std::string& text) { return csv_cell(text, formulas); };
  std::string out = "id,bat,maker,model,length_in,material,condition,program";
  for (std::size_t q = 0; q < kStudyQuantities; ++q)
    out += fmt::format(",{}", column_of(static_cast<StudyQuantity>(q)));
  out += '\n';
  for (const StudyBat& bat : bats) {
    out += fmt::format("{},{},{},{},{},{},{},{}", cell(bat.id), cell(bat.bat), cell(bat.maker), cell(bat.model),
                       bat.length_in, name_of(bat.material), bat.condition(), cell(bat.program));
    for (const auto& value : bat.values) out += value ? fmt::format(",{}", *value) : ",";
    out += '\n';
  }
  return out;
}

}  // namespace percuss::metrics
