#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/open_measurement.hpp"
#include "support/confinement.hpp"
#include "support/input_error.hpp"

// MAT files that once ended the process, gave uninitialised memory as samples, or led to other files. The fuzzer begins
// with them, too.
namespace percuss::mat_regressions_test {

struct Refused {
  const char* file;
  const char* problem;
};

void PrintTo(const Refused& one, std::ostream* out) { *out << one.file; }

constexpr const char* kFew = "an array stores fewer numbers than it states";
constexpr const char* kNothing = "no arrays of numbers";
constexpr const char* kDamaged = "a compressed variable is damaged";

class MatRegressions : public testing::TestWithParam<Refused> {};

INSTANTIATE_TEST_SUITE_P(, MatRegressions,
                         testing::Values(Refused{"few_numbers", kFew}, Refused{"few_numbers_packed", kFew},
                                         Refused{"few_numbers_in_cell", kFew}, Refused{"few_imaginary_numbers", kFew},
                                         Refused{"unknown_number_type", kFew}, Refused{"huge_dimensions", kFew},
                                         Refused{"empty_cell", kNothing}, Refused{"empty_cells", kNothing},
                                         Refused{"empty_structure", kNothing},
                                         Refused{"long_element", "the content of a variable exceeds its stated length"},
                                         Refused{"packed_beyond_length", kDamaged}, Refused{"damaged_packed", kDamaged},
                                         Refused{"huge_packed_length", "claims more numbers than it can hold"},
                                         Refused{"soft_link", "soft link"},
                                         Refused{"virtual_set", "its samples are in other files"},
                                         Refused{"external_storage", "its samples are in other files"},
                                         Refused{"link_to_pipe", "link to another file"},
                                         Refused{"region_reference", "references to regions of data sets"}),
                         [](const auto& one) { return std::string(one.param.file); });

TEST_P(MatRegressions, AreRefusedWithAndWithoutASandbox) {
  const std::string path = std::string(PERCUSS_SOURCE_DIR "/fuzz/corpus/foreign/") + GetParam().file + ".mat";
  const auto refusal = [&](bool sandboxed) {
    return test::input_error_of([&] { acquire::open_measurement(path, {.read = {.sandboxed = sandboxed}}); });
  };
  EXPECT_THAT(refusal(false), testing::HasSubstr(GetParam().problem));
  if (test::has_seccomp()) {
    EXPECT_EQ(refusal(true), refusal(false));
  }
}

}  // namespace percuss::mat_regressions_test
