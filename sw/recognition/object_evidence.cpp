// SPDX-License-Identifier: Apache-2.0
#include "recognition/object_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recognition/view_shift.hpp"

namespace trihedron {
namespace {

/// A clear edge: its height in standard deviations of image noise.
constexpr double kClearHeight = 5.0;
/// Exact positions agree within this, px: the pose's error and the model's, three deviations.
constexpr double kExactPx = 1.0;
/// Contour pixels agree within this, px: thinning to whole pixels adds up to 0.7.
constexpr double kContourPx = 1.8;
/// Two lines nearer than about this share one contour, px.
constexpr double kMergedPx = 3.5;
/// Predicted lines of two objects within this are one contour, px.
constexpr double kSharedPx = 4.0;
/// Contours within this of a predicted line belong to it, px.
constexpr double kExplainedPx = 3.0;

/// Points that tell how a view is shifted, apart and away from junctions, px.
constexpr double kShiftStepPx = 8, kShiftEndPx = 4;

/// A predicted line in the image.
struct Line {
  Eigen::Vector2d x0, along, normal;  // start, px; unit vectors
  double length_px;

  bool passes(const Eigen::Vector2d& x, double within_px) const {
    const Eigen::Vector2d to = x - x0;
    if (std::abs(normal.dot(to)) > within_px) return false;
    const double t = along.dot(to);
    return t > -within_px && t < length_px + within_px;
  }
};

/// Those of about a direction, the only ones that have a contour with such a normal.
void lines_along(const std::vector<VisibleEdge>& edges, const Eigen::Vector2d& normal,
                 std::vector<Line>& out) {
  constexpr double kSameDirection = 0.8;  // cosine, about 37 degrees
  out.clear();
  for (const VisibleEdge& e : edges) {
    if (std::abs(e.normal.dot(normal)) < kSameDirection) continue;
    out.push_back({e.x0, (e.x1 - e.x0) / std::max(e.length_px, 1e-9), e.normal, e.length_px});
  }
}

bool explained(const Eigen::Vector2d& x, double within_px, const std::vector<Line>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const Line& line) { return line.passes(x, within_px); });
}

enum class Finding { kFound, kDisplaced, kFlat, kSilent };

/// The mean grey steps across the points of a piece that show no contour, at and beside the place
/// that is predicted.
class FaintStep {
 public:
  void add(const ContourField& field, const EdgePoint& p) {
    constexpr int kReach = kBesidePx + ContourField::kStepReach;
    if (!field.inside(p.x, kReach + 1)) return;
    std::array<float, 2 * kReach + 1> gradients;
    field.gradients_along(p.x, p.normal, -kReach, kReach, gradients.data());
    for (int d = -kBesidePx; d <= kBesidePx; ++d) {
      sum_[d + kBesidePx] += field.step(&gradients[static_cast<std::size_t>(d + kReach)]);
    }
    ++n_;
  }
  /// Whether there is a step at the predicted place that neither noise (four deviations) nor
  /// whatever else changes nearby makes: the largest around, and well above the others.
  bool clear() const {
    constexpr double kDeviations = 4, kAboveOthers = 2;
    std::array<double, kPlaces> sorted = sum_;
    std::nth_element(sorted.begin(), sorted.begin() + kPlaces / 2, sorted.end());
    const double shading = sorted[kPlaces / 2];
    double here = 0, others = 0;
    for (int d = -kBesidePx; d <= kBesidePx; ++d) {
      const double step = std::abs(sum_[d + kBesidePx] - shading);
      if (std::abs(d) <= 1) here = std::max(here, step);
      if (std::abs(d) >= kApartPx) others = std::max(others, step);
    }
    return here > kDeviations * std::sqrt(n_) && here > kAboveOthers * others;
  }

 private:
  static constexpr int kBesidePx = 8;
  static constexpr int kApartPx = 4;  // steps nearer than this share their pixels
  static constexpr int kPlaces = 2 * kBesidePx + 1;
  std::array<double, kPlaces> sum_ = {};
  int n_ = 0;
};

struct Collector {
  const FieldView& view;
  const std::vector<VisibleEdge>& lines;  // of all objects
  std::vector<VisibleEdge> earlier;       // of objects that come first, and of pieces before this
  double least_px, reach_px;              // displacements that count
  bool exact_offsets;
  std::vector<Line> lines_here, earlier_here;  // along the piece in question
  std::vector<double> hits;

  void start(const VisibleEdge& piece) {
    lines_along(lines, piece.normal, lines_here);
    lines_along(earlier, piece.normal, earlier_here);
  }

  /// What is at the point; `offset` is the distance of what was found there or beside it.
  Finding look(const EdgePoint& p, double& offset) {
    // A contour proves one line only: where an earlier one runs, nothing is learnt.
    if (explained(p.x, kSharedPx, earlier_here)) return Finding::kSilent;
    if (!view.field->inside(p.x, ContourField::kProfilePx)) return look_beside(p, offset);
    constexpr double kPixelPx =
        2;  // a contour's pixels may be nearer than the walk to them by less
    const double tolerance = p.crowded ? kMergedPx : kContourPx;
    offset = view.field->nearest_contour(p.x, p.normal, std::min(tolerance + kPixelPx, reach_px));
    const bool contour = std::abs(offset) < tolerance;  // false of NaN
    if (contour && !exact_offsets) return Finding::kFound;
    const EdgeProfile profile = view.field->profile(p.x, p.normal);
    const bool clear = std::abs(profile.height) > kClearHeight * profile.sigma_height;
    if (clear && std::abs(profile.offset_px) < kExactPx) {
      offset = profile.offset_px;
      return Finding::kFound;
    }
    return contour ? Finding::kFound : look_beside(p, offset);
  }

