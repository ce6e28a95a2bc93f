#pragma once
#include <string>
#include <vector>

#include "core/error.hpp"

namespace percuss::acquire {

struct NotesOfFile {
  std::string file;
  std::vector<Message> notes;
};

/// The notes of several files, each once. A note that does not concern all files begins with the first file that it
/// concerns and the number of the others.
std::vector<Message> joined_notes(const std::vector<NotesOfFile>& files);

}  // namespace percuss::acquire
