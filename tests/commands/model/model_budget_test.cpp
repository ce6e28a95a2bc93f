#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// Models whose computation can take long end within their budget.
namespace percuss::model_budget_test {

using test::run_percuss;
using testing::HasSubstr;

struct LongModel {
  const char* command;
  std::vector<std::string> options;  // take seconds to minutes without a budget
};

std::ostream& operator<<(std::ostream& out, const LongModel& model) { return out << model.command; }

class ModelBudget : public testing::TestWithParam<LongModel> {
 protected:
  ModelBudget() { test::write_bytes(folder_.file("bat.csv"), "end,diameter\n2,50\n40,26\n50,40\n82,62\n"); }

  test::ProcessOutcome run(const std::string& budget) const {
    std::vector<std::string> words{"model", GetParam().command, "--budget", budget};
    words.insert(words.end(), GetParam().options.begin(), GetParam().options.end());
    return run_percuss(words, {.folder = folder_.path()});
  }

  test::ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(
    , ModelBudget,
    testing::Values(LongModel{"impact", {"--modes", "100", "--sweep", "at=0:0.0001:0.5"}},
                    LongModel{"impact", {"--modes", "100", "--method", "small-increment", "--step", "5e-8"}},
                    LongModel{"trampoline", {"--hoop", "1:1:9999"}},
                    LongModel{"bat", {"--profile", "bat.csv", "--profile-unit", "cm:mm", "--at", "0:0.0001:0.82"}}));

TEST_P(ModelBudget, EndsALongModel) {
  constexpr double kMax_s = 5;  // processor time; the budget is far below, and sanitizers slow the start
  const test::ProcessOutcome timed = run("0.05");
  EXPECT_EQ(timed.code, 4) << timed.err;
  EXPECT_THAT(timed.err, HasSubstr("the model is not finished after its budget of 0.05 s (model " +
                                   std::string(GetParam().command)));
  EXPECT_THAT(timed.err, HasSubstr("raise the budget (--budget)"));
  EXPECT_LT(timed.processor_s, kMax_s);
}

TEST_P(ModelBudget, LimitsMemoryToo) {
  const test::ProcessOutcome outcome = run("100,1e-9");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("the model needs more memory than its budget of 1e-09 GB"));
}

TEST(ModelBudgets, ChangeNoResultThatIsFinished) {
  const std::vector<std::string> words{"model", "impact", "--json"};
  auto limited = words;
  limited.insert(limited.end(), {"--budget", "1000,64"});
  EXPECT_EQ(run_percuss(limited).out, run_percuss(words).out);
}

}  // namespace percuss::model_budget_test
