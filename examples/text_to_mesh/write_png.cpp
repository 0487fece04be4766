// SPDX-License-Identifier: MIT
#include "write_png.hpp"

#include <vector>

#define STB_IMAGE_WRITE_STATIC  // other libraries carry a copy of their own
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#if __has_include(<stb/stb_image_write.h>)
#include <stb/stb_image_write.h>
#else
#include <stb_image_write.h>
#endif

namespace text_to_mesh {

namespace {

/// Empty: there is no memory.
std::vector<unsigned char> png_bytes(const unsigned char* pixels, int width, int height, int channels)
{
    std::vector<unsigned char> file;
    const auto append = [](void* user, void* data, int size) {
        const auto* first = static_cast<const unsigned char*>(data);
        static_cast<std::vector<unsigned char>*>(user)->insert(static_cast<std::vector<unsigned char>*>(user)->end(),
                                                               first, first + size);
    };
    if (stbi_write_png_to_func(append, &file, width, height, channels, pixels, width * channels) == 0) file.clear();
    return file;
}

}  // namespace

std::string write_png(std::span<const unsigned char> rgb, int width, int height, const std::string& path,
                      file_set& files)
{
    if (width <= 0 || height <= 0 || rgb.size() != std::size_t(width) * std::size_t(height) * 3)
        return path + " cannot be written: the picture has no pixels.";
    const std::vector<unsigned char> file = png_bytes(rgb.data(), width, height, 3);
    if (file.empty()) return path + " cannot be written: there is no memory to compress the picture.";
    return files.add(path, file);
}

std::vector<unsigned char> png_with_alpha(std::span<const unsigned char> rgba, int width, int height)
{
    if (width <= 0 || height <= 0 || rgba.size() != std::size_t(width) * std::size_t(height) * 4) return {};
    return png_bytes(rgba.data(), width, height, 4);
}

}  // namespace text_to_mesh
