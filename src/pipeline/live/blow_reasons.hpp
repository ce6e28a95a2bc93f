#pragma once
#include <string>

#include "acquire/record/row_mark.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/live/blow_grading.hpp"

namespace percuss::pipeline {

/// Why a blow does not count: what is wrong and what to do. Without a mark there is no reason.
struct BlowReason {
  acquire::RowMark mark = acquire::RowMark::none;
  std::string reason, remedy;
};

/// Samples that are lost, end early or are no numbers; a channel that is silent.
BlowReason judge_capture(const BlowSamples& samples, const BlowCircumstances& at, const BlowContext& context);
/// A run of equal samples that is too long to predict the motion in it. `hit`: from the analysis of this blow alone.
BlowReason judge_dropouts(const acquire::Hit& hit, const BlowSamples& samples, const BlowContext& context);
/// A signal that reached full scale.
BlowReason judge_range(const BlowCircumstances& at, const BlowContext& context);
/// A pulse that is late, clipped, double, not clean, too weak or too narrow in frequency.
BlowReason judge_force(const acquire::Hit& hit, const BlowCircumstances& at, const BlowContext& context);
/// Responses that are clipped, silent or still ringing, and what the analysis of all blows of the point rejects.
BlowReason judge_responses(const AnalysedHit& hit, const BlowCircumstances& at, const BlowContext& context);
/// A structure that still moves. `motion`: motion_before() of the blow.
BlowReason judge_motion(double motion, const BlowCircumstances& at);

/// The rms motion before the blow over the rms response just after it: the largest of the channels whose motion exceeds
/// the noise. 0 without such a channel.
double motion_before(const BlowSamples& samples, const BlowCircumstances& at);

/// Why the analysis of all blows of the point rejects this one.
acquire::RowMark mark_of(const AnalysedHit& hit);

}  // namespace percuss::pipeline
