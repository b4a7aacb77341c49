// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace trihedron::report::web {

// The files of the folder web/ and the three.js library, as the build embedded them.
extern const char* const kPage;     ///< page.html, the template
extern const char* const kStyle;    ///< style.css
extern const char* const kProgram;  ///< the page's own scripts, joined
extern const char* const kThree;    ///< three.js and its OrbitControls
extern const char* const kThreeLicence;

}  // namespace trihedron::report::web
