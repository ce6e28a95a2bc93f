#include "core/library_call.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstddef>
#include <new>

namespace percuss::library_call_test {

#ifndef PERCUSS_SANITIZED  // sanitizers end the program where an allocation is too large
TEST(LibraryCall, FailsBeforeALibraryThatWouldRunOutOfMemory) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  const rlimit limited{rlim_t{1} << 46U, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &limited), 0);
  EXPECT_THROW(LibraryCall(std::size_t{1} << 47U), std::bad_alloc);
  EXPECT_FALSE(LibraryCall::running());
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
}
#endif

TEST(LibraryCall, RunsWhileItLives) {
  EXPECT_FALSE(LibraryCall::running());
  {
    const LibraryCall outer(1000);
    { const LibraryCall inner; }
    EXPECT_TRUE(LibraryCall::running());
  }
  EXPECT_FALSE(LibraryCall::running());
}

}  // namespace percuss::library_call_test
