#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 2;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them.
// With it stored looks (calc/store) are those of a program that gives these numbers, between two
// versions, too.
inline constexpr char kNumbersDigest[] =
    "2fa9043307b270f73c610c9219ed21268d5474daf32d7c8f318bbbac37b59d0e";

}  // namespace calc
