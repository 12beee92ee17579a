# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the files of the page into a C++ source (page_files.h), as string literals:
#   cmake -DOUT=... -DFOLDER=simulate/page -DTHREE=three.min.js;OrbitControls.js -P embed.cmake
# THREE is empty where libjs-three is not installed.
function(embed name)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ "${file}" content)
    string(APPEND text "${content}\n")
  endforeach()
  # What would end the literal, or the script element that it goes into.
  foreach(end IN ITEMS ")pcm_page\"" "</script" "</style")
    string(FIND "${text}" "${end}" place)
    if(NOT place EQUAL -1 AND NOT name STREQUAL "html")
      message(FATAL_ERROR "${ARGN}: '${end}' in it")
    endif()
  endforeach()
  file(APPEND "${OUT}" "constexpr char ${name}[] = R\"pcm_page(${text})pcm_page\";\n")
endfunction()

file(WRITE "${OUT}" "// Made by simulate/page/embed.cmake.\n#include \"simulate/page/page_files.h\"\n\n"
  "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\nnamespace pcm::simulate {\nnamespace {\n\n")
embed(html "${FOLDER}/page.html")
embed(css "${FOLDER}/page.css")
embed(scripts "${FOLDER}/data.js" "${FOLDER}/scene.js" "${FOLDER}/plots.js" "${FOLDER}/page.js")
embed(three_licence "${FOLDER}/three_licence.txt")
embed(three ${THREE})
# Lengths are told: counting them is more than compilers do in a constant.
file(APPEND "${OUT}" "\ntemplate <std::size_t size>\nconstexpr std::string_view text(const char (&literal)[size]) {\n"
  "  return {literal, size - 1};\n}\n\n}  // namespace\n\nconst PageFiles& page_files() {\n"
  "  static const PageFiles files{text(html), text(css), text(scripts), text(three), text(three_licence)};\n"
  "  return files;\n}\n\n"
  "}  // namespace pcm::simulate\n")
