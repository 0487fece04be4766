// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// An OpenGL 3.3 context on the display, current while it lives. X11's headers stay in opengl_context.cpp: their macros
/// (None, Bool, Status) take names from everybody.
class opengl_context {
public:
    opengl_context();
    ~opengl_context();
    opengl_context(const opengl_context&) = delete;
    opengl_context& operator=(const opengl_context&) = delete;

    [[nodiscard]] const std::string& failure() const { return failure_; }  ///< empty when all is well

private:
    struct handles;
    handles* x_;
    std::string failure_;
};
