# SPDX-License-Identifier: MIT
#
# Configures, builds and runs one user's project; with `says` the configuring must fail in those words.
cmake_minimum_required(VERSION 3.20)

file(REMOVE_RECURSE ${binary})
set(how -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_PREFIX_PATH=${prefix})
if(toolchain)  # it looks nowhere but in its own folders, save where it is told
    set(how -DCMAKE_TOOLCHAIN_FILE=${toolchain} -Dtypemesh_DIR=${prefix}/share/cmake/typemesh)
    string(REPLACE "," ";" emulator "${emulator}")
endif()
execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${binary} -G ${generator}
        ${how} -Dtypemesh_source=${typemesh} -Dway=${way}
        ${arguments}
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(says)
    string(REGEX REPLACE "[ \n]+" " " output "${output}")
    if(NOT failed OR NOT output MATCHES "${says}")
        message(FATAL_ERROR "expected to be refused with '${says}', got:\n${output}")
    endif()
    return()
endif()
if(NOT failed)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${binary}
        RESULT_VARIABLE failed OUTPUT_VARIABLE more ERROR_VARIABLE more)
    string(APPEND output "${more}")
endif()
if(NOT failed)
    execute_process(COMMAND ${emulator} ${binary}/user${suffix} RESULT_VARIABLE failed OUTPUT_VARIABLE more ERROR_VARIABLE more)
    string(APPEND output "${more}")
endif()
if(failed)
    message(FATAL_ERROR "${output}")
endif()
