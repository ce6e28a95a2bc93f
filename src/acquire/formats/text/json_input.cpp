#include "acquire/formats/text/json_input.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/io/json_text.hpp"

namespace percuss::acquire {
namespace {

struct KindOfDocument {
  std::string_view schema, what, remedy;
};

// Matched by the beginning of the schema's name. "percuss/model-" and "percuss/batch" stand after the longer names that
// begin with them.
constexpr std::array kKinds = {
    KindOfDocument{"percuss/analysis/", "the modes of an analysis",
                   "percuss compare and percuss study read it; give the record that it names in \"inputs\""},
    KindOfDocument{"percuss/deflection/", "the deflections of a test",
                   "percuss compare reads it; give the record that it names in \"inputs\""},
    KindOfDocument{"percuss/compare/", "a comparison", "no command reads it; give the record of a test"},
    KindOfDocument{"percuss/nodes/", "the nodes of a scan", "no command reads it; give the record of the scan"},
    KindOfDocument{"percuss/info/", "the description of files", "no command reads it; give a file that it describes"},
    KindOfDocument{"percuss/calibration/", "a calibration",
                   "no command reads it; give its force_scale as an option, beside the record"},
    KindOfDocument{"percuss/study/", "the result of a study", "no command reads it; give the record of a test"},
    KindOfDocument{"percuss/model-rigid/", "the result of a model", "no command reads it; give the record of a test"},
    KindOfDocument{"percuss/model-trampoline/", "the result of a model", "percuss study reads it"},
    KindOfDocument{"percuss/model-", "the result of a model", "percuss compare reads it"},
    KindOfDocument{"percuss/devices/", "the list of devices", "no command reads it; give the record of a test"},
    KindOfDocument{"percuss/synth-truth/", "the truth of a synthetic test",
                   "no command reads it; give the record that lies beside it"},
    KindOfDocument{"percuss/synth/", "the spec of a synthetic test", "percuss synth makes the record from it"},
    KindOfDocument{"percuss/session/", "a test session", "percuss certify reads it"},
    KindOfDocument{"percuss/abi-log/", "a break-in log", "percuss abi reads it"},
    KindOfDocument{"percuss/metrics-table/", "a table of readings", "percuss metrics reads it"},
    KindOfDocument{"percuss/metrics/", "the metrics of a bat", "percuss study reads it"},
    KindOfDocument{"percuss/certify/", "the verdict on a session", "percuss study reads it"},
    KindOfDocument{"percuss/abi/", "the state of a break-in", "percuss study reads it"},
    KindOfDocument{"percuss/study-table/", "a table of bats", "percuss study reads it"},
    KindOfDocument{"percuss/channel-setup/", "a channel set-up", "give it as the set-up, beside the record"},
    KindOfDocument{"percuss/batch-manifest/", "the manifest of a batch", "percuss batch run reads it"},
    KindOfDocument{"percuss/batch", "a document of a batch", "give the records that the batch's manifest lists"},
    KindOfDocument{"percuss/synth-presets/", "the list of presets", "percuss synth makes a record from each"},
};

// The value of the key "schema"; empty without one.
std::string_view schema_in(std::string_view head) {
  constexpr std::string_view kKey = "\"schema\"";
  const std::size_t key = head.find(kKey);
  if (key == std::string_view::npos) return {};
  std::string_view rest = head.substr(key + kKey.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n:"), rest.size()));
  if (rest.empty() || rest.front() != '"') return {};
  rest.remove_prefix(1);
  return rest.substr(0, rest.find_first_of("\"\n"));
}

// A list of objects, such as a channel set-up.
bool begins_with_objects(std::string_view head) {
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()));
  if (!head.starts_with('[')) return false;
  return looks_like_json(head.substr(1));
}

}  // namespace

void refuse_json(std::string_view head, const std::string& name) {
  if (!looks_like_json(head) && !begins_with_objects(head)) return;
  const std::string_view schema = schema_in(head);
  const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                        [&](const KindOfDocument& one) { return schema.starts_with(one.schema); });
  const std::string problem = "not a record of samples, but ";
  if (kind != kKinds.end()) {
    throw InputError(problem + std::string(kind->what) + " (" + one_line(schema, 40) + ")", name, kind->remedy);
  }
  throw InputError(problem + (schema.empty() ? "JSON" : "a document " + one_line(schema, 40)), name,
                   "give the file of force and accelerations");
}

}  // namespace percuss::acquire
