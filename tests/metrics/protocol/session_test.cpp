#include "metrics/protocol/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "support/text_parts.hpp"

namespace percuss::metrics::session_test {

using test::input_error_of;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  return input_error_of([&] { parse_session(text, "s.json"); });
}

TEST(Session, ExampleReadsBackAndFollowsItsSchema) {
  const Session s = parse_session(session_example(), "s.json");
  EXPECT_EQ(s.bat.id, "AS001");
  EXPECT_EQ(s.limit, 0.728);
  ASSERT_EQ(s.shots.size(), 3U);
  EXPECT_EQ(s.shots[0].in_mph, 136.2);
  EXPECT_NEAR(s.shots[1].in_mph, (136.4 + 136.1 + 135.8) / 3, 1e-12);
  EXPECT_NEAR(s.shots[2].pairs_in_mph.at(1), 6 * kInch_m / 0.002507 / 0.44704, 1e-9);
  EXPECT_THAT(test::schema_violations(test::json_ignoring_comments(session_example()), test::schema_named("session")),
              testing::IsEmpty());
}

TEST(Session, ReadsTheSameFromATable) {
  const Session table = parse_session(session_table_example(), "s.csv");
  const Session s = parse_session(session_example(), "s.json");
  ASSERT_EQ(table.shots.size(), 2U);
  EXPECT_EQ(table.bat.length_in, s.bat.length_in);
  EXPECT_EQ(table.lot.correction, s.lot.correction);
  EXPECT_EQ(table.shots[0].ball, s.shots[0].ball);
  EXPECT_EQ(table.shots[0].ear, 1);
  EXPECT_EQ(table.shots[1].angle_deg, -2);
}

TEST(Session, TableMayUseSemicolonsDecimalCommasAndLists) {
  std::string text = session_table_example();
  text = text.substr(0, text.find("z_in,")) +
         "z_in;ball;ball_g;pairs_in_mph;v_out_mph;angle_deg\n6;0012;145,3;136,2 136,1 136,3;30,8;1,2\n";
  const Session s = parse_session(text, "s.csv");
  EXPECT_EQ(s.shots.at(0).ball, "0012");
  EXPECT_NEAR(s.shots[0].in_mph, 136.2, 1e-12);
  EXPECT_EQ(s.shots[0].ball_g, 145.3);
}

TEST(Session, FourGatesInARowMakeThreePairs) {
  const Session s =
      parse_session(test::replaced_once(session_example(), "[0.0, 0.002506, 0.004, 0.006507, 0.008, 0.010509]",
                                        "[0, 0.0025, 0.005, 0.0075]"),
                    "s.json");
  EXPECT_EQ(s.shots[2].pairs_in_mph.size(), 3U);
}

TEST(Session, ReadsHitsOfTheLotWithoutALocation) {
  const Session s = parse_session(
      test::replaced_once(
          session_example(), "\"correction\": ",
          R"("hits": [{"ball": "7", "ball_g": 145, "angle_deg": 1, "v_in_mph": 100, "v_out_mph": 40}], "correction": )"),
      "s.json");
  ASSERT_EQ(s.lot.hits.size(), 1U);
  EXPECT_EQ(s.lot.hits[0].ball, "7");
  EXPECT_EQ(s.lot.hits[0].out_mph, 40);
}

