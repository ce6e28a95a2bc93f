#include "acquire/open_measurement.hpp"
#include "targets.hpp"

namespace percuss::fuzz {

// Reads MAT, HDF5 and sound files. The libraries that decode them may crash, but only in the sandboxed process.
void run_binary_formats(std::string_view bytes) {
  const MemfdFile file(bytes);
  accepted([&] { read_all(acquire::open_measurement(file.path(), {.read = {.sandboxed = true}, .kind = {}})); });
}

}  // namespace percuss::fuzz
