#pragma once
// Compiles loops over many numbers for the vector width of the processor.

// GCC makes one version of a function per instruction set and picks at start-up; without
// contraction to fused multiply-add, and with sums in an order that the source fixes, all versions
// give the same bits.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LUXGATE_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LUXGATE_WIDE
#endif