TEST(Session, NamesTheKeyThatIsWrong) {
  const std::string ok = session_example();
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"length_in\": 33", "\"length_in\": -3")), HasSubstr("bat.length_in"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"length_in\": 33", "\"lenght_in\": 33")), HasSubstr("bat.length_in"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"metric\": \"ncaa_besr\"", "\"metric\": \"speed\"")),
              HasSubstr("metric"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"range_in\": [3, 9]", "\"range_in\": [6, 9]")), HasSubstr("range_in"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"range_in\": [3, 9]", "\"range_in\": [3, 22]")), HasSubstr("range_in"));
  for (const char* range : {"[6]", "[0, 9]", "[3, 6.5]"}) {
    EXPECT_THAT(refusal(test::replaced_once(ok, "\"range_in\": [3, 9]", std::string("\"range_in\": ") + range)),
                HasSubstr("range_in"));
  }
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"ear\": 1", "\"ear\": 5")), HasSubstr("shots[0].ear"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"ear\": 1", "\"ear\": 0")), HasSubstr("shots[0].ear"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"v_in_mph\": 136.2", "\"v_in_mph\": 1362")), HasSubstr("1362 mph"));
  EXPECT_THAT(
      refusal(test::replaced_once(ok, "\"v_in_mph\": 136.2", "\"v_in_mph\": 136.2, \"pairs_in_mph\": [136, 136, 136]")),
      HasSubstr("more than one speed"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "[136.4, 136.1, 135.8]", "[136.4, -136.1, 135.8]")),
              HasSubstr("-136.1 mph"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "L12-001", std::string(81, 'x'))),
              HasSubstr("the ball's number is empty or longer"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"v_in_mph\": 136.2", "\"v_in_mph\": -136")),
              HasSubstr("shots[0].v_in_mph"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"v_in_mph\": 136.2, ", "")), HasSubstr("no speed"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "0.0, 0.002506", "0.1, 0.002506")), HasSubstr("shots[2].gates_in_s"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "0.0, 0.002506, 0.004, ", "")), HasSubstr("neither four nor six times"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "[136.4, 136.1, 135.8]", "[136.4, 136.1]")),
              HasSubstr("shots[1].pairs_in_mph"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "[136.4, 136.1, 135.8]", "[136.4, 13610, 135.8]")),
              HasSubstr("13610 mph"));
  EXPECT_THAT(
      refusal(test::replaced_once(ok, "\"ball\": \"" + parse_session(ok, "s").shots[0].ball + "\"", "\"ball\": \"\"")),
      HasSubstr("the ball's number is empty or longer"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "\"ball_g\": 145.3", "\"ball_g\": \"heavy\"")),
              HasSubstr("shots[0].ball_g"));
  EXPECT_THAT(refusal(test::replaced_once(ok, "percuss/session/1", "percuss/session/2")), HasSubstr("not a session"));
}

TEST(Session, NamesTheLineOfATable) {
  EXPECT_THAT(refusal(test::replaced_once(session_table_example(), "145.6", "-1")), HasSubstr("line 13.ball_g"));
  EXPECT_THAT(refusal(test::replaced_once(session_table_example(), "136.1,30.0", "136.1,30.0,1,1")),
              HasSubstr("line 13"));
  EXPECT_THAT(refusal(test::replaced_once(session_table_example(), "v_in_mph", "ball")), HasSubstr("two columns"));
  EXPECT_THAT(refusal(test::replaced_once(session_table_example(), "# bat.id = AS001", "# bat.id = a\n# bat.id = b")),
              HasSubstr("given twice"));
}

TEST(Session, RefusesOtherDocuments) {
  for (const char* text :
       {"", "{", "[]", "{}", "3", "a,b\n1,2\n", "{\"shots\": 3}", "\xFF\xFE", "# shots = 3\nz_in\n1\n"})
    EXPECT_THAT(refusal(text), HasSubstr("s.json")) << text;
  EXPECT_THAT(refusal(std::string("z_in\n\0", 6)), HasSubstr("this is not text"));
  EXPECT_THAT(refusal(std::string(100000, '[')), HasSubstr("s.json"));
  EXPECT_THAT(refusal("{\"a\":" + std::string(100000, '[')), HasSubstr("nested deeper"));
  EXPECT_THAT(refusal(std::string((std::size_t{16} << 20) + 1, ' ')), HasSubstr("longer than 16 MiB"));
}

TEST(Session, HoldsNoMoreThanAHundredThousandShots) {
  const std::string table = session_table_example(), head = table.substr(0, table.find('\n', table.find("z_in,")) + 1);
  const std::string row = table.substr(head.size(), table.find('\n', head.size()) + 1 - head.size());
  std::string text = head;
  for (int i = 0; i < 100001; ++i) text += row;
  EXPECT_THAT(refusal(text), HasSubstr("more than 100000 rows"));
  const std::string shot = R"({"z_in":6,"ball":"1","ball_g":145,"angle_deg":0,"v_in_mph":136,"v_out_mph":30})";
  std::string shots = shot;
  for (int i = 0; i < 100000; ++i) shots += "," + shot;
  EXPECT_THAT(refusal(R"({"bat":{"id":"b","length_in":33,"days_in_lab":3},"ball_lot":{"days_in_lab":20},)"
                      R"("lab":{"temperature_f":72,"humidity_percent":50},"shots":[)" +
                      shots + "]}"),
              HasSubstr("more than 100000 shots"));
}

}  // namespace percuss::metrics::session_test
