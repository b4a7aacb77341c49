// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/json_numbers.hpp"

namespace trihedron::report {

/// What a page is made of. `scenes` as from scene_data; an overview ("lines": scene_line each
/// with "full", its index in `scenes` or -1; "note": text) is null for the report of one scene.
struct PageContent {
  std::string title;    ///< plain text
  std::string program;  ///< name and version
  Json scenes = Json::array();
  Json overview;
};

/// The page as one HTML file: styles, programs, data and pictures are inside, and its policy allows
/// no address outside. Text from the content is shown as text, whatever is in it.
std::string make_page(const PageContent& content);

/// Throws Error unless a report can be written to `file`: a file name in a folder that is there.
/// For use before the work, whose results must not be lost.
void check_report_file(const std::string& file);

}  // namespace trihedron::report
