/* SHA-256 (FIPS 180-4). */
#include "sha256.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace host {
namespace {

using State = std::array<std::uint32_t, 8>;

std::uint32_t rotated(std::uint32_t v, unsigned n) { return v >> n | v << (32 - n); }

/* floor(2^32 * fraction of the root) of the first primes is what the standard's constants are; found here instead of copied. */
std::uint32_t root_fraction(std::uint32_t prime, int power) {
  /* The largest r with r^power <= prime * 2^(32 power), bit by bit; r is below 2^37. */
  __extension__ using Wide = unsigned __int128;
  Wide r = 0;
  for (int bit = 36; bit >= 0; bit--) {
    const Wide next = r | Wide(1) << bit;
    const Wide square = next * next; /* below 2^74 */
    /* next^3 is below 2^111, prime * 2^96 below 2^105. */
    const bool fits = power == 2 ? square <= Wide(prime) << 64 : square * next <= Wide(prime) << 96;
    if (fits) r = next;
  }
  return static_cast<std::uint32_t>(r);
}

struct Constants {
  State start{};
  std::array<std::uint32_t, 64> round{};

  Constants() {
    std::size_t found = 0;
    for (std::uint32_t n = 2; found < round.size(); n++) {
      bool prime = true;
      for (std::uint32_t d = 2; d * d <= n; d++) prime = prime && n % d != 0;
      if (!prime) continue;
      if (found < start.size()) start[found] = root_fraction(n, 2);
      round[found++] = root_fraction(n, 3);
    }
  }
};

void add_block(State &state, const unsigned char *block, const Constants &constants) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 16; i++)
    w[i] =
        std::uint32_t{block[4 * i]} << 24 | std::uint32_t{block[4 * i + 1]} << 16 | std::uint32_t{block[4 * i + 2]} << 8 | block[4 * i + 3];
  for (std::size_t i = 16; i < 64; i++) {
    const std::uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (rotated(a, 7) ^ rotated(a, 18) ^ a >> 3) + w[i - 7] + (rotated(b, 17) ^ rotated(b, 19) ^ b >> 10);
  }
  State s = state;
  for (std::size_t i = 0; i < 64; i++) {
    const std::uint32_t t1 =
        s[7] + (rotated(s[4], 6) ^ rotated(s[4], 11) ^ rotated(s[4], 25)) + ((s[4] & s[5]) ^ (~s[4] & s[6])) + constants.round[i] + w[i];
    const std::uint32_t t2 = (rotated(s[0], 2) ^ rotated(s[0], 13) ^ rotated(s[0], 22)) + ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
    s = {t1 + t2, s[0], s[1], s[2], s[3] + t1, s[4], s[5], s[6]};
  }
  for (std::size_t i = 0; i < state.size(); i++) state[i] += s[i];
}

} // namespace

std::string sha256(const std::string &bytes) {
  static const Constants constants;
  State state = constants.start;
  std::string padded = bytes + '\x80';
  padded.append((120 - padded.size() % 64) % 64, '\0');
  const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 0xff);
  for (std::size_t i = 0; i < padded.size(); i += 64)
    add_block(state, reinterpret_cast<const unsigned char *>(padded.data()) + i, constants);
  std::string text;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 15];
  return text;
}

} // namespace host
