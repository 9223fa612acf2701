#pragma once

namespace calc {

// Raised with every change that the changelog marks "changes numbers": two results of one version,
// with the same input and seed, hold the same bits. tests/numbers holds hashes of them.
inline constexpr int kNumbersVersion = 2;

// SHA-256 of tests/numbers/kept.txt, written here by tests/numbers/write; a test compares them.
// With it stored looks (calc/store) are those of a program that gives these numbers, between two
// versions, too.
inline constexpr char kNumbersDigest[] =
    "891357397ac15524ccf3f7436e60d90059b0d3ce9acfbcd33c25119233c24533";

}  // namespace calc
