#include "acquire/formats/hdf5/hdf5_input.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

// Size of a regular file. Opens the file without the library first: the library does not say why opening failed.
std::uint64_t size_of(const std::string& path) {
  // O_NONBLOCK: opening a pipe without a writer must not block.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    const int error = errno;
    throw_system_error(
        "cannot open", error, path,
        error == EMFILE ? "raise the limit of open files (ulimit -n)" : "check the name and its permissions");
  }
  struct stat info {};
  const int failed = ::fstat(descriptor, &info);
  ::close(descriptor);
  if (failed != 0 || !S_ISREG(info.st_mode)) throw InputError("is not a regular file", path, "name a file");
  return static_cast<std::uint64_t>(info.st_size);
}

Handle open_file(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS));
  // Without locks, files on read-only media and on cluster file systems open as well.
  H5Pset_file_locking(access.get(), false, true);
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
}

herr_t append_name(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* data) {
  const auto& [names, limit] = *static_cast<std::pair<std::vector<std::string>*, std::size_t>*>(data);
  if (names->size() >= limit) return 1;
  names->emplace_back(name);
  return 0;
}

struct DataPaths {
  hid_t file;
  std::size_t limit;
  std::vector<std::string> paths;
  std::size_t visited = 0;
};

herr_t append_data_path(hid_t /*group*/, const char* path, const H5L_info_t* info, void* data) {
  constexpr std::size_t kMaxVisited = 10'000;
  auto& found = *static_cast<DataPaths*>(data);
  if (found.paths.size() >= found.limit || ++found.visited > kMaxVisited) return 1;
  if (info->type == H5L_TYPE_HARD) {
    const Handle object(H5Oopen(found.file, path, H5P_DEFAULT));
    if (H5Iget_type(object.get()) == H5I_GROUP) return 0;
  }
  found.paths.emplace_back(path);
  return 0;
}

}  // namespace

InputHdf5::InputHdf5(std::string path) : path_(std::move(path)), bytes_(size_of(path_)) {
  if (!is_hdf5(path_))
    throw InputError("not an HDF5 file", path_, "give a file in one of the formats of docs/reference/formats.md");
  file_ = open_file(path_);
  if (!file_) throw InputError("truncated or damaged HDF5 file", path_, "copy or record it again");
}

bool InputHdf5::has(const std::string& name) const {
  const Handle access = access_within_file();
  // Every group of a path must exist before the library is asked for its member.
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    const std::string group = name.substr(0, slash);
    if (group.empty() || H5Lexists(id(), group.c_str(), access.get()) <= 0) return false;
  }
  return !name.empty() && H5Lexists(id(), name.c_str(), access.get()) > 0;
}

std::vector<std::string> InputHdf5::data_paths(std::size_t limit) const {
  DataPaths found{.file = id(), .limit = limit, .paths = {}};
  H5Lvisit(id(), H5_INDEX_NAME, H5_ITER_INC, append_data_path, &found);
  return found.paths;
}

std::vector<std::string> InputHdf5::names(std::size_t limit) const {
  std::vector<std::string> names;
  std::pair<std::vector<std::string>*, std::size_t> found{&names, limit};
  hsize_t next = 0;
  H5Literate(id(), H5_INDEX_NAME, H5_ITER_INC, &next, append_name, &found);
  return names;
}

}  // namespace percuss::acquire::hdf5

namespace percuss::acquire {

bool is_hdf5(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  bool found = false;
  std::array<char, kHdf5Signature.size()> bytes{};
  // A user block of 512 bytes times a power of two may precede the signature. The limit ends the search in a device
  // that never ends.
  constexpr off_t kMaxSignature_offset = off_t{1} << 40;
  for (off_t at = 0; !found && at <= kMaxSignature_offset; at = at == 0 ? 512 : 2 * at) {
    if (::pread(descriptor, bytes.data(), bytes.size(), at) != static_cast<ssize_t>(bytes.size())) break;
    found = std::string_view(bytes.data(), bytes.size()) == kHdf5Signature;
  }
  ::close(descriptor);
  return found;
}

}  // namespace percuss::acquire
