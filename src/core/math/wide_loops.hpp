#pragma once
#include "core/sanitized.hpp"

// PERCUSS_WIDE_LOOPS compiles a function a second time for processors with AVX2, whose vectors are twice as wide. The
// program chooses when it is loaded. Both give the same results, bit by bit: AVX2 alone fuses no operations, and the
// order of a sum is the order in which it is written. Sanitizers do not support the choice.
#if defined(__x86_64__) && defined(__linux__) && defined(__has_attribute) && !defined(PERCUSS_SANITIZED)
#if __has_attribute(target_clones)
#define PERCUSS_WIDE_LOOPS __attribute__((target_clones("avx2", "default")))
#endif
#endif
#ifndef PERCUSS_WIDE_LOOPS
#define PERCUSS_WIDE_LOOPS
#endif

namespace percuss {
inline namespace core {

/// Four numbers, which AVX2 adds or multiplies in one operation, and other processors in two. No function takes or
/// returns them: the calling convention depends on the processor.
using FourDoubles = double __attribute__((vector_size(32)));

}  // namespace core
}  // namespace percuss
