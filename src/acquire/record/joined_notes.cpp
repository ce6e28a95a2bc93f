#include "acquire/record/joined_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "acquire/record/note_codes.hpp"

namespace percuss::acquire {

std::vector<Message> joined_notes(const std::vector<NotesOfFile>& files) {
  struct Noted {
    Message note;
    std::vector<const NotesOfFile*> in;
  };
  std::vector<Noted> notes;
  for (const NotesOfFile& file : files) {
    for (const Message& note : file.notes) {
      const auto known = std::find_if(notes.begin(), notes.end(), [&](const Noted& one) { return one.note == note; });
      if (known == notes.end()) {
        notes.push_back({note, {&file}});
      } else if (known->in.back() != &file) {
        known->in.push_back(&file);
      }
    }
  }
  std::vector<Message> out;
  for (Noted& one : notes) {
    out.push_back(std::move(one.note));
    if (one.in.size() == files.size()) continue;
    const std::string more = one.in.size() > 1 ? fmt::format(" and {} more", one.in.size() - 1) : "";
    out.back().text = one.in.front()->file + more + ": " + out.back().text;
    // The code means that all FRFs have the reversed phase. The FRFs of the other files can be fitted.
    if (out.back().code == kReversedPhase) out.back().code.clear();
  }
  return out;
}

}  // namespace percuss::acquire
