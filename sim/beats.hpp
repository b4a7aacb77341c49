// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/features.hpp"

namespace trihedron::sim {

/// The contour stream's 64-bit beat of one pixel: flags [7:0], magnitude [23:8], gx [39:24],
/// gy [55:40].
inline std::uint64_t pack(const ContourBeat& beat) {
  return std::uint64_t{beat.flags} | std::uint64_t{beat.magnitude} << 8 |
         std::uint64_t{static_cast<std::uint16_t>(beat.gx)} << 24 |
         std::uint64_t{static_cast<std::uint16_t>(beat.gy)} << 40;
}
inline ContourBeat unpack_beat(std::uint64_t bits) {
  ContourBeat beat;
  beat.flags = static_cast<std::uint8_t>(bits);
  beat.magnitude = static_cast<std::uint16_t>(bits >> 8);
  beat.gx = static_cast<std::int16_t>(bits >> 24);
  beat.gy = static_cast<std::int16_t>(bits >> 40);
  return beat;
}

/// The vertex stream's 64-bit record without its view and frame tag: kind [1:0] = 0,
/// x [27:16], y [39:28], branches [43:40], pattern [51:44], strength [63:52].
inline std::uint64_t pack(const Vertex& vertex) {
  return std::uint64_t{vertex.x} << 16 | std::uint64_t{vertex.y} << 28 |
         std::uint64_t{vertex.branches} << 40 | std::uint64_t{vertex.pattern} << 44 |
         std::uint64_t{vertex.strength} << 52;
}
inline Vertex unpack_vertex(std::uint64_t bits) {
  Vertex vertex;
  vertex.x = (bits >> 16) & 0xfff;
  vertex.y = (bits >> 28) & 0xfff;
  vertex.branches = (bits >> 40) & 0xf;
  vertex.pattern = (bits >> 44) & 0xff;
  vertex.strength = static_cast<std::uint16_t>(bits >> 52);
  return vertex;
}

/// The end-of-frame record: kind [1:0] = 1, vertices sent [31:16], lost [47:32], status [63:48].
struct EndOfFrame {
  std::uint16_t sent = 0;
  std::uint16_t lost = 0;
  std::uint16_t status = 0;
};
inline EndOfFrame unpack_end(std::uint64_t bits) {
  return {static_cast<std::uint16_t>(bits >> 16), static_cast<std::uint16_t>(bits >> 32),
          static_cast<std::uint16_t>(bits >> 48)};
}

/// What both kinds of record share: kind [1:0], view [5:2], frame tag [15:8].
inline unsigned record_kind(std::uint64_t bits) { return bits & 3; }
inline unsigned record_tag(std::uint64_t bits) { return (bits >> 8) & 0xff; }
inline std::uint64_t record_head(unsigned kind, int view, std::int64_t frame) {
  return kind | static_cast<std::uint64_t>(view) << 2 |
         (static_cast<std::uint64_t>(frame) & 0xff) << 8;
}
constexpr std::uint64_t kHeadMask = 0xffff;
constexpr unsigned kVertexKind = 0;
constexpr unsigned kEndKind = 1;

}  // namespace trihedron::sim
