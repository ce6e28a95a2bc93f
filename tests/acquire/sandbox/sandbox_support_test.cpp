#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/confinement.hpp"
#include "support/files/synthetic_files.hpp"
#include "support/json.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

// The sandbox on systems without seccomp or without Landlock.
namespace percuss::acquire::sandbox_support_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SandboxSupport : public testing::TestWithParam<const char*> {
 protected:
  SandboxSupport() { test::write_small_test(path_); }
  test::ProcessOutcome run(const std::vector<std::string>& arguments, std::function<void()> prepare) const {
    return test::run_percuss(arguments, {.prepare = std::move(prepare)});
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file(std::string("r") + GetParam());
};

INSTANTIATE_TEST_SUITE_P(, SandboxSupport, testing::Values(".mat", ".h5", ".wav"),
                         [](const auto& one) { return std::string(one.param).substr(1); });

TEST_P(SandboxSupport, WithoutSeccompRefuseForeignFiles) {
  const auto refused = run({"analyze", path_}, test::remove_seccomp);
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, AllOf(HasSubstr("cannot confine the process that reads the file (" + path_ + ")"),
                                 HasSubstr("trust the input"), HasSubstr("(--trust-input)")));
  EXPECT_EQ(run({"analyze", path_, "--trust-input"}, test::remove_seccomp).code, 0);
  const std::string text = folder_.file("r.csv");
  test::write_small_test(text);
  EXPECT_EQ(run({"analyze", text}, test::remove_seccomp).code, 0);
}

TEST_P(SandboxSupport, WithoutSeccompRefuseSeveralFilesToo) {
  const std::string second = folder_.file(std::string("s") + GetParam());
  test::write_small_test(second);
  const auto refused = run({"analyze", path_, second}, test::remove_seccomp);
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("cannot confine"));
}

TEST_P(SandboxSupport, WithoutLandlockSaySo) {
  if (!test::has_seccomp()) return;  // refused, as above
  const char* const note = "this system (no Landlock) does not keep the reader of the file from opening other files";
  const auto with = run({"analyze", path_, "--json"}, {});
  const auto without = run({"analyze", path_, "--json"}, test::remove_landlock);
  EXPECT_EQ(without.code, 0);
  EXPECT_THAT(without.out, HasSubstr(note));
  const auto converted = run({"convert", path_, "-o", folder_.file("r.csv")}, test::remove_landlock);
  EXPECT_EQ(converted.code, 0);
  EXPECT_THAT(converted.err, HasSubstr(note));
  if (!test::has_landlock()) return;
  EXPECT_THAT(with.out, Not(HasSubstr("Landlock")));
}

}  // namespace percuss::acquire::sandbox_support_test
