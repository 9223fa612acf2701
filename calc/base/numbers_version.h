#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 2;

}  // namespace calc
