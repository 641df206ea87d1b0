// Checksum of values and their places, by which damage to a file is noticed that leaves its size.
//
//   c = sum over n of mix(v_n XOR n g)  modulo 2^64
//
// v_n: bits of the value at place n, counted from 1; g = 2^64 / golden ratio; mix: the finaliser of SplitMix64 (Steele,
// Lea, Flood 2014, doi:10.1145/2660193.2660195), one-to-one: damage to a single value always changes c. Being a sum, c
// can be taken in parts, by any number of processes, and grows with a file that grows.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace gearfilm {

constexpr std::uint64_t checksum_term(std::uint64_t place, std::uint64_t bits) {
  std::uint64_t z = bits ^ (place * 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// The part that these values contribute, with `before` other values in front of them.
inline std::uint64_t checksum(std::span<const double> values, std::uint64_t before = 0) {
  std::uint64_t sum = 0;
  for (const double value : values) sum += checksum_term(++before, std::bit_cast<std::uint64_t>(value));
  return sum;
}

/// Checksum of a text, byte after byte.
inline std::uint64_t checksum(std::string_view text) {
  std::uint64_t sum = 0, place = 0;
  for (const char byte : text) sum += checksum_term(++place, static_cast<unsigned char>(byte));
  return sum;
}

}  // namespace gearfilm
