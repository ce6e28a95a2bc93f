#include "acquire/record/joined_notes.hpp"

#include <gtest/gtest.h>

#include "acquire/record/note_codes.hpp"

namespace percuss::acquire {
namespace {

TEST(JoinedNotes, NameTheFilesOfANoteThatConcernsOnlySome) {
  const Message common("common"), own = information("own");
  const std::vector<Message> notes = joined_notes({{"a", {common, own}}, {"b", {common}}, {"c", {common, own}}});
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], common);
  EXPECT_EQ(notes[1], information("a and 1 more: own"));
}

TEST(JoinedNotes, KeepTheCodeOfAnAssumedUnit) {
  const std::vector<Message> notes =
      joined_notes({{"a", {with_code("no unit", kResponseUnitAssumed)}}, {"b", {Message("other")}}});
  EXPECT_EQ(notes.front(), with_code("a: no unit", kResponseUnitAssumed));
}

// The warning about a reversed phase replaces those about missing modes: the FRFs of other files can have modes.
TEST(JoinedNotes, SayReversedPhaseOnlyOfAllFiles) {
  const Message reversed = with_code("reversed", kReversedPhase);
  EXPECT_EQ(joined_notes({{"a", {reversed}}, {"b", {reversed}}}).front().code, kReversedPhase);
  EXPECT_EQ(joined_notes({{"a", {reversed}}, {"b", {}}}).front(), Message("a: reversed"));
}

}  // namespace
}  // namespace percuss::acquire
