// SPDX-License-Identifier: Apache-2.0
#include "report/page.hpp"

#include <filesystem>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "report/web_files.hpp"

namespace trihedron::report {
namespace {

std::string html_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// JSON that may stand inside a script element: without '<' nothing can end the element. Bytes
/// that are not UTF-8, as in some file names, are replaced.
std::string script_json(const Json& data) {
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

/// The template with each "{{name}}" replaced; what is put in is not looked at again.
std::string filled(const std::string& page,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at);
    out += page.substr(at, open - at);
    if (open == std::string::npos) return out;
    const std::size_t close = page.find("}}", open);
    const std::string name = page.substr(open + 2, close - open - 2);
    for (const auto& [key, value] : values)
      if (key == name) out += value;
    at = close + 2;
  }
}

}  // namespace

std::string make_page(const PageContent& content) {
  const Json data = {{"title", content.title},
                     {"program", content.program},
                     {"scenes", content.scenes},
                     {"overview", content.overview}};
  return filled(web::kPage, {{"title", html_escaped(content.title)},
                             {"style", web::kStyle},
                             {"three", web::kThree},
                             {"three_licence", html_escaped(web::kThreeLicence)},
                             {"program", web::kProgram},
                             {"data", script_json(data)}});
}

void check_report_file(const std::string& file) {
  if (file.empty()) return;
  require_folder(std::filesystem::absolute(file).parent_path(), "a folder for --report");
  if (std::filesystem::is_directory(file))
    throw Error(file + ": --report is a folder; expected a file name");
}

}  // namespace trihedron::report
