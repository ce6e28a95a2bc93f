#include "targets.hpp"

namespace percuss::fuzz {

// MAT, HDF5 and sound files as they come, decoded by libraries that may crash in the process that is made for them.
void run_foreign(std::string_view bytes) {
  const NamelessFile file(bytes);
  accepted([&] { read_all(open_measurement(file.path(), {.read = {.confined = true}, .kind = {}})); });
}

}  // namespace percuss::fuzz
