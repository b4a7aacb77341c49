// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recognition/model.hpp"
#include "render/random.hpp"

namespace trihedron::render {

enum class Variant { kNone, kScaled, kMirrored, kBoth };

/// The variant of that name: none, scaled, mirrored or both. Throws Error for another name.
Variant variant_of(const std::string& name);

/// Models that look like those of the library and are none of it: each stretched by 10 % along
/// one of its axes, drawn at random, or mirrored where the mirror image differs from the model.
/// Those that a motion maps onto a model of the library are left out. Ids start at
/// kFirstVariantId. kNone: the library as it is.
std::vector<Model> make_variants(const std::vector<Model>& library, Variant variant,
                                 Random& random);

/// Ids of variants, far above any real library's.
constexpr int kFirstVariantId = 900001;

/// Writes obj_NNNNNN.ply, models_info.json (diameter, extent, symmetries) and models_names.json.
/// Throws Error when the folder cannot be written.
void write_library(const std::filesystem::path& folder, const std::vector<Model>& library);

}  // namespace trihedron::render
