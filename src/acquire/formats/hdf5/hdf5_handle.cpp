#include "acquire/formats/hdf5/hdf5_handle.hpp"

#include <hdf5.h>

#include <mutex>
#include <type_traits>
#include <utility>

namespace percuss::acquire::hdf5 {

static_assert(std::is_same_v<Id, hid_t>);

namespace {

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

// Number of nested locks of this thread. A recursive mutex would not do: it stores the owner's thread id, which differs
// in a forked child.
thread_local int depth = 0;

herr_t refuse_link(const char* /*file*/, const char* /*group*/, const char* /*target_file*/, const char* /*target*/,
                   unsigned* /*flags*/, hid_t /*access*/, void* /*data*/) {
  return -1;
}

}  // namespace

ExclusiveAccess::ExclusiveAccess() {
  if (depth == 0) library_mutex().lock();
  ++depth;
}

ExclusiveAccess::~ExclusiveAccess() {
  if (--depth == 0) library_mutex().unlock();
}

Lock::Lock() {
  // Called once, before the library starts. Disables its clean-up at exit, which crashes after a write to a full disk.
  // All objects are closed by then anyway.
  static const bool ready = H5dont_atexit() >= 0 && H5PLset_loading_state(0) >= 0;
  static_cast<void>(ready);
  // The library keeps one error stack with its printing handler per thread.
  thread_local const bool silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  static_cast<void>(silent);
}

void start_library() {
  const Lock lock;
  static_cast<void>(H5open());
}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this != &other) {
    close();
    id_ = other.release();
  }
  return *this;
}

bool Handle::close() {
  if (id_ < 0) return true;
  // Closes an identifier of any kind, like H5Fclose, H5Dclose, …
  return H5Idec_ref(release()) >= 0;
}

Id Handle::release() { return std::exchange(id_, H5I_INVALID_HID); }

void refuse_other_files(Id access) { H5Pset_elink_cb(access, refuse_link, nullptr); }

Handle access_within_file() {
  Handle access(H5Pcreate(H5P_LINK_ACCESS));
  refuse_other_files(access.get());
  return access;
}

}  // namespace percuss::acquire::hdf5
