#pragma once
#include <string>

namespace percuss::test {

/// A small hammer test with known truth: 4096 Hz, rows of 1 s, a bending mode at 200 Hz (1 %) and a hoop mode at 700 Hz
/// (0.5 %), accelerometers at 0° and 90°. `more` is added to the spec: R"("hits": 3, "runs": 2)".
std::string small_spec(const std::string& more = R"("hits": 3)");

/// Writes this test as a record in the format of the extension.
void write_small_test(const std::string& path, const std::string& more = R"("hits": 3)");

}  // namespace percuss::test
