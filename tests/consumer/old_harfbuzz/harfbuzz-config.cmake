# SPDX-License-Identifier: MIT
add_library(harfbuzz::harfbuzz INTERFACE IMPORTED)
set_target_properties(harfbuzz::harfbuzz PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR})
