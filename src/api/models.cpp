#include "percuss/models.hpp"

#include <algorithm>
#include <cmath>

#include "api/handles.hpp"
#include "core/error.hpp"
#include "model/bat/bat_collision.hpp"
#include "model/bat/rigid_collision.hpp"
#include "model/impact/impact.hpp"
#include "model/shell/shell.hpp"
#include "model/trampoline/trampoline.hpp"

namespace percuss {
namespace api {
namespace {

model::BeamSupport internal_support(BeamSupport support) {
  switch (support) {
    case BeamSupport::torsion:
      return model::BeamSupport::torsion;
    case BeamSupport::pinned:
      return model::BeamSupport::pinned;
    case BeamSupport::clamped:
      return model::BeamSupport::clamped;
    default:
      return model::BeamSupport::free;
  }
}

model::UniformBeam uniform_beam(const Beam& beam) {
  require_above_zero(beam.ei_Nm2, "Beam::ei_Nm2");
  require_above_zero(beam.rho_a_kgpm, "Beam::rho_a_kgpm");
  require_above_zero(beam.length_m, "Beam::length_m");
  model::UniformBeam out{.support = model::BeamSupport::free,
                         .stiffness_Nm2 = beam.ei_Nm2,
                         .mass_per_length_kgpm = beam.rho_a_kgpm,
                         .torsion_Nmprad = beam.torsion_Nmprad,
                         .length_m = beam.length_m,
                         .gyration_m = beam.gyration_m,
                         .shear_stiffness_N = beam.shear_stiffness_N};
  if (beam.support == BeamSupport::torsion) require_above_zero(beam.torsion_Nmprad, "Beam::torsion_Nmprad");
  out.support = internal_support(beam.support);
  return out;
}

model::RigidCollision rigid_collision(const RigidBat& bat) {
  return {.ball_mass_kg = bat.ball_mass_kg,
          .bat_mass_kg = bat.bat_mass_kg,
          .inertia_kgm2 = bat.inertia_kgm2,
          .ball_speed_mps = bat.ball_speed_mps,
          .swing_rate_radps = bat.swing_rate_radps,
          .bat_speed_mps = bat.bat_speed_mps,
          .restitution = bat.cor};
}

model::Trampoline trampoline(const Trampoline& model) {
  require_above_zero(model.ball_mass_kg, "Trampoline::ball_mass_kg");
  require_above_zero(model.barrel_mass_kg, "Trampoline::barrel_mass_kg");
  require_above_zero(model.ball_speed_mps, "Trampoline::ball_speed_mps");
  return {.ball_mass_kg = model.ball_mass_kg,
          .stiffness = model.stiffness,
          .damping = model.damping,
          .stiffness_exponent = model.stiffness_exponent,
          .damping_exponent = model.damping_exponent,
          .barrel_mass_kg = model.barrel_mass_kg,
          .barrel_damping_Nspm = model.barrel_damping_Nspm,
          .extra_mass_kg = 0,
          .ball_speed_mps = model.ball_speed_mps};
}

TrampolineRebound rebound_of(const model::Rebound& rebound) {
  return {.cor = rebound.cor, .contact_s = rebound.contact_s, .contacts = rebound.contacts};
}

void check_profile(const BatProfile& profile) {
  if (profile.end_m.empty() || profile.end_m.size() != profile.diameter_m.size())
    throw InputError("no slices, or ends and diameters differ in number", "BatProfile", "give one diameter per slice");
  if (!profile.wall_m.empty() && profile.wall_m.size() != profile.end_m.size())
    throw InputError("ends and walls differ in number", "BatProfile", "give one wall per slice, or none");
  double start_m = profile.points ? -1 : 0;
  for (const double end_m : profile.end_m) {
    if (!(end_m > start_m && end_m >= 0 && std::isfinite(end_m)))
      throw InputError("the ends of the slices do not ascend", "BatProfile::end_m", "count from the knob");
    start_m = end_m;
  }
  for (const double diameter_m : profile.diameter_m) require_above_zero(diameter_m, "BatProfile::diameter_m");
  for (const double wall_m : profile.wall_m) require_above_zero(wall_m, "BatProfile::wall_m");
  require_above_zero(profile.end_m.back(), "BatProfile::end_m");
  require_above_zero(profile.density_kgpm3, "BatProfile::density_kgpm3");
  require_above_zero(profile.young_Pa, "BatProfile::young_Pa");
  require_above_zero(profile.shear_Pa, "BatProfile::shear_Pa");
  const double length_m = profile.end_m.back();
  for (const BatMass& one : profile.added) {
    require_above_zero(one.mass_kg, "BatMass::mass_kg");
    if (!(one.from_m >= 0 && one.to_m >= one.from_m && one.to_m <= length_m))
      throw InputError("the mass is not on the bat", "BatMass", "give positions from the knob");
  }
  if (profile.support == BeamSupport::free) return;
  if (!(profile.support_m >= 0 && profile.support_m <= length_m))
    throw InputError("the support is not on the bat", "BatProfile::support_m", "give a position from the knob");
  if (profile.support == BeamSupport::torsion) require_above_zero(profile.torsion_Nmprad, "BatProfile::torsion_Nmprad");
}

model::BatModes modes_of_profile(const BatProfile& profile, std::size_t modes) {
  check_profile(profile);
  model::BeamStructure bat = model::structure_of(
      {.end_m = profile.end_m, .diameter_m = profile.diameter_m},
      {.density_kgpm3 = profile.density_kgpm3, .young_Pa = profile.young_Pa, .shear_Pa = profile.shear_Pa});
  if (profile.points) bat.table.kind = model::ProfileKind::points;
  for (std::size_t i = 0; i < profile.wall_m.size(); ++i)
    bat.table.stations[i].layers[0].thickness_m = profile.wall_m[i];
  for (const BatMass& one : profile.added)
    bat.added.push_back({.mass_kg = one.mass_kg, .from_m = one.from_m, .to_m = one.to_m});
  bat.support = {
      .kind = internal_support(profile.support), .at_m = profile.support_m, .torsion_Nmprad = profile.torsion_Nmprad};
  return model::bat_modes(bat, {.modes = modes});
}

model::TubeShell shell_of(const Tube& tube, std::size_t n) {
  require_above_zero(tube.wall_m, "Tube::wall_m");
  require_above_zero(tube.length_m, "Tube::length_m");
  require_above_zero(tube.young_Pa, "Tube::young_Pa");
  require_above_zero(tube.density_kgpm3, "Tube::density_kgpm3");
  if (!(tube.wall_m < tube.outer_diameter_m / 2))
    throw InputError("the wall is not thinner than the radius", "Tube::wall_m", "give a smaller one");
  if (!(tube.poisson >= 0 && tube.poisson < 0.5))
    throw InputError("not a Poisson's ratio", "Tube::poisson", "give a number from 0 to below 0.5");
  if (n < 2) throw InputError("a hoop mode has two or more waves around the circumference", "n", "give 2 or more");
  return {.outer_diameter_m = tube.outer_diameter_m,
          .wall_m = tube.wall_m,
          .length_m = tube.length_m,
          .young_Pa = tube.young_Pa,
          .density_kgpm3 = tube.density_kgpm3,
          .poisson = tube.poisson};
}

}  // namespace
}  // namespace api

std::vector<BeamMode> beam_modes(const Beam& beam, const BeamModeOptions& options) {
  std::vector<BeamMode> out;
  for (const model::BeamMode& mode : model::beam_modes(api::uniform_beam(beam), options.modes)) {
    out.push_back({.freq_Hz = mode.freq_Hz(), .lambda = mode.lambda, .node_m = model::beam_nodes_m(mode), .shape = {}});
    for (const double x_m : options.x_m) out.back().shape.push_back(mode.shape(x_m));
  }
  return out;
}

BeamImpactResult beam_impact(const BeamImpact& impact) {
  api::require_above_zero(impact.ball_mass_kg, "BeamImpact::ball_mass_kg");
  api::require_above_zero(impact.speed_mps, "BeamImpact::speed_mps");
  api::require_above_zero(impact.hertz_Npm15, "BeamImpact::hertz_Npm15");
  if (!(impact.at_m >= 0 && impact.at_m <= impact.beam.length_m))
    throw InputError("the impact is not on the beam", "BeamImpact::at_m",
                     "give a position between 0, the supported end, and the length");
  if (impact.beam.gyration_m > 0 || impact.beam.shear_stiffness_N > 0) {
    throw InputError("an impact is computed on Euler–Bernoulli beams only", "BeamImpact::beam",
                     "leave out the radius of gyration and the shear stiffness");
  }
  const model::ImpactResult result = model::simulate_impact({.beam = api::uniform_beam(impact.beam),
                                                             .at_m = impact.at_m,
                                                             .ball_mass_kg = impact.ball_mass_kg,
                                                             .speed_mps = impact.speed_mps,
                                                             .hertz_Npm15 = impact.hertz_Npm15,
                                                             .hysteresis_spm = impact.hysteresis_spm,
                                                             .modes = impact.modes},
                                                            {.step_s = impact.step_s});
  return {.cor = result.cor,
          .contact_s = result.contact_s,
          .peak_force_N = result.peak_force_N,
          .peak_deflection_m = result.peak_deflection_m,
          .peak_deflection_time_s = result.peak_deflection_time_s,
          .recontact_s = result.recontact_s,
          .contacts = result.contacts,
          .final_cor = result.final_cor,
          .energy_error = result.energy_error};
}

double effective_mass_kg(const RigidBat& bat, double z_m) {
  return model::effective_mass_kg(api::rigid_collision(bat), z_m);
}

double exit_speed_mps(const RigidBat& bat, double z_m) { return model::exit_speed_mps(api::rigid_collision(bat), z_m); }

double best_impact_m(const RigidBat& bat, double low_m, double high_m) {
  return model::best_impact(api::rigid_collision(bat), low_m, high_m).z_m;
}

TrampolineRebound trampoline_rebound(const Trampoline& model, double hoop_Hz) {
  api::require_above_zero(hoop_Hz, "hoop_Hz");
  return api::rebound_of(model::rebound(api::trampoline(model), hoop_Hz));
}

TrampolineRebound rigid_wall_rebound(const Trampoline& model) {
  return api::rebound_of(model::rigid_wall_rebound(api::trampoline(model)));
}

BatModes bat_modes(const BatProfile& profile, std::size_t modes) {
  const model::BatModes bat = api::modes_of_profile(profile, modes);
  BatModes out{.mass_kg = bat.inertia.mass_kg,
               .cm_m = bat.inertia.cm_m,
               .inertia_kgm2 = bat.inertia.inertia_kgm2,
               .freq_Hz = {bat.freq_Hz.data(), bat.freq_Hz.data() + bat.freq_Hz.size()},
               .node_m = {}};
  for (std::size_t m = 0; m < out.freq_Hz.size(); ++m) out.node_m.push_back(model::nodes_of(bat, m));
  return out;
}

std::vector<double> bat_exit_speeds_mps(const BatProfile& profile, const std::vector<double>& z_m,
                                        const BatCollision& collision) {
  const model::BatModes bat = api::modes_of_profile(profile, collision.modes);
  for (const double z : z_m) {
    if (!(z >= 0 && z <= bat.length_m))
      throw InputError("the impact is not on the bat", "z_m", "give positions from the knob");
  }
  const model::BatCollision internal{.ball = {.mass_kg = collision.ball_mass_kg, .restitution = collision.cor},
                                     .ball_speed_mps = collision.ball_speed_mps,
                                     .bat_speed_mps = collision.bat_speed_mps,
                                     .swing_rate_radps = collision.swing_rate_radps};
  std::vector<double> out;
  for (const model::BatRebound& rebound :
       model::bat_sweep(bat, static_cast<std::size_t>(bat.freq_Hz.size()), internal, z_m))
    out.push_back(rebound.exit_speed_mps);
  return out;
}

double hoop_Hz(const Tube& tube, std::size_t n, std::size_t m) {
  return model::flugge_Hz(api::shell_of(tube, n), n, std::max<std::size_t>(m, 1));
}

double long_hoop_Hz(const Tube& tube, std::size_t n) { return model::rayleigh_Hz(api::shell_of(tube, n), n); }

}  // namespace percuss
