// SPDX-License-Identifier: Apache-2.0
#include "report/page.hpp"

#include <catch2/catch.hpp>

#include "report/web_files.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

report::PageContent content_with(const std::string& text) {
  report::PageContent content;
  content.title = text;
  content.scenes.push_back({{"scene", text}});
  return content;
}

/// The page's data as a browser reads it: from its script element up to the first end of one.
report::Json data_of(const std::string& page) {
  const std::string open = "id=\"data\">";
  const std::size_t start = page.find(open) + open.size();
  return report::Json::parse(page.substr(start, page.find("</script", start) - start));
}

}  // namespace

TEST_CASE("text that looks like markup stays text in a report") {
  const std::string evil = "</script><script>alert(1)</script><!-- {{style}} \" & '";
  const std::string page = report::make_page(content_with(evil));
  CHECK(count(page, "alert(1)</script>") == 0);
  CHECK_THAT(page, Contains("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK(data_of(page).at("scenes").at(0).at("scene") == evil);
  CHECK(count(page, "</script") == count(report::make_page(content_with("plain")), "</script"));
}

TEST_CASE("bytes that are no UTF-8 do not stop a report") {
  const std::string page = report::make_page(content_with("scene \xff\xfe"));
  CHECK(data_of(page).at("title") == "scene \xef\xbf\xbd\xef\xbf\xbd");
}

TEST_CASE("a report holds its programs, styles and the licence of three.js, and no address") {
  const std::string page = report::make_page(content_with("one"));
  for (const char* part : {report::web::kStyle, report::web::kProgram, report::web::kThree})
    CHECK(count(page, part) == 1);
  CHECK_THAT(page, Contains("three.js authors (The MIT License)"));
  CHECK(count(page, "{{") == count(report::web::kThree, "{{"));
  for (const char* address : {"src=\"http", "href=\"http", "src=\"//", "@import", "url("})
    CHECK(count(page, address) == 0);
}

TEST_CASE("a report cannot be written into a missing folder or over a folder") {
  const Scratch scratch;
  CHECK_THAT(error_of([&] { report::check_report_file((scratch / "no/r.html").string()); }),
             Contains("no such folder; expected a folder for --report"));
  CHECK_THAT(error_of([&] { report::check_report_file(scratch.path().string()); }),
             Contains("--report is a folder; expected a file name"));
  CHECK(error_of([&] { report::check_report_file((scratch / "r.html").string()); }) == "no error");
}
