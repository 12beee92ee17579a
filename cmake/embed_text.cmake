# SPDX-License-Identifier: BSD-3-Clause
# pcm_embed_text(OUTPUT.cpp FUNCTION FILE): a source that defines `std::string_view FUNCTION()`, the file's text. Made
# anew when the file changes. FUNCTION is qualified, e.g. pcm::simulate::scene_schema.
function(pcm_embed_text output function file)
  get_filename_component(file ${file} ABSOLUTE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  # Character by character: compilers need not take literals longer than 64 KiB.
  file(READ ${file} digits HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," characters "${digits}")
  string(REGEX MATCH "^(.*)::([^:]+)$" unused ${function})
  # Touched only when it changes.
  file(WRITE ${output}.new "#include <string_view>
namespace ${CMAKE_MATCH_1} {
std::string_view ${CMAKE_MATCH_2}();
std::string_view ${CMAKE_MATCH_2}() {
  static constexpr char kText[] = {${characters}};
  return {kText, sizeof kText};
}
}
")
  configure_file(${output}.new ${output} COPYONLY)
endfunction()
