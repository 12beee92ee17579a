# SPDX-License-Identifier: BSD-3-Clause
# pcm_embed_text(OUTPUT.cpp FUNCTION FILE): a source that defines `std::string_view FUNCTION()`, the file's text. Made
# anew when the file changes. FUNCTION is qualified, e.g. pcm::simulate::scene_schema.
function(pcm_embed_text output function file)
  get_filename_component(file ${file} ABSOLUTE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  # A literal may be 64 KiB long by the standard; raw ones are joined.
  string(LENGTH "${text}" length)
  set(literals "")
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} 16000 piece)
    string(APPEND literals "R\"pcm(${piece})pcm\"\n")
    math(EXPR begin "${begin} + 16000")
  endwhile()
  string(REGEX MATCH "^(.*)::([^:]+)$" unused ${function})
  # Touched only when it changes.
  file(WRITE ${output}.new "#include <string_view>
namespace ${CMAKE_MATCH_1} {
std::string_view ${CMAKE_MATCH_2}();
std::string_view ${CMAKE_MATCH_2}() {
  static constexpr char kText[] = ${literals};
  return {kText, sizeof kText - 1};
}
}
")
  configure_file(${output}.new ${output} COPYONLY)
endfunction()
