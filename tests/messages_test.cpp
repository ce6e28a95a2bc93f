#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

// The library serves the command line, Python and C++: its messages name options by identifier, not by flag.
namespace percuss::messages_test {

namespace fs = std::filesystem;

// String literals with "--word". Style sheets write their variables as "var(--word)" and set them by
// "{{ --word: …".
std::vector<std::string> flags_in(const std::string& line) {
  static const std::regex kLiteral(R"re("(?:[^"\\]|\\.)*")re"), kFlag(R"((^|[^(-])--[a-z][a-z-]+)"),
      kStyle(R"(\{\{ --[a-z-]+)");
  std::vector<std::string> out;
  const std::string code = line.substr(0, line.find("//"));
  for (std::sregex_iterator at(code.begin(), code.end(), kLiteral), end; at != end; ++at) {
    const std::string literal = at->str();
    if (std::regex_search(std::regex_replace(literal, kStyle, ""), kFlag)) out.push_back(literal);
  }
  return out;
}

TEST(Messages, NameNoFlagOfTheCommandLine) {
  const fs::path root = fs::path(PERCUSS_SOURCE_DIR) / "src";
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path& path = entry.path();
    const bool is_source = path.extension() == ".cpp" || path.extension() == ".hpp";
    if (!is_source || path.filename() == "slurm.cpp") continue;  // writes a script with the flags of Slurm
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      for (const std::string& literal : flags_in(line))
        found.push_back(path.lexically_relative(root).string() + ": " + literal);
    }
  }
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(Messages, AreSearchedForFlags) {
  EXPECT_EQ(flags_in(R"(throw InputError("x", "y", "state it with --fs");)").size(), 1U);
  EXPECT_EQ(flags_in(R"(out << "--fs")").size(), 1U);
  EXPECT_TRUE(flags_in(R"(fmt::format(":root {{ --width: {}; }}", width))").empty());
  EXPECT_EQ(flags_in(R"(fmt::format("state it with --width: {}", width))").size(), 1U);
  EXPECT_TRUE(flags_in(R"code(ink = "var(--ink)";  // as "--fs")code").empty());
}

}  // namespace percuss::messages_test