  Finding look_beside(const EdgePoint& p, double& offset) {
    view.field->contours_across(p.x, p.normal, reach_px, hits);
    for (double d : hits) {
      if (std::abs(d) < least_px || explained(p.x + d * p.normal, kExplainedPx, lines_here))
        continue;
      offset = d;
      return Finding::kDisplaced;
    }
    return view.field->inside(p.x, ContourField::kProfilePx) ? Finding::kFlat : Finding::kSilent;
  }
};

/// A point beside which an edge was found.
struct Beside {
  double position = 0;  // px along the piece
  double distance = 0;  // px along its normal
};

/// How many of the points lie on one nearly parallel line, and its distance at their middle.
int on_parallel_line(const std::vector<Beside>& points, double& distance) {
  constexpr double kOnLinePx = 1.5;  // a contour pixel's centre is off by up to 0.7
  constexpr double kSlope = 0.15;    // a shape 10 % different turns an edge by less
  int best = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i; j < points.size(); ++j) {
      const double run = points[j].position - points[i].position;
      const double slope = j == i ? 0 : (points[j].distance - points[i].distance) / run;
      if (std::abs(slope) > kSlope) continue;
      int count = 0;
      for (const Beside& p : points) {
        const double on = points[i].distance + slope * (p.position - points[i].position);
        count += std::abs(p.distance - on) < kOnLinePx;
      }
      if (count > best) {
        best = count;
        distance = 0.5 * (points[i].distance + points[j].distance);
      }
    }
  }
  return best;
}

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void settle(PieceEvidence& piece, const std::vector<Beside>& beside, std::vector<double>& found) {
  const double n = std::max(1, piece.points);
  piece.found = static_cast<double>(found.size()) / n;
  piece.offset_px = median(found);
  piece.displaced = on_parallel_line(beside, piece.displacement_px) / n;
  piece.flat = 1 - piece.found - piece.displaced;
}

void collect_view(const FieldView& view, int v, const std::vector<PlacedModel>& objects, int index,
                  bool exact_offsets, ObjectEvidence& out) {
  auto lines = visible_edges(*view.camera, objects);
  std::vector<VisibleEdge> own, others;
  for (const VisibleEdge& line : lines) {
    if (line.object == index) own.push_back(line);
  }
  const Eigen::Vector2d shift =
      view_shift(*view.field, edge_points(view, v, own, kShiftStepPx, kShiftEndPx));
  own.clear();
  for (VisibleEdge& line : lines) {
    line.x0 += shift;
    line.x1 += shift;
  }
  for (const VisibleEdge& line : lines) {
    if (line.object == index) own.push_back(line);
    if (line.object < index) others.push_back(line);
  }
  const PlacedModel& placed = objects[index];
  const double px_per_mm = view.camera->px_per_mm_at(placed.world_from_model.t);
  Collector collector{view,
                      lines,
                      std::move(others),
                      std::max(kContourPx, kLeastDisplacementMm * px_per_mm),
                      kSimilarShapes * placed.model->diameter * px_per_mm,
                      exact_offsets,
                      {},
                      {},
                      {}};
  auto points = edge_points(view, v, own, kEvidenceStepPx, 2, collector.reach_px);
  for (EdgePoint& p : points) p.x += shift;
  mark_crowded(own, points);
  std::vector<Beside> beside;
  std::vector<double> found;
  for (std::size_t i = 0; i < points.size();) {
    PieceEvidence piece;
    const VisibleEdge& line = own[points[i].piece];
    piece.view = v;
    piece.edge = line.edge;
    piece.surface = line.surface;
    piece.type = line.type;
    piece.length_px = line.length_px;
    piece.normal = line.normal;
    piece.middle_in_world = 0.5 * (line.x0_in_world + line.x1_in_world);
    collector.start(line);
    found.clear();
    FaintStep faint;
    beside.clear();
    for (const int at = points[i].piece; i < points.size() && points[i].piece == at; ++i) {
      double offset = 0;
      const Finding finding = collector.look(points[i], offset);
      piece.points += finding != Finding::kSilent;
      if (finding == Finding::kFlat) faint.add(*view.field, points[i]);
      if (finding == Finding::kFound) found.push_back(offset);
      if (finding == Finding::kDisplaced) {
        beside.push_back({(points[i].x - line.x0).norm(), offset});
      }
    }
    collector.earlier.push_back(line);
    if (piece.points == 0) continue;
    settle(piece, beside, found);
    if (faint.clear()) std::swap(piece.weak, piece.flat);
    out.found_px += piece.found * piece.length_px;
    out.displaced_px += piece.displaced * piece.length_px;
    out.flat_px += (piece.flat + piece.weak) * piece.length_px;
    out.pieces.push_back(piece);
  }
}

}  // namespace

ObjectEvidence collect_evidence(const std::vector<FieldView>& views,
                                const std::vector<PlacedModel>& objects, int index,
                                bool exact_offsets) {
  ObjectEvidence out;
  for (int v = 0; v < static_cast<int>(views.size()); ++v) {
    collect_view(views[v], v, objects, index, exact_offsets, out);
  }
  return out;
}

}  // namespace trihedron
