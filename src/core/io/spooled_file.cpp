#include "core/io/spooled_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "core/error.hpp"
#include "core/io/temporary_files.hpp"
#include "core/io/temporary_folder.hpp"
#include "core/io/write_all.hpp"

namespace percuss {
inline namespace core {

SpooledFile::SpooledFile(std::string_view bytes) : path_(temporary_template("percuss-input")) {
  descriptor_ = ::mkostemp(path_.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    throw_system_error("cannot keep standard input in a temporary file", errno, path_,
                       "set TMPDIR to a folder with room");
  }
  registered_ = std::make_unique<TemporaryFile>(path_, descriptor_);
  ::flock(descriptor_, LOCK_UN);  // the HDF5 library locks the files that it opens
  if (!write_all(descriptor_, bytes)) {
    const int error = errno;
    ::unlink(path_.c_str());
    ::close(descriptor_);
    throw_system_error("cannot keep standard input in a temporary file", error, path_,
                       "set TMPDIR to a folder with room");
  }
}

SpooledFile::~SpooledFile() {
  ::unlink(path_.c_str());
  registered_.reset();
  ::close(descriptor_);
}

}  // namespace core
}  // namespace percuss
