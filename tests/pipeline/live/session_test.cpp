#include "pipeline/live/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::pipeline::session_test {

using acquire::RowMark;
using Kind = SessionEvent::Kind;
using testing::ElementsAre;

void strike(SessionState& session, int times, RowMark mark = RowMark::none) {
  for (int i = 0; i < times; ++i) session.apply({.kind = Kind::blow, .mark = mark});
}

TEST(SessionState, GoesFromPointToPoint) {
  SessionState session({.points = {4, 7, 9}, .hits = 2});
  EXPECT_EQ(session.point(), 4);
  strike(session, 1);
  strike(session, 3, RowMark::double_hit);
  EXPECT_EQ(session.point(), 4);
  EXPECT_EQ(session.accepted_at(4), 1U);
  strike(session, 1);
  EXPECT_EQ(session.point(), 7);
  strike(session, 4);
  EXPECT_TRUE(session.finished());
  EXPECT_TRUE(session.complete());
  EXPECT_THAT(session.accepted_rows(4), ElementsAre(0, 4));
  strike(session, 1);  // too late
  EXPECT_EQ(session.blows().size(), 9U);
}

TEST(SessionState, ReturnsToPointsThatWereSkipped) {
  SessionState session({.points = {0, 1, 2}, .hits = 1});
  session.apply({.kind = Kind::next});
  EXPECT_EQ(session.point(), 1);
  session.apply({.kind = Kind::go_to, .point = 2});
  strike(session, 1);
  EXPECT_EQ(session.point(), 0);
  strike(session, 1);
  EXPECT_EQ(session.point(), 1);
  session.apply({.kind = Kind::go_to, .point = 5});  // not in the plan
  EXPECT_EQ(session.point(), 1);
  strike(session, 1);
  EXPECT_TRUE(session.finished());
}

// A blow that the analysis compares with the others of its point.
void strike_compared(SessionState& session, bool differ) { session.apply({.kind = Kind::blow, .differ = differ}); }
void strike_doubtfully(SessionState& session) { strike_compared(session, true); }

// The last blow of a point differs from the others. Four blows can show which one is wrong.
TEST(SessionState, StaysAtAPointInDoubt) {
  SessionState session({.points = {0, 1, 2}, .hits = 3});
  strike(session, 2);
  strike_doubtfully(session);
  EXPECT_EQ(session.point(), 0);
  EXPECT_EQ(session.complete_points(), 0U);
  strike(session, 1, RowMark::double_hit);  // is not compared
  EXPECT_EQ(session.point(), 0);
  session.apply({.kind = Kind::regraded, .mark = RowMark::outlier, .row = 2});
  strike_compared(session, false);
  EXPECT_EQ(session.point(), 1);
  strike(session, 2);
  strike_doubtfully(session);
  EXPECT_EQ(session.point(), 1);
  strike_doubtfully(session);  // four are enough, whatever they tell
  EXPECT_EQ(session.point(), 2);
  EXPECT_THAT(session.doubtful_points(), ElementsAre(1));
}

// The first blow of a point was the wrong one: the next blows differ from it, until four show which one is the outlier.
TEST(SessionState, StaysUntilFourBlowsTellThatTheFirstWasWrong) {
  SessionState session({.points = {0, 1}, .hits = 2});
  strike(session, 1);
  strike_doubtfully(session);
  strike_doubtfully(session);
  EXPECT_EQ(session.point(), 0);
  session.apply({.kind = Kind::regraded, .mark = RowMark::outlier, .row = 0});
  strike_compared(session, false);
  EXPECT_EQ(session.point(), 1);
  EXPECT_THAT(session.doubtful_points(), testing::IsEmpty());
}

// Two blows at one place and two at another: one is rejected as an outlier, and the rest still differ.
TEST(SessionState, KeepsTheDoubtWhereTheRestDiffers) {
  SessionState session({.points = {0, 1}, .hits = 3});
  strike(session, 1);
  strike_doubtfully(session);
  strike_doubtfully(session);
  session.apply({.kind = Kind::regraded, .mark = RowMark::outlier, .row = 0});
  strike_doubtfully(session);
  EXPECT_EQ(session.point(), 0);
}

TEST(SessionState, KeepsAPointInDoubtOpen) {
  SessionState session({.points = {0, 1}, .hits = 2});
  strike(session, 1);
  strike_doubtfully(session);
  EXPECT_TRUE(session.needs_blows_to_compare());
  session.apply({.kind = Kind::next});
  strike(session, 2);
  EXPECT_EQ(session.point(), 0);  // comes again
  EXPECT_EQ(session.complete_points(), 1U);
  EXPECT_FALSE(session.finished());
  strike(session, 2);
  EXPECT_TRUE(session.finished());
  EXPECT_THAT(session.doubtful_points(), ElementsAre(0));
}

