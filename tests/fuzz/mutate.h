#pragma once
// Small changes that break files: a poor man's fuzzer, the same on every machine.

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fuzz {

class Mutator {
 public:
  // seeds: not empty; must outlive this object.
  Mutator(const std::vector<std::string>& seeds, std::uint64_t random_seed);

  // A seed with one to four changes: bytes, numbers (text and binary), cuts, doubled parts, and
  // parts of other seeds.
  std::string next();

 private:
  std::size_t below(std::size_t count);  // uniform in [0, count); 0 for none
  const std::string& any_seed() { return seeds_[below(seeds_.size())]; }

  void change(std::string& text);
  void flip_bytes(std::string& text);
  void replace_number(std::string& text);
  void replace_integer(std::string& text);
  void cut(std::string& text);
  void remove_part(std::string& text);
  void double_part(std::string& text);
  void splice(std::string& text);

  const std::vector<std::string>& seeds_;
  std::mt19937_64 random_;
};

}  // namespace fuzz
