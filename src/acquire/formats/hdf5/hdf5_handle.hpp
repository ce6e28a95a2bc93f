#pragma once
#include <cstdint>

namespace percuss::acquire::hdf5 {

/// The library's hid_t (hdf5.h stays in .cpp files); negative for none.
using Id = std::int64_t;

/// Excludes other threads from the library during its lifetime. One thread may hold several. A process forked
/// meanwhile inherits the access.
class ExclusiveAccess {
 public:
  ExclusiveAccess();
  ~ExclusiveAccess();
  ExclusiveAccess(const ExclusiveAccess&) = delete;
  ExclusiveAccess& operator=(const ExclusiveAccess&) = delete;
};

/// Guards all use of the library, including closing: the library is not thread-safe. Also keeps the library from
/// printing and from loading plug-ins.
class Lock {
 public:
  Lock();

 private:
  ExclusiveAccess access_;
};

/// Initialises the library (1 ms). Call it before forking, so that the children need not.
void start_library();

/// Owns an identifier of any kind (file, data set, type, property list …). Converts to false when it owns none.
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
  /// False when the library could not complete pending writes.
  bool close();

 private:
  Id release();
  Id id_;
};

/// Makes a property list of access refuse links to other files.
void refuse_other_files(Id access);
/// Access to links within one file.
Handle access_within_file();

}  // namespace percuss::acquire::hdf5