// If the blows differ at the majority of points, the cause is noise.
TEST(SessionState, DoesNotStayWhereNoiseMakesBlowsDiffer) {
  SessionState session({.points = {0, 1, 2, 3}, .hits = 2});
  for (int point = 0; point < 3; ++point) {
    EXPECT_EQ(session.point(), point);
    strike(session, 1);
    for (int i = 0; i < 3; ++i) strike_doubtfully(session);
  }
  EXPECT_EQ(session.point(), 3);
  strike(session, 1);
  strike_doubtfully(session);
  EXPECT_TRUE(session.finished());
}

TEST(SessionState, SkipsToAPointThatLacksBlows) {
  SessionState session({.points = {0, 1, 2}, .hits = 1});
  strike(session, 1);
  session.apply({.kind = Kind::go_to, .point = 2});
  session.apply({.kind = Kind::next});
  EXPECT_EQ(session.point(), 1);
  strike(session, 1);
  session.apply({.kind = Kind::next});  // no other point lacks blows
  EXPECT_EQ(session.point(), 2);
}

TEST(SessionState, UndoesTheLastAcceptedBlowAndRepeatsPoints) {
  SessionState session({.points = {0, 1}, .hits = 2});
  strike(session, 2);
  EXPECT_EQ(session.point(), 1);
  session.apply({.kind = Kind::undo});
  EXPECT_EQ(session.point(), 0);
  EXPECT_EQ(session.blows()[1].mark, RowMark::undone);
  strike(session, 1);
  EXPECT_EQ(session.point(), 1);
  strike(session, 1);
  session.apply({.kind = Kind::redo, .point = 1});
  EXPECT_EQ(session.accepted_at(1), 0U);
  EXPECT_EQ(session.blows()[3].mark, RowMark::redone);
  EXPECT_EQ(session.accepted_at(0), 2U);
  session.apply({.kind = Kind::finish});
  EXPECT_TRUE(session.finished());
  EXPECT_FALSE(session.complete());
}

TEST(SessionState, CountsAnOutlierNoLonger) {
  SessionState session({.hits = 3});
  strike(session, 2);
  session.apply({.kind = Kind::regraded, .mark = RowMark::outlier, .row = 0});
  EXPECT_EQ(session.accepted(), 1U);
  strike(session, 2);
  EXPECT_TRUE(session.finished());
}

TEST(SessionState, AcceptsFewerBlowsThatSuffice) {
  SessionState session({.points = {0, 1}, .hits = 50});
  strike(session, 3);
  session.apply({.kind = Kind::enough});
  EXPECT_EQ(session.point(), 1);
  session.apply({.kind = Kind::enough});  // ignored at a point without blows
  EXPECT_FALSE(session.finished());
}

TEST(SessionState, PausesAndGoesOn) {
  SessionState session({});
  session.apply({.kind = Kind::pause});
  EXPECT_TRUE(session.paused());
  session.apply({.kind = Kind::pause});
  EXPECT_FALSE(session.paused());
}

TEST(SessionEvents, AreTheSameAfterJson) {
  for (const Kind kind : {Kind::blow, Kind::regraded, Kind::undo, Kind::redo, Kind::next, Kind::go_to, Kind::pause,
                          Kind::finish, Kind::enough}) {
    SessionEvent event{.kind = kind, .frame = 123456789012345};
    if (kind == Kind::blow || kind == Kind::go_to) event.point = 17;
    if (kind == Kind::regraded) event.row = 3;
    if (kind == Kind::blow || kind == Kind::regraded) event.mark = RowMark::still_ringing;
    if (kind == Kind::blow) {
      event.message = "channel \"3\" is silent";
      event.peak_N = 0.1 + 0.2;
      event.bandwidth_Hz = 1e4 / 3;
      event.differ = true;
    }
    const std::string json = json_of(event);
    EXPECT_EQ(json.find('\n'), std::string::npos);
    EXPECT_EQ(parse_session_event(json, "journal"), event) << json;
  }
}

TEST(SessionEvents, RefuseWhatTheyDoNotKnow) {
  for (const char* text : {"", "{", "[]", R"({"event": "blow"})", R"({"event": "dance", "frame": 1})",
                           R"({"event": "blow", "frame": 1, "mark": "ugly"})", R"({"event": "blow", "frame": -1})"})
    EXPECT_THROW(parse_session_event(text, "journal"), InputError) << text;
}

}  // namespace percuss::pipeline::session_test
