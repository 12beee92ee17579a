# SPDX-License-Identifier: BSD-3-Clause
# Run by each build: writes OUT, a source that defines `const char* FUNCTION()`, the commit that is checked out in SOURCE,
# with "-dirty" where files differ from it, or "unknown" outside of git. Touched only when it changes.
# cmake -DOUT=... -DSOURCE=... -DFUNCTION=pcm::compare::commit -P commit.cmake
find_program(git git)
set(commit "")
if(git AND EXISTS ${SOURCE}/.git)
  execute_process(
    COMMAND ${git} -C ${SOURCE} describe --always --exclude=* --abbrev=12 --dirty
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit STREQUAL "")
  set(commit unknown)
endif()
string(REGEX MATCH "^(.*)::([^:]+)$" unused ${FUNCTION})
file(WRITE ${OUT}.new "namespace ${CMAKE_MATCH_1} {
const char* ${CMAKE_MATCH_2}();
const char* ${CMAKE_MATCH_2}() { return \"${commit}\"; }
}
")
configure_file(${OUT}.new ${OUT} COPYONLY)
