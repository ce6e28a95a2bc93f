#include "targets.hpp"

namespace percuss::fuzz {

// MAT, HDF5 and sound files as they come, decoded by libraries that may crash in the process that is made for them.
void run_binary_formats(std::string_view bytes) {
  const MemfdFile file(bytes);
  accepted([&] { read_all(frf::open_measurement(file.path(), {.read = {.sandboxed = true}, .kind = {}})); });
}

}  // namespace percuss::fuzz
