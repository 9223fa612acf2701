#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of the same
// version, input and seed hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 3;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them. It
// keeps cached results (calc/store) apart that give different numbers, also between two versions.
inline constexpr char kNumbersDigest[] =
    "77a61eeeaf9644df8d44459b86b8f2d1a799579beca70a75b3c69b77f5330b2b";

}  // namespace calc
