/* What the fuzz targets share: a check that stops the run, and numbers drawn from the input's bytes. */
#ifndef FIXCAST_FUZZ_H
#define FIXCAST_FUZZ_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/* libFuzzer keeps the input of a run that aborts. */
#define CHECK(condition) \
  do { \
    if (!(condition)) { \
      std::fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #condition); \
      std::abort(); \
    } \
  } while (0)

namespace fuzz {

/* Bytes in order; zeros once they have run out, so that a shortened input stays meaningful. */
class Bytes {
public:
  Bytes(const std::uint8_t *data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return at_ >= size_; }
  std::uint8_t u8() { return at_ < size_ ? data_[at_++] : 0; }
  std::uint16_t u16() {
    const unsigned low = u8();
    return static_cast<std::uint16_t>(low | static_cast<unsigned>(u8()) << 8);
  }
  std::uint32_t u32() {
    const std::uint32_t low = u16();
    return low | static_cast<std::uint32_t>(u16()) << 16;
  }
  std::uint64_t u64() {
    const std::uint64_t low = u32();
    return low | static_cast<std::uint64_t>(u32()) << 32;
  }

private:
  const std::uint8_t *data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

/* Heap memory of exactly so many objects, so that AddressSanitizer sees the first byte too far. */
template <typename T>
class Exact {
public:
  explicit Exact(std::size_t count)
      : data_(static_cast<T *>(std::malloc(count * sizeof(T)))), count_(count) {}
  ~Exact() { std::free(data_); }
  Exact(const Exact &) = delete;
  Exact &operator=(const Exact &) = delete;

  T *get() const { return data_; }
  std::size_t count() const { return count_; }
  std::size_t bytes() const { return count_ * sizeof(T); }
  T &operator[](std::size_t i) const { return data_[i]; }

private:
  T *data_;
  std::size_t count_;
};

} // namespace fuzz

#endif
