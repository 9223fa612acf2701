#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 2;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them.
// With it stored looks (calc/store) are those of a program that gives these numbers, between two
// versions, too.
inline constexpr char kNumbersDigest[] =
    "ba32cada8725f9e191bc1f7e6ef1af26642b60b936f8c4107ab3bcfd0244de63";

}  // namespace calc
