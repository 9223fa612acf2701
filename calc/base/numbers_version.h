#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 2;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them.
// With it stored looks (calc/store) are those of a program that gives these numbers, between two
// versions, too.
inline constexpr char kNumbersDigest[] =
    "0823113984ac129872d57acc72fb888598ad9126c0d4d201a003823a33e31e61";

}  // namespace calc
