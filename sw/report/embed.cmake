# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ source with one string per entry of NAMES: the text of the files that the
# variable of that name lists, one after the other.
set(source "#include \"report/web_files.hpp\"\n\nnamespace trihedron::report::web {\n\n")
foreach(name IN LISTS NAMES)
  set(text "")
  foreach(file IN LISTS ${name})
    file(READ ${file} part)
    string(APPEND text "${part}\n")
  endforeach()
  string(APPEND source "const char* const ${name} = R\"~embedded~(${text})~embedded~\";\n")
endforeach()
string(APPEND source "\n}  // namespace trihedron::report::web\n")
file(WRITE ${OUTPUT} "${source}")
