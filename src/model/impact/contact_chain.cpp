#include "model/impact/contact_chain.hpp"

#include <algorithm>
#include <utility>

#include "model/impact/contact_pass.hpp"
#include "model/impact/free_motion.hpp"

namespace percuss::model {
namespace {

constexpr std::size_t kMaxContacts = 200;

}  // namespace

ContactChain contact_chain(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s,
                           BallOnBeamState separated, double contact_s) {
  ContactChain chain{.last_separation_s = contact_s};
  BallOnBeamState state = std::move(separated);
  while (chain.contacts < kMaxContacts) {
    const FreeMotion free(system, state);
    const auto touch_s = free.next_contact_s(kFollowUp_s);
    if (!touch_s) {
      chain.complete = free.opens();
      break;
    }
    system.move_freely(state, *touch_s);
    const BallOnBeamReading touch = system.read(state);
    if (!(state.ball_mps > touch.beam_mps)) break;  // a graze: rounding decides about the contact
    state.ball_m = touch.beam_m;
    state.lost_J += touch.energy_J - system.read(state).energy_J;
    ContactPass pass(system, impact, method, step_s, state);
    const ImpactResult contact = pass.run(false);
    state = pass.end();
    ++chain.contacts;
    chain.last_separation_s += *touch_s + contact.contact_s;
    chain.energy_error = std::max(chain.energy_error, contact.energy_error);
  }
  chain.ball_mps = state.ball_mps;
  return chain;
}

}  // namespace percuss::model
