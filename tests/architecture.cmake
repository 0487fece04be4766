# SPDX-License-Identifier: MIT
#
# Includes go downward only; a room sees itself and the rooms named here, nothing else.
cmake_minimum_required(VERSION 3.20)

set(sees_core "")
foreach(room IN ITEMS outline layout discretise fill triangulate offset vertex)
    set(sees_${room} core)
endforeach()
set(sees_extrude offset vertex core)
set(sees_adapt outline layout vertex core)
set(sees_text extrude outline layout discretise fill triangulate offset vertex core)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../include/typemesh ABSOLUTE)
file(GLOB_RECURSE headers RELATIVE ${root} ${root}/*.hpp)
foreach(header IN LISTS headers)
    get_filename_component(room ${header} DIRECTORY)
    file(STRINGS ${root}/${header} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE ".*include[ \t]*[<\"]([^>\"]*)[>\"].*" "\\1" target "${line}")
        string(REGEX REPLACE "^typemesh/" "" seen "${target}")
        get_filename_component(seen "${seen}" DIRECTORY)
        if(NOT target MATCHES "^typemesh/")  # the standard library, which has no dot in its names; others for adapt only
            if(target MATCHES "[./]" AND NOT room STREQUAL "adapt")
                message(SEND_ERROR "include/typemesh/${header}: ${target} is third-party, only adapt may include such")
            endif()
        elseif(room STREQUAL "" AND NOT seen STREQUAL "adapt")  # typemesh.hpp
        elseif(NOT DEFINED sees_${room})
            message(SEND_ERROR "include/typemesh/${header}: ${room} is no room of the house (see tests/architecture.cmake)")
        elseif(NOT seen STREQUAL room AND NOT seen IN_LIST sees_${room})
            message(SEND_ERROR "include/typemesh/${header}: ${room} may not include ${target}")
        endif()
    endforeach()
    list(APPEND rooms ${room})
endforeach()

list(REMOVE_DUPLICATES rooms)
foreach(room IN LISTS rooms)
    file(GLOB tests ${CMAKE_CURRENT_LIST_DIR}/${room}/*.test.cpp)
    if(NOT tests)
        message(SEND_ERROR "include/typemesh/${room} has no tests in tests/${room}")
    endif()
endforeach()
