// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/object_evidence.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// Adds to `surfaces` and `matches` the surfaces of objects[index] that the views show, each as it
/// was measured there: its corners are moved, in its plane, so that its edges run where they were
/// found; edges that were not found stay where they are predicted. Complete are surfaces of which
/// every edge was found over at least half its length.
void describe_surfaces(const std::vector<FieldView>& views, const std::vector<PlacedModel>& objects,
                       int index, const ObjectEvidence& evidence,
                       std::vector<SceneSurface>& surfaces, std::vector<SurfaceMatch>& matches);

}  // namespace trihedron
