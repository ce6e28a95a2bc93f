#include "pipeline/live/session_quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/live/live_source.hpp"

namespace percuss::pipeline::session_quality_test {

using test::struck_tube;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> texts_of(const std::vector<SessionProblem>& problems) {
  std::vector<std::string> out;
  out.reserve(problems.size());
  for (const SessionProblem& problem : problems) out.push_back(problem.text);
  return out;
}

// A hammer that is connected the wrong way round is reported during the session, not only afterwards.
TEST(SessionQuality, NamesWhatMakesResultsWrong) {
  acquire::Record tube = struck_tube("0.4", 1);
  const auto problems = [&](double sign) {
    acquire::Record record = tube;
    record.read_force_N = [read = tube.read_force_N, sign](std::size_t row, std::size_t first, std::span<double> out) {
      read(row, first, out);
      for (double& value : out) value *= sign;
    };
    return texts_of(session_quality(std::move(record), {}).problems);
  };
  EXPECT_THAT(problems(1), testing::IsEmpty());
  EXPECT_THAT(problems(-1), ElementsAre(HasSubstr("wrong sign")));
}

// A fault of the set-up, which further blows would repeat, is reported at once, too.
TEST(SessionQuality, NamesWhatIsWrongWithTheSetUp) {
  acquire::Record record = struck_tube("0.4", 1);
  for (acquire::SignalInfo& signal : record.accel) signal.angle_rad.reset();
  EXPECT_THAT(texts_of(session_quality(std::move(record), {}).problems),
              ElementsAre(HasSubstr("two accelerometers taken as 0° and 90° on a tube")));
}

}  // namespace percuss::pipeline::session_quality_test
