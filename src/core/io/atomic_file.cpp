#include "core/io/atomic_file.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "core/io/pending_file.hpp"

namespace percuss {
inline namespace core {
namespace {

thread_local OutputGroup* current_group = nullptr;

}  // namespace

AtomicFile::AtomicFile(std::string path, bool force, Temporary kind, Links links)
    : file_(std::make_unique<PendingFile>(std::move(path), force, kind == Temporary::unnamed_if_possible,
                                          links == Links::followed)) {}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::string_view bytes) { file_->write(bytes); }

const std::string& AtomicFile::temporary_path() const { return file_->temporary_path(); }

void AtomicFile::commit() {
  assert(file_);
  file_->complete();
  if (current_group != nullptr) {
    current_group->files_.push_back(std::move(file_));
    return;
  }
  file_->publish();
  file_->sync_folder();
}

OutputGroup::OutputGroup() : outer_(std::exchange(current_group, this)) {}

OutputGroup::~OutputGroup() { current_group = outer_; }

void OutputGroup::commit() {
  if (outer_ != nullptr) {
    std::move(files_.begin(), files_.end(), std::back_inserter(outer_->files_));
    files_.clear();
    return;
  }
  for (const auto& file : files_) file->check_absent();
  try {
    for (const auto& file : files_) file->publish();
  } catch (...) {
    for (const auto& file : files_) file->withdraw();
    throw;
  }
  for (const auto& file : files_) file->sync_folder();
  files_.clear();
}

void write_file(const std::string& path, std::string_view bytes, bool force) {
  AtomicFile file(path, force);
  file.write(bytes);
  file.commit();
}

}  // namespace core
}  // namespace percuss
