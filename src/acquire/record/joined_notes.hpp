#pragma once
#include <string>
#include <vector>

#include "core/error.hpp"

namespace percuss::acquire {

struct NotesOfFile {
  std::string file;
  std::vector<Message> notes;
};

/// The notes of several files, each once: after the files that it concerns, or alone where it concerns all of them.
std::vector<Message> joined_notes(const std::vector<NotesOfFile>& files);

}  // namespace percuss::acquire
