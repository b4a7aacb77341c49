// SPDX-License-Identifier: Apache-2.0
#include "recognition/smooth_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "golden/gradient.hpp"

namespace trihedron {
namespace {

static_assert(golden::kSlopeBits + 4 <= 16, "sums of sixteen slopes fit 16 bits");

/// out = a + 2 b + c; `out` is none of them.
void binomial(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::size_t n,
              std::int16_t* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::int16_t>(a[i] + 2 * b[i] + c[i]);
}

/// The slopes of row y, smoothed along it: sums for the pixels 1 to width - 2 in turn.
void sum_along(const ViewFeatures& f, int y, std::vector<std::int16_t>& out) {
  const auto width = static_cast<std::size_t>(f.width);
  thread_local std::vector<std::int16_t> slopes;
  slopes.resize(2 * width);
  out.resize(2 * width - 4);
  const ContourBeat* beats = &f.at(0, y);
  std::int16_t* to = slopes.data();  // as a plain pointer, or the loop does not vectorise
  static_assert(offsetof(ContourBeat, gx) == 0 && offsetof(ContourBeat, gy) == 2);
  for (std::size_t x = 0; x < width; ++x) std::memcpy(to + 2 * x, beats + x, 4);
  binomial(to, to + 2, to + 4, out.size(), out.data());
}

}  // namespace

const RowSums::Slopes& RowSums::of(const ViewFeatures& features, int y) {
  const std::size_t place = static_cast<std::size_t>(y) % sums_.size();
  if (row_[place] != y) sum_along(features, y, sums_[place]);
  row_[place] = y;
  return sums_[place];
}

void smooth_row(const ViewFeatures& f, int y, RowSums& sums, SmoothRow& row) {
  const auto width = static_cast<std::size_t>(f.width);
  for (auto* plane : {&row.gx, &row.gy, &row.magnitude}) plane->resize(width);
  if (y < 1 || y + 1 >= f.height || width < 3) {
    for (auto* plane : {&row.gx, &row.gy, &row.magnitude}) plane->assign(width, 0.0F);
    return;
  }
  for (auto* plane : {&row.gx, &row.gy, &row.magnitude}) plane->front() = plane->back() = 0;
  thread_local std::vector<std::int16_t> smoothed;
  smoothed.resize(2 * width - 4);
  binomial(sums.of(f, y - 1).data(), sums.of(f, y).data(), sums.of(f, y + 1).data(),
           smoothed.size(), smoothed.data());
  constexpr float kWeight = 1.0F / 16;
  const std::int16_t* smooth = smoothed.data();
  float* gx = row.gx.data() + 1;
  float* gy = row.gy.data() + 1;
  float* magnitude = row.magnitude.data() + 1;
  for (std::size_t x = 0; x + 2 < width; ++x) {
    std::int32_t both;  // gx in the lower half
    std::memcpy(&both, smooth + 2 * x, sizeof both);
    const float u = kWeight * static_cast<float>(static_cast<std::int16_t>(both));
    const float v = kWeight * static_cast<float>(both >> 16);
    gx[x] = u;
    gy[x] = v;
    magnitude[x] = std::sqrt(u * u + v * v);
  }
}

void SmoothRows::move_to(int y) {
  const int last = std::min(y + kReach, features_.height - 1);
  for (; next_ <= last; ++next_) {
    smooth_row(features_, next_, sums_, rows_[static_cast<std::size_t>(next_) % rows_.size()]);
  }
  middle_ = y;
  for (int k = -kReach; k <= kReach; ++k) {
    around_[static_cast<std::size_t>(k + kReach)] =
        &rows_[static_cast<std::size_t>(std::max(0, y + k)) % rows_.size()];
  }
}

}  // namespace trihedron
