#include "synth/truth_json.hpp"

#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "synth/schedule.hpp"

namespace percuss::synth {
namespace {

using nlohmann::ordered_json;

const char* name_of(PulseKind kind) {
  return kind == PulseKind::halfsine ? "halfsine" : kind == PulseKind::haversine ? "haversine" : "sine-cubed";
}

template <class List, class Value>
ordered_json each(const List& list, const Value& value) {
  ordered_json out = ordered_json::array();
  for (const auto& item : list) out.push_back(value(item));
  return out;
}

void add_modes(const Truth& truth, ordered_json& out) {
  const SynthSpec& spec = truth.spec;
  out["f_hz"] = each(spec.modes, [](const SynthMode& m) { return m.freq_Hz; });
  out["zeta"] = each(spec.modes, [](const SynthMode& m) { return m.damping_ratio; });
  out["kind"] = each(spec.modes, [](const SynthMode& m) { return m.type == SynthModeType::bending ? "bend" : "hoop"; });
  out["order"] = each(spec.modes, [](const SynthMode& m) { return m.order; });
  out["in_band"] = each(
      spec.modes, [&](const SynthMode& m) { return m.freq_Hz > spec.band_low_Hz && m.freq_Hz < spec.band_high_Hz; });
  out["band_hz"] = {spec.band_low_Hz, spec.band_high_Hz};
  // [channel][mode] for one point, [point][mode] for one sensor, [point][channel][mode] otherwise.
  const auto first_of = [](const auto& per_channel) { return per_channel.front(); };
  if (spec.points.size() == 1) {
    out["A"] = truth.residue_per_kg.front();
    out["rb"] = truth.rigid_per_kg.front();
  } else if (spec.sensors.size() == 1) {
    out["A"] = each(truth.residue_per_kg, first_of);
    out["rb"] = each(truth.rigid_per_kg, first_of);
  } else {
    out["A"] = truth.residue_per_kg;
    out["rb"] = truth.rigid_per_kg;
  }
  out["model"] =
      "H = rb + sum A (-w^2)/(wr^2 - w^2 + 2j zeta wr w), accelerance in (m/s^2)/N, of the signals as recorded";
}

void add_places(const Truth& truth, ordered_json& out) {
  const auto degrees = [](const auto& place) { return place.angle_rad / kDegree_rad; };
  const auto metres = [](const auto& place) { return place.position_m; };
  const SynthSpec& spec = truth.spec;
  out["points"] = spec.points.size();
  out["point_position_m"] = each(spec.points, metres);
  out["point_angle_deg"] = each(spec.points, degrees);
  out["sensors"] = spec.sensors.size();
  out["sensor_position_m"] = each(spec.sensors, metres);
  out["sensor_angle_deg"] = each(spec.sensors, degrees);
  out["sensor_sign"] = each(spec.sensors, [](const SynthSensor& s) { return s.sign; });
  out["sensor_gain"] = each(spec.sensors, [](const SynthSensor& s) { return s.gain; });
  out["force_gain"] = spec.recorder.force_gain;
}

void add_hits(const Truth& truth, ordered_json& out) {
  const SynthSpec& spec = truth.spec;
  out["runs"] = spec.runs;
  out["hits_per_run"] = truth.hits.size();
  out["hits_per_point"] = spec.hits;
  out["continuous"] = spec.layout == SynthLayout::continuous;
  out["hit_format"] = "[onset in samples, pulse kind, duration in samples, peak N]";
  out["hits"] = each(truth.hits, [&](const TrueHit& h) {
    return ordered_json{h.onset_s * spec.fs_Hz, name_of(spec.pulse.kind), h.width_s * spec.fs_Hz, h.peak_N};
  });
  out["hit_time_s"] = each(truth.hits, [](const TrueHit& h) { return h.onset_s; });
  out["hit_point"] = each(truth.hits, [](const TrueHit& h) { return h.point; });
  out["hit_flag"] = each(truth.hits, [](const TrueHit& h) { return h.flag; });
  out["second_hit_delay_s"] = each(truth.hits, [](const TrueHit& h) { return h.second_delay_s; });
  out["second_hit_peak_n"] = each(truth.hits, [](const TrueHit& h) { return h.second_peak_N; });
}

void add_bound(const Truth& truth, ordered_json& out) {
  if (!truth.bound) return;
  const auto relative = [&](const std::vector<double>& deviation, double SynthMode::*of, double scale) {
    ordered_json list = ordered_json::array();
    for (std::size_t r = 0; r < deviation.size(); ++r) list.push_back(deviation[r] / (truth.spec.modes[r].*of) * scale);
    return list;
  };
  out["crlb"] = {
      {"f_std_hz", truth.bound->freq_std_Hz},
      {"zeta_std", truth.bound->damping_ratio_std},
      {"f_std_ppm", relative(truth.bound->freq_std_Hz, &SynthMode::freq_Hz, 1e6)},
      {"zeta_std_pct", relative(truth.bound->damping_ratio_std, &SynthMode::damping_ratio, 100)},
      {"note", "known force, white noise on the accelerations, unknown f, zeta, A, rb; all hits of one run"}};
}

}  // namespace

std::string truth_json(const Truth& truth) {
  const SynthSpec& spec = truth.spec;
  ordered_json out;
  out["schema"] = "percuss/synth-truth/1";
  out["name"] = spec.name;
  out["seed"] = spec.seed;
  out["fs"] = spec.fs_Hz;
  out["samples"] = spec.samples;
  add_modes(truth, out);
  add_places(truth, out);
  add_hits(truth, out);
  out["noise"] = {{"accel_sigma", truth.accel_noise_mps2},
                  {"force_sigma", truth.force_noise_N},
                  {"accel_clean_rms", truth.accel_clean_rms_mps2}};
  add_bound(truth, out);
  out["raw_bytes"] = sizeof(double) * spec.samples * (spec.sensors.size() + 1) * rows_per_run(spec) * spec.runs;
  return out.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace percuss::synth
