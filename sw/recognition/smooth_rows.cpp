// SPDX-License-Identifier: Apache-2.0
#include "recognition/smooth_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "golden/gradient.hpp"

namespace trihedron {
namespace {

/// 16-bit words of a beat: gx, gy, and two that go along unused, because additions of whole rows
/// of words vectorise and picking words out does not.
constexpr std::size_t kWords = sizeof(ContourBeat) / sizeof(std::int16_t);
static_assert(kWords == 4);
static_assert(golden::kSlopeBits + 4 <= 16, "sums of sixteen slopes fit a word");

using Words = std::vector<std::int16_t>;

/// out = a + 2 b + c.
void binomial(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::size_t n,
              std::int16_t* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::int16_t>(a[i] + 2 * b[i] + c[i]);
}

/// The words of row y.
void read_row(const ViewFeatures& f, int y, Words& words) {
  words.resize(static_cast<std::size_t>(f.width) * kWords);
  std::memcpy(words.data(), &f.at(0, y), words.size() * sizeof(std::int16_t));
}

}  // namespace

void smooth_row(const ViewFeatures& f, int y, SmoothRow& row) {
  const auto width = static_cast<std::size_t>(f.width);
  for (auto* plane : {&row.gx, &row.gy, &row.magnitude}) plane->assign(width, 0.0F);
  if (y < 1 || y + 1 >= f.height || width < 3) return;
  thread_local Words up, mid, down, sums;
  read_row(f, y - 1, up);
  read_row(f, y, mid);
  read_row(f, y + 1, down);
  sums.resize(mid.size());
  binomial(up.data(), mid.data(), down.data(), mid.size(), sums.data());
  binomial(sums.data(), sums.data() + kWords, sums.data() + 2 * kWords, sums.size() - 2 * kWords,
           mid.data());
  constexpr float kWeight = 1.0F / 16;
  float* gx = row.gx.data() + 1;
  float* gy = row.gy.data() + 1;
  float* magnitude = row.magnitude.data() + 1;
  for (std::size_t x = 0; x + 2 < width; ++x) {
    gx[x] = kWeight * static_cast<float>(mid[kWords * x]);
    gy[x] = kWeight * static_cast<float>(mid[kWords * x + 1]);
  }
  for (std::size_t x = 0; x + 2 < width; ++x) {
    magnitude[x] = std::sqrt(gx[x] * gx[x] + gy[x] * gy[x]);
  }
}

void SmoothRows::move_to(int y) {
  const int last = std::min(y + kReach, features_.height - 1);
  for (; next_ <= last; ++next_) {
    smooth_row(features_, next_, rows_[static_cast<std::size_t>(next_) % rows_.size()]);
  }
}

}  // namespace trihedron
