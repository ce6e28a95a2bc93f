#include "core/library_call.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <new>

namespace percuss::library_call_test {

#ifndef PERCUSS_SANITIZED  // sanitizers end the program where an allocation is too large
TEST(LibraryCall, FailsBeforeALibraryThatWouldRunOutOfMemory) {
  EXPECT_THROW(LibraryCall(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
  EXPECT_FALSE(LibraryCall::running());
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
