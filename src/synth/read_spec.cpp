#include "synth/read_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/io/strict_json.hpp"
#include "core/units.hpp"

namespace percuss::synth {
namespace {

constexpr int kMaxDepth = 6;

// Reads one of the given words.
template <class Enum>
void read_word(StrictObject& object, const std::string& key, std::initializer_list<std::pair<const char*, Enum>> words,
               Enum& to) {
  std::string text;
  object.read(key, text);
  if (text.empty() && !object.has(key)) return;
  std::vector<std::string> known;
  for (const auto& [word, value] : words) {
    if (text == word) {
      to = value;
      return;
    }
    known.emplace_back(word);
  }
  object.fail(fmt::format("\"{}\" is not known", one_line(text, 40)), key,
              fmt::format("give one of {}", fmt::join(known, ", ")));
}

void read_degrees(StrictObject& object, const std::string& key, double& to_rad) {
  double degrees = to_rad / kDegree_rad;
  object.read(key, degrees);
  to_rad = object.has(key) ? degrees * kDegree_rad : to_rad;
}

void read_structure(StrictObject& o, SynthStructure& to) {
  o.read("length_m", to.length_m);
  o.read("barrel_m", to.barrel_m);
  o.read("radius_m", to.radius_m);
  o.read("mass_kg", to.mass_kg);
  o.read("inertia_kgm2", to.inertia_kgm2);
  o.read("cm_m", to.cm_m);
  o.read("rigid_line_per_kg", to.rigid_line_per_kg);
}

void read_mode(StrictObject& o, SynthMode& to) {
  o.need("frequency_hz");
  o.need("damping_ratio");
  o.read("frequency_hz", to.freq_Hz);
  o.read("damping_ratio", to.damping_ratio);
  read_word(o, "family", {{"bending", SynthModeType::bending}, {"hoop", SynthModeType::hoop}}, to.type);
  o.read("order", to.order);
  read_degrees(o, "angle_deg", to.angle_rad);
  o.read("amplitude_per_sqrt_kg", to.amplitude_per_sqrt_kg);
  o.read("residue_per_kg", to.residue_per_kg);
}

void read_sensor(StrictObject& o, SynthSensor& to) {
  o.read("position_m", to.position_m);
  read_degrees(o, "angle_deg", to.angle_rad);
  o.read("sign", to.sign);
  o.read("gain", to.gain);
}

void read_point(StrictObject& o, SynthPoint& to) {
  o.read("position_m", to.position_m);
  read_degrees(o, "angle_deg", to.angle_rad);
  o.read("xyz_m", to.xyz_m);
}

void read_pulse(StrictObject& o, SynthPulse& to) {
  read_word(
      o, "kind",
      {{"halfsine", PulseKind::halfsine}, {"haversine", PulseKind::haversine}, {"sine-cubed", PulseKind::sine_cubed}},
      to.kind);
  o.read("width_s", to.width_s);
  o.read("peak_n", to.peak_N);
  o.read("width_spread", to.width_spread);
  o.read("peak_spread", to.peak_spread);
}

void read_recorder(StrictObject& o, SynthRecorder& to) {
  o.read("force_gain", to.force_gain);
  o.read("force_bias_n", to.force_bias_N);
  o.read("accel_bias_mps2", to.accel_bias_mps2);
  o.read("accel_drift_mps2_per_s", to.accel_drift_mps2_per_s);
  o.read("force_clip_n", to.force_clip_N);
  o.read("accel_clip_mps2", to.accel_clip_mps2);
  o.read("bits", to.bits);
  o.read("force_range_n", to.force_range_N);
  o.read("accel_range_mps2", to.accel_range_mps2);
}

void read_fault(StrictObject& o, SynthFault& to) {
  using Kind = SynthFaultKind;
  o.need("hit");
  o.need("kind");
  o.read("hit", to.hit);
  read_word(o, "kind",
            {{"double", Kind::double_hit},
             {"weak", Kind::weak},
             {"missing", Kind::missing},
             {"late", Kind::late},
             {"reversed", Kind::reversed}},
            to.kind);
  // A key that this kind of fault does not use counts as unknown.
  if (to.kind == Kind::double_hit || to.kind == Kind::weak) o.read("ratio", to.ratio);
  if (to.kind == Kind::double_hit || to.kind == Kind::late) o.read("delay_s", to.delay_s);
}

void read_length(StrictObject& o, SynthSpec& to) {
  o.need("fs_hz");
  o.read("fs_hz", to.fs_Hz);
  if (!o.has("duration_s")) {
    o.need("samples");
    o.read("samples", to.samples);
    return;
  }
  if (o.has("samples")) o.fail("given together with samples", "duration_s", "remove one of the two");
  double duration_s = 0;
  o.read("duration_s", duration_s);
  const double samples = std::round(duration_s * to.fs_Hz);
  if (!(samples >= 0 && samples <= 1e15))
    o.fail("not a possible number of samples at this fs_hz", "duration_s", "give a shorter time in s, not below 0");
  to.samples = static_cast<std::size_t>(samples);
}

void read_hits(StrictObject& o, SynthSpec& to) {
  read_word(o, "layout", {{"rows", SynthLayout::rows}, {"continuous", SynthLayout::continuous}}, to.layout);
  o.read("hit_times_s", to.hit_times_s);
  if (!to.hit_times_s.empty()) to.hits = to.hit_times_s.size();
  o.read("hits", to.hits);
  o.read("runs", to.runs);
  o.read("pretrigger_s", to.pretrigger_s);
  o.read("onset_spread_s", to.onset_spread_s);
  o.read_part("pulse", [&](StrictObject& part) { read_pulse(part, to.pulse); });
}

void read_band(StrictObject& o, SynthSpec& to) {
  std::vector<double> band{to.band_low_Hz, std::min(to.band_high_Hz, 0.4 * to.fs_Hz)};
  o.read("band_hz", band);
  if (band.size() != 2) o.fail(fmt::format("{} numbers", band.size()), "band_hz", "give [low, high]");
  to.band_low_Hz = band[0];
  to.band_high_Hz = band[1];
}

// Reads the items of a list, which replace the previous items.
template <class Item>
void read_items(StrictObject& o, const std::string& key, std::vector<Item>& to, void (*read)(StrictObject&, Item&)) {
  if (o.has(key)) to.clear();
  o.read_list(key, [&](StrictObject& item) { read(item, to.emplace_back()); });
}

void read_document(StrictObject& o, SynthSpec& spec) {
  std::string schema = "percuss/synth/1";
  o.read("schema", schema);
  if (schema != "percuss/synth/1") o.fail("another kind of document", "schema", "give percuss/synth/1");
  o.read("name", spec.name);
  o.read("description", spec.description);
  o.read("seed", spec.seed);
  read_length(o, spec);
  read_band(o, spec);
  o.read_part("structure", [&](StrictObject& part) { read_structure(part, spec.structure); });
  o.need("modes");
  read_items(o, "modes", spec.modes, read_mode);
  read_items(o, "sensors", spec.sensors, read_sensor);
  read_items(o, "impact", spec.points, read_point);
  read_items(o, "faults", spec.faults, read_fault);
  read_hits(o, spec);
  o.read_part("noise", [&](StrictObject& part) {
    part.read("force", spec.noise.force);
    part.read("accel", spec.noise.accel);
  });
  o.read_part("recorder", [&](StrictObject& part) { read_recorder(part, spec.recorder); });
}

}  // namespace

SynthSpec parse_synth_spec(std::string_view text, std::string_view where) {
  const std::string place(where);
  if (text.size() > kMaxSpec_bytes) throw InputError("longer than 4 MiB", place, "give a synth spec");
  SynthSpec spec;
  read_strict_json({.text = text, .where = place, .options = {"synth.example"}, .max_depth = kMaxDepth},
                   [&](StrictObject& o) { read_document(o, spec); });
  validate(spec, where);
  return spec;
}

}  // namespace percuss::synth
