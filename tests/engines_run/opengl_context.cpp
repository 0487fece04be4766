// SPDX-License-Identifier: MIT
#include "opengl_context.hpp"

#define GLX_GLXEXT_PROTOTYPES
#include <GL/glx.h>
#include <GL/glxext.h>

struct opengl_context::handles {
    Display* display = nullptr;
    GLXPbuffer surface = 0;
    GLXContext context = nullptr;
};

opengl_context::opengl_context() : x_{new handles}
{
    x_->display = XOpenDisplay(nullptr);
    if (x_->display == nullptr) {
        failure_ = "there is no display";
        return;
    }
    const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT, 0};
    int count = 0;
    GLXFBConfig* const configs = glXChooseFBConfig(x_->display, DefaultScreen(x_->display), wanted, &count);
    if (configs == nullptr || count == 0) {
        failure_ = "GLX has no format to draw in";
        return;
    }
    const int version[] = {
        GLX_CONTEXT_MAJOR_VERSION_ARB,    3, GLX_CONTEXT_MINOR_VERSION_ARB, 3, GLX_CONTEXT_PROFILE_MASK_ARB,
        GLX_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
    const int size[] = {GLX_PBUFFER_WIDTH, 16, GLX_PBUFFER_HEIGHT, 16, 0};
    x_->context = glXCreateContextAttribsARB(x_->display, configs[0], nullptr, True, version);
    x_->surface = glXCreatePbuffer(x_->display, configs[0], size);
    XFree(configs);
    if (x_->context == nullptr || !glXMakeContextCurrent(x_->display, x_->surface, x_->surface, x_->context))
        failure_ = "GLX makes no context of OpenGL 3.3";
}

opengl_context::~opengl_context()
{
    if (x_->display != nullptr) {
        glXMakeContextCurrent(x_->display, 0, 0, nullptr);
        if (x_->context != nullptr) glXDestroyContext(x_->display, x_->context);
        if (x_->surface != 0) glXDestroyPbuffer(x_->display, x_->surface);
        XCloseDisplay(x_->display);
    }
    delete x_;
}
