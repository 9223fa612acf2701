#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 3;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them.
// With it stored looks (calc/store) are those of a program that gives these numbers, between two
// versions, too.
inline constexpr char kNumbersDigest[] =
    "e7e1d75642e6e5a74fb7d570f4396476cd91b380592003079ef3a376b3e0b427";

}  // namespace calc
