#include "acquire/open_measurement.hpp"
#include "targets.hpp"

namespace percuss::fuzz {

// Whole MAT, HDF5 and sound files. The libraries that decode them may crash, in their sandboxed process.
void run_binary_formats(std::string_view bytes) {
  const MemfdFile file(bytes);
  accepted([&] { read_all(acquire::open_measurement(file.path(), {.read = {.sandboxed = true}, .kind = {}})); });
}

}  // namespace percuss::fuzz
