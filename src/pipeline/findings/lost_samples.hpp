#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "acquire/record/sample_gap.hpp"
#include "pipeline/findings/sample_faults.hpp"

namespace percuss::pipeline {

/// A gap of a record within a free decay of its row.
struct GapInDecay {
  acquire::SampleGap gap;
  DecayRange decay;  // samples of the row: the free decay around the gap
};

/// Whether the samples of a gap can be predicted: at most kMaxFault, with enough samples of the decay around them.
bool can_predict(const GapInDecay& at);

/// The record with the responses of these gaps replaced by predictions from the decay on both sides. A gap whose
/// prediction does not fit the samples around it keeps the reader's straight line, and its index is added to `failed`.
/// errors  InputError: samples that cannot be read.
acquire::Record with_predicted_samples(const acquire::Record& record, const std::vector<GapInDecay>& gaps,
                                       std::vector<std::size_t>& failed);

/// "3 samples", for the count of a gap.
std::string samples_text(std::size_t count);

}  // namespace percuss::pipeline
