#include "pipeline/live/session_faults.hpp"

#include <gtest/gtest.h>

namespace percuss::pipeline::session_faults_test {

// A session that was killed before its first blow, resumed and killed again. Nothing is missing at the first resume, so
// the file does not state it.
TEST(SessionFaults, LeavesOutAResumeBeforeTheFirstSample) {
  using acquire::CaptureFault;
  SessionFaults faults(1000);
  faults.add_past({.fault = CaptureFault::resumed, .frame = 0}, 500);
  EXPECT_TRUE(faults.for_record({}).empty());
  faults.add_past({.fault = CaptureFault::gap, .frame = 400, .count = 100}, 500);
  ASSERT_EQ(faults.for_record({}).size(), 1U);
  EXPECT_EQ(faults.for_record({})[0].kind, acquire::FaultKind::gap);
}

}  // namespace percuss::pipeline::session_faults_test
