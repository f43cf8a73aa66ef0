/*
 * The oracle's two number types with one interface: Ball (long double with an error bound) and Wide (256-bit
 * MPFI interval). Both enclose the true value; a sign is reported only when the enclosure leaves no doubt.
 */
#ifndef FIXCAST_HOST_ORACLE_NUMBER_H
#define FIXCAST_HOST_ORACLE_NUMBER_H

#include <mpfi.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>

namespace host::oracle {

/* `open` says that the enclosure contains zero and something else; `value` is 0 then. */
struct Sign {
  int value = 0;
  bool open = false;
};

/* The true value lies within `rad` of `mid`. Any NaN or infinity that arises makes the sign open. */
class Ball {
public:
  /* No finer arithmetic follows Wide; it does follow Ball. */
  static constexpr bool is_final = false;

  Ball() = default;
  explicit Ball(long double exact) : mid_(exact) {}
  Ball(long double mid, long double rad) : mid_(mid), rad_(rad) {}

  long double mid() const {
    return mid_;
  }
  long double rad() const {
    return rad_;
  }

  friend Sign sign_of(const Ball &a) {
    if (a.mid_ > a.rad_) return {1, false};
    if (a.mid_ < -a.rad_) return {-1, false};
    return {0, !(a.mid_ == 0 && a.rad_ == 0)};
  }

  Ball operator-() const {
    return {-mid_, rad_};
  }

  friend Ball operator+(const Ball &a, const Ball &b) {
    const long double sum = a.mid_ + b.mid_;
    if (a.rad_ == 0 && b.rad_ == 0 && sum_error(a.mid_, b.mid_, sum) == 0) return Ball(sum);
    return {sum, (a.rad_ + b.rad_ + std::fabs(sum) * LDBL_EPSILON) * inflate};
  }

  friend Ball operator-(const Ball &a, const Ball &b) {
    return a + -b;
  }

  friend Ball operator*(const Ball &a, const Ball &b) {
    if (a.is_zero() || b.is_zero()) return Ball();
    const long double product = a.mid_ * b.mid_;
    if (a.rad_ == 0 && b.rad_ == 0 && product_is_exact(a.mid_, b.mid_, product)) return Ball(product);
    const long double rad = std::fabs(a.mid_) * b.rad_ + std::fabs(b.mid_) * a.rad_ + a.rad_ * b.rad_;
    return {product, (rad + std::fabs(product) * LDBL_EPSILON + underflow) * inflate};
  }

  friend Ball operator/(const Ball &a, const Ball &b) {
    const long double quotient = a.mid_ / b.mid_;
    const long double least = std::fabs(b.mid_) - b.rad_;
    if (!(least > 0)) return {0, HUGE_VALL};
    const long double rad = (a.rad_ + std::fabs(quotient) * b.rad_) / least;
    return {quotient, (rad + std::fabs(quotient) * LDBL_EPSILON + underflow) * inflate};
  }

  /* The part of the enclosure below zero is dropped: callers know the true value is not negative. */
  friend Ball root(const Ball &a) {
    if (a.mid_ > a.rad_) {
      const long double r = std::sqrt(a.mid_);
      if (a.rad_ == 0 && r * r == a.mid_ && product_is_exact(r, r, a.mid_)) return Ball(r);
      return {r, (a.rad_ / r + r * LDBL_EPSILON + underflow) * inflate};
    }
    if (a.is_zero()) return Ball();
    const long double half = std::sqrt(a.mid_ + a.rad_) / 2;
    return {half, (half * (1 + 4 * LDBL_EPSILON) + underflow) * inflate};
  }

private:
  /* Covers the few roundings made while a radius is computed, each at most LDBL_EPSILON / 2. */
  static constexpr long double inflate = 1 + 16 * LDBL_EPSILON;
  /* Covers products and quotients that fall below the normal range. */
  static constexpr long double underflow = LDBL_MIN;

  bool is_zero() const {
    return mid_ == 0 && rad_ == 0;
  }

  /* Knuth's two-sum: what rounding took away from a + b. */
  static long double sum_error(long double a, long double b, long double sum) {
    const long double b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
  }

  /* Dekker's product error; written out because fmal is slow software on x86. Out of the range where its
   * intermediate results are exact it answers no, which is always safe. */
  static bool product_is_exact(long double a, long double b, long double product) {
    constexpr long double low = 0x1p-800L, high = 0x1p+800L;
    const long double size_a = std::fabs(a), size_b = std::fabs(b);
    if (!(size_a > low && size_a < high && size_b > low && size_b < high) || DBL_MAX_EXP >= LDBL_MAX_EXP)
      return false;
    constexpr long double splitter = static_cast<long double>(1ULL << ((LDBL_MANT_DIG + 1) / 2)) + 1;
    const long double big_a = splitter * a, big_b = splitter * b;
    const long double a_hi = big_a - (big_a - a), a_lo = a - a_hi;
    const long double b_hi = big_b - (big_b - b), b_lo = b - b_hi;
    return ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo == 0;
  }

