#include "metrics/protocol/abi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics {
namespace {

const char* action_of(AbiStep step) {
  switch (step) {
    case AbiStep::roll:
      return "roll the barrel";
    case AbiStep::first_performance:
    case AbiStep::performance:
      return "test the performance";
    default:
      return "measure the barrel's compression";
  }
}

const char* kind_of(const AbiEntry& entry) {
  if (std::holds_alternative<AbiCompression>(entry.what)) return "a compression";
  return std::holds_alternative<AbiRoll>(entry.what) ? "a rolling" : "a performance test";
}

// The evaluation of one log.
class AbiEvaluation {
 public:
  AbiEvaluation(const AbiLog& log, const AbiRules& rules) : log_(log), rules_(rules) {}

  AbiRun run() {
    run_.displacement_in = log_.displacement_in.value_or(rules_.displacement_in);
    for (const AbiEntry& entry : log_.entries) take(entry);
    return std::move(run_);
  }

 private:
  void take(const AbiEntry& entry) {
    entry_ = &entry;
    if (run_.next == AbiStep::done) {
      throw InputError(fmt::format("{} after the procedure's end ({})", kind_of(entry), run_.why), entry.place,
                       "remove it; after a failure, continued_after_failure: true continues the test for the sponsor");
    }
    switch (run_.next) {
      case AbiStep::roll:
        return rolled(expected<AbiRoll>());
      case AbiStep::first_performance:
      case AbiStep::performance:
        return tested(expected<AbiPerformance>());
      default:
        check_displacement(expected<AbiCompression>());
        return compressed(expected<AbiCompression>().mean_lbf());  // (P13)
    }
  }

  template <class What>
  const What& expected() const {
    if (const What* what = std::get_if<What>(&entry_->what)) return *what;
    throw InputError(fmt::format("step {} comes next ({}), not {}", static_cast<int>(run_.next), action_of(run_.next),
                                 kind_of(*entry_)),
                     entry_->place, "enter the steps in the order of the procedure");
  }

  // Forces at different displacements are not comparable: the displacement of the first compression holds for all.
  void check_displacement(const AbiCompression& compression) {
    const double now_in = compression.displacement_in.value_or(run_.displacement_in);
    if (!log_.displacement_in && run_.compressions.empty()) run_.displacement_in = now_in;
    if (std::abs(now_in - run_.displacement_in) > kReadingTolerance) {
      throw InputError(
          fmt::format("compressed by {:g} in, but the other compressions by {:g} in", now_in, run_.displacement_in),
          entry_->place, "use one displacement in the whole break-in");
    }
  }

  void compressed(double mean_lbf) {
    AbiReduction now{.step = run_.next, .cycle = run_.cycle, .roll = run_.roll, .mean_lbf = mean_lbf};
    if (run_.next == AbiStep::initial_compression) {
      run_.compressions.push_back(now);
      run_.next = AbiStep::first_performance;
      return;
    }
    // After a rolling, the reference is BC_i,0, the compression before the first rolling of the cycle. After a test,
    // the reference is the last compression before the test.
    const bool after_roll = run_.next == AbiStep::compression_after_roll;
    const double before_lbf = after_roll ? unrolled_lbf_ : run_.compressions.back().mean_lbf;
    const double reduction = (before_lbf - mean_lbf) / before_lbf;  // (P14)
    now.reduction = reduction;
    run_.compressions.push_back(now);
    if (after_roll) {
      judge_rolling(reduction);
    } else {
      unrolled_lbf_ = mean_lbf;
      run_.roll = 0;
      run_.next = reduction > rules_.skip_reduction + kReadingTolerance ? AbiStep::performance : AbiStep::roll;
    }
    if (run_.next == AbiStep::roll) end_beyond_max_depth();
  }

  // Step 6.
  void judge_rolling(double reduction) {
    const bool enough = reduction >= rules_.min_reduction - kReadingTolerance;
    run_.next = enough ? AbiStep::performance : AbiStep::roll;
    if (reduction > 2 * rules_.min_reduction) {
      remark("overshoot", fmt::format("cycle {}: the compression fell by {:.1f} %; aim for {:g} %, or slightly more",
                                      run_.cycle, 100 * reduction, 100 * rules_.min_reduction));
    }
  }

  void end_beyond_max_depth() {
    if (next_depth_in(run_, rules_) <= rules_.max_depth_in) return;
    end(AbiVerdict::undecided,
        fmt::format("the barrel would have to be rolled deeper than {:g} in, the largest depth", rules_.max_depth_in));
  }

  void rolled(const AbiRoll& roll) {
    if (run_.depth_in && !(roll.depth_in > *run_.depth_in)) {
      throw InputError(
          fmt::format("step 4: rolled {:g} in deep, not deeper than the {:g} in before", roll.depth_in, *run_.depth_in),
          entry_->place, "give a depth about 0.0125 in above the last one");
    }
    const double asked_in = next_depth_in(run_, rules_);
    if (std::abs(roll.depth_in - asked_in) > rules_.depth_tolerance_in) {
      remark("roll_depth",
             fmt::format("rolled {:g} in deep; the procedure asks for about {:g} in", roll.depth_in, asked_in));
    }
    run_.depth_in = roll.depth_in;
    ++run_.roll;
    run_.next = AbiStep::compression_after_roll;
  }

