#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/files/synthetic_files.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// Invalid specifications of synthetic tests.
namespace percuss::hostile_spec_test {

namespace fs = std::filesystem;
using test::rejection_of;

class HostileSpec : public testing::Test {
 protected:
  static void expect_refusal(const std::string& spec, const std::string& named,
                             const test::ProcessOptions& options = {.time_limit = std::chrono::seconds(20)}) {
    rejection_of({"synth", spec}, {".h5", ".csv"}, named, options);
  }
  void expect_refusal_of_text(const std::string& text) {
    SCOPED_TRACE(text.substr(0, 200));
    test::write_bytes(path_, text);
    expect_refusal(path_, path_);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("spec.json");
};

TEST_F(HostileSpec, IsRejectedWhenItIsNotAFile) {
  expect_refusal(folder_.file("none.json"), folder_.file("none.json"));
  expect_refusal(folder_.path(), folder_.path());
  expect_refusal("steel-bat", "steel-bat");
  expect_refusal("/dev/zero", "/dev/zero");
  ASSERT_EQ(::mkfifo(folder_.file("pipe").c_str(), 0666), 0);
  expect_refusal(folder_.file("pipe"), folder_.file("pipe"));
  expect_refusal("-", "standard input");
  expect_refusal("-", "standard input", {.input = "/dev/zero", .time_limit = std::chrono::seconds(20)});
}

TEST_F(HostileSpec, IsRejectedWhenItIsUnreadable) {
  fs::permissions(folder_.path(), fs::perms::all);
  test::write_bytes(path_, test::small_spec());
  fs::permissions(path_, fs::perms::none);
  expect_refusal(path_, path_, {.ordinary_user = true});
}

TEST_F(HostileSpec, IsRejectedWhenItIsNotASpecification) {
  for (const char* text : {"", "null", "[]", "7", "{}", "{", "hello", "\xff\xfe", "{\"fs_hz\": }", R"({"fs_hz": 1000})",
                           R"({"fs_hz": 1000, "fs_hz": 2000})"})
    expect_refusal_of_text(text);
  expect_refusal_of_text(std::string(100000, '['));
  expect_refusal_of_text(std::string(100000, '\0'));
  expect_refusal_of_text("{\"modes\": " + std::string(6 << 20, ' ') + "[]}");
  const std::string whole = test::small_spec();
  for (std::size_t part = 1; part < 20; ++part) expect_refusal_of_text(whole.substr(0, part * whole.size() / 20));
}

TEST_F(HostileSpec, IsRejectedForImpossibleNumbers) {
  const auto spec = [](const std::string& numbers) {
    return R"({"modes": [{"frequency_hz": 100, "damping_ratio": 0.01}], )" + numbers + "}";
  };
  for (const char* numbers :
       {R"("fs_hz": 1e300, "samples": 1000)", R"("fs_hz": 0, "samples": 1000)", R"("fs_hz": -1000, "samples": 1000)",
        R"("fs_hz": 1000, "samples": 1e12)", R"("fs_hz": 1000, "samples": -1)",
        R"("fs_hz": 1000, "samples": 1000, "hits": 1e15)", R"("fs_hz": 1000, "duration_s": 1e30)",
        R"("fs_hz": NaN, "samples": 1000)", R"("fs_hz": 1e999, "samples": 1000)", R"("fs_hz": "fast", "samples": 1000)",
        R"("fs_hz": 1000, "samples": 1000, "runs": 4294967296)"})
    expect_refusal_of_text(spec(numbers));
  expect_refusal_of_text(R"({"fs_hz": 1000, "samples": 1000, "modes": [{"frequency_hz": -5, "damping_ratio": 0.01}]})");
  expect_refusal_of_text(R"({"fs_hz": 1000, "samples": 1000, "modes": [{"frequency_hz": 100, "damping_ratio": 2}]})");
}

}  // namespace percuss::hostile_spec_test