  long double mid_ = 0, rad_ = 0;
};

/* An MPFI interval. Every variable gets its precision explicitly: the library's default is global. */
class Wide {
public:
  static constexpr bool is_final = true;
  static constexpr mpfr_prec_t bits = 256;

  Wide() : Wide(Blank()) {
    mpfi_set_si(x_, 0);
  }
  explicit Wide(long double exact) : Wide(Blank()) {
    mpfr_set_ld(&x_->left, exact, MPFR_RNDD);
    mpfr_set_ld(&x_->right, exact, MPFR_RNDU);
  }
  Wide(const Wide &other) : Wide(Blank()) {
    mpfi_set(x_, other.x_);
  }
  Wide &operator=(const Wide &other) {
    if (this != &other) mpfi_set(x_, other.x_);
    return *this;
  }
  Wide(Wide &&other) noexcept : Wide(Blank()) {
    mpfi_swap(x_, other.x_);
  }
  Wide &operator=(Wide &&other) noexcept {
    mpfi_swap(x_, other.x_);
    return *this;
  }
  ~Wide() {
    mpfi_clear(x_);
  }

  /* A finite decimal, or a fraction of two; false when the text is neither. */
  static bool parse(const std::string &text, Wide &out) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return parse_decimal(text, out);
    Wide numerator, denominator;
    if (!parse_decimal(text.substr(0, slash), numerator) ||
        !parse_decimal(text.substr(slash + 1), denominator) || sign_of(denominator).value == 0)
      return false;
    out = numerator / denominator;
    return true;
  }

  /* tan(degrees / 2) */
  static Wide tan_half_degrees(const Wide &degrees) {
    Wide angle((Blank()));
    mpfi_const_pi(angle.x_);
    mpfi_mul(angle.x_, angle.x_, degrees.x_);
    mpfi_div_ui(angle.x_, angle.x_, 360);
    mpfi_tan(angle.x_, angle.x_);
    return angle;
  }

  /* The tightest ball around the interval; its radius is 0 when the value is a long double. */
  Ball ball() const {
    Wide centre((Blank()));
    mpfi_mid(&centre.x_->left, x_);
    const long double mid = mpfr_get_ld(&centre.x_->left, MPFR_RNDN);
    mpfr_set_ld(&centre.x_->left, mid, MPFR_RNDN);
    mpfr_sub(&centre.x_->right, &x_->right, &centre.x_->left, MPFR_RNDU);
    const long double above = mpfr_get_ld(&centre.x_->right, MPFR_RNDU);
    mpfr_sub(&centre.x_->right, &centre.x_->left, &x_->left, MPFR_RNDU);
    const long double below = mpfr_get_ld(&centre.x_->right, MPFR_RNDU);
    /* One of them is negative when rounding put mid outside the interval. */
    const long double rad = std::max(above, below);
    if (std::isnan(above) || std::isnan(below) || std::isinf(rad)) return {0, HUGE_VALL};
    return {mid, rad};
  }

  friend Sign sign_of(const Wide &a) {
    if (mpfi_is_strictly_pos(a.x_)) return {1, false};
    if (mpfi_is_strictly_neg(a.x_)) return {-1, false};
    return {0, mpfi_is_zero(a.x_) == 0};
  }

  Wide operator-() const {
    Wide out((Blank()));
    mpfi_neg(out.x_, x_);
    return out;
  }
  friend Wide operator+(const Wide &a, const Wide &b) {
    return combine(mpfi_add, a, b);
  }
  friend Wide operator-(const Wide &a, const Wide &b) {
    return combine(mpfi_sub, a, b);
  }
  friend Wide operator*(const Wide &a, const Wide &b) {
    return combine(mpfi_mul, a, b);
  }
  friend Wide operator/(const Wide &a, const Wide &b) {
    return combine(mpfi_div, a, b);
  }

  /* As for Ball, the part below zero is dropped. */
  friend Wide root(const Wide &a) {
    Wide out(a);
    if (mpfr_sgn(&out.x_->left) < 0) mpfr_set_zero(&out.x_->left, 1);
    if (mpfr_sgn(&out.x_->right) < 0) mpfr_set_zero(&out.x_->right, 1);
    mpfi_sqrt(out.x_, out.x_);
    return out;
  }

private:
  struct Blank {};
  explicit Wide(Blank) {
    mpfi_init2(x_, bits);
  }

  static Wide combine(int (*operation)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr), const Wide &a, const Wide &b) {
    Wide out((Blank()));
    operation(out.x_, a.x_, b.x_);
    return out;
  }

  static bool parse_decimal(const std::string &text, Wide &out) {
    char *end_down = nullptr, *end_up = nullptr;
    mpfr_strtofr(&out.x_->left, text.c_str(), &end_down, 10, MPFR_RNDD);
    mpfr_strtofr(&out.x_->right, text.c_str(), &end_up, 10, MPFR_RNDU);
    return !text.empty() && *end_down == '\0' && end_down == end_up && end_down != text.c_str() &&
           mpfr_number_p(&out.x_->left) != 0 && mpfr_number_p(&out.x_->right) != 0;
  }

  mpfi_t x_;
};

} // namespace host::oracle

#endif
