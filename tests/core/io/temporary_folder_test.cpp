#include "core/io/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace percuss::temporary_folder_test {

TEST(TemporaryFolder, IsRemovedWithItsContents) {
  std::string path;
  {
    const TemporaryFolder folder("percuss-any"), other("percuss-any");
    path = folder.path();
    EXPECT_NE(path, other.path());
    EXPECT_TRUE(std::filesystem::path(path).filename().string().starts_with("percuss-any-"));
    std::filesystem::create_directory(folder.file("inner"));
    std::ofstream(folder.file("inner/a.txt")) << "a";
    EXPECT_TRUE(std::filesystem::exists(path + "/inner/a.txt"));
    struct stat found {};
    ASSERT_EQ(::stat(path.c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777U, 0700U);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace percuss::temporary_folder_test
