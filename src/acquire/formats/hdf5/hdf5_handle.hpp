#pragma once
#include <cstdint>

namespace percuss::acquire::hdf5 {

/// The library's hid_t, so that hdf5.h stays in .cpp files; negative for none.
using Id = std::int64_t;

/// While it is held no other thread is within the library. One thread may hold several, and a process that is forked
/// under one holds it too.
class ExclusiveAccess {
 public:
  ExclusiveAccess();
  ~ExclusiveAccess();
  ExclusiveAccess(const ExclusiveAccess&) = delete;
  ExclusiveAccess& operator=(const ExclusiveAccess&) = delete;
};

/// Held around all use of the library, closing included: it may not be used from several threads at once. Also sees to
/// it that the library prints nothing and loads no plug-ins.
class Lock {
 public:
  Lock();

 private:
  ExclusiveAccess access_;
};

/// Readies the library now, which takes it a millisecond: before processes are forked, each of which would need it.
void start_library();

/// Owns an identifier of any kind (file, data set, type, property list …); false when there is none.
class Handle {
 public:
  explicit Handle(Id id = -1) : id_(id) {}
  ~Handle() { close(); }
  Handle(Handle&& other) noexcept : id_(other.release()) {}
  Handle& operator=(Handle&& other) noexcept;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  Id get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// False when the library could not finish what it had still to write.
  bool close();

 private:
  Id release();
  Id id_;
};

}  // namespace percuss::acquire::hdf5