  // Steps 2 and 7, and the compliance check of step 8.
  void tested(const AbiPerformance& test) {
    ++run_.cycle;
    const double best = run_.cycles.empty() ? test.value : std::max(run_.cycles.back().best, test.value);
    std::string id = !test.id.empty()  ? test.id
                     : run_.cycle == 1 ? log_.bat
                                       : fmt::format("{}-{}", log_.bat, run_.cycle);
    run_.cycles.push_back({.cycle = run_.cycle,
                           .value = test.value,
                           .best = best,
                           .hoop_Hz = test.hoop_Hz,
                           .z_in = test.z_in,
                           .id = std::move(id)});
    const bool first = run_.cycle == 1;
    run_.next = first ? AbiStep::compression_after_first : AbiStep::compression_after_performance;
    run_.roll = 0;
    if (first && (test.damage || test.broken))
      return end(AbiVerdict::fail,
                 test.broken ? "broken in the first performance test" : "damaged in the first performance test");
    if (log_.limit && test.value > *log_.limit) {
      const std::string why =
          fmt::format("cycle {}: {:g} exceeds the limit of {:g}", run_.cycle, test.value, *log_.limit);
      if (!log_.continued) return end(AbiVerdict::fail, why);
      if (run_.verdict != AbiVerdict::fail) run_.why = why;
      run_.verdict = AbiVerdict::fail;
    }
    const double drop = best - test.value, asked = log_.bbcor ? rules_.pass_drop_bbcor : rules_.pass_drop_besr;
    if (!first && drop >= asked - kReadingTolerance)
      return end(AbiVerdict::pass, fmt::format("cycle {}: {:.4f} below the best of {:g}", run_.cycle, drop, best));
    if (test.broken) return end(AbiVerdict::undecided, "the bat broke before its performance fell");
    if (run_.cycle >= rules_.max_cycles)
      end(AbiVerdict::undecided, fmt::format("the performance does not fall in {} tests", run_.cycle));
  }

  // A failure is final. Without a limit, a bat cannot pass.
  void end(AbiVerdict verdict, const std::string& why) {
    if (verdict == AbiVerdict::pass && !log_.limit) verdict = AbiVerdict::undecided;
    if (run_.verdict != AbiVerdict::fail) {
      run_.verdict = verdict;
      run_.why = why;
    }
    run_.next = AbiStep::done;
  }

  void remark(const char* code, std::string message) { run_.remarks.push_back({code, std::move(message)}); }

  const AbiLog& log_;
  const AbiRules& rules_;
  const AbiEntry* entry_ = nullptr;
  double unrolled_lbf_ = 0;  // BC_i,0
  AbiRun run_;
};

}  // namespace

const char* name_of(AbiVerdict verdict) {
  switch (verdict) {
    case AbiVerdict::pass:
      return "pass";
    case AbiVerdict::fail:
      return "fail";
    case AbiVerdict::undecided:
      return "undecided";
    case AbiVerdict::in_progress:
      break;
  }
  return "in_progress";
}

double next_depth_in(const AbiRun& run, const AbiRules& rules) {
  return run.depth_in ? *run.depth_in + rules.depth_step_in : rules.first_depth_in;
}

AbiRun evaluate_abi(const AbiLog& log, const AbiRules& rules) {
  AbiRun run = AbiEvaluation(log, rules).run();
  if (!log.material.empty() && log.material != "composite") {
    run.remarks.push_back(
        {"material", "the procedure applies to composite barrels, not to " + one_line(log.material, 40)});
  }
  if (run.displacement_in < rules.displacement_in - kReadingTolerance) {
    run.remarks.push_back(
        {"reduced_displacement", fmt::format("the barrel was compressed by {:g} in, not {:g} in: the protocol requires "
                                             "that every report of the tests states this",
                                             run.displacement_in, rules.displacement_in)});
  } else if (run.displacement_in > rules.displacement_in + kReadingTolerance) {
    run.remarks.push_back({"displacement", fmt::format("the barrel was compressed by {:g} in, the protocol asks for "
                                                       "{:g} in, or less for a barrel too stiff for the load cell",
                                                       run.displacement_in, rules.displacement_in)});
  }
  if (!log.limit)
    run.remarks.push_back({"no_limit", "no limit is given: the bat can neither pass nor fail by its performance"});
  return run;
}

std::string next_step_text(const AbiRun& run, const AbiRules& rules) {
  if (run.next == AbiStep::done)
    return fmt::format("{}: {}", run.verdict == AbiVerdict::undecided ? "no verdict" : name_of(run.verdict), run.why);
  std::string out = fmt::format("step {}: {}", static_cast<int>(run.next), action_of(run.next));
  if (run.next == AbiStep::roll) {
    out += fmt::format(", rollers about {:.4g} in deep, 10 times each way at 0, 90, 45 and -45 degrees",
                       next_depth_in(run, rules));
  }
  return out;
}

}  // namespace percuss::metrics
