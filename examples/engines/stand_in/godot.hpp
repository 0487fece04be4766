// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from godot-cpp, by the names of its classes.

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace godot {

struct Vector3 {
    float x, y, z;
};
struct Vector2 {
    float x, y;
};

template <class T>
class packed_array {
public:
    std::int64_t resize(std::int64_t n)
    {
        held_.resize(static_cast<std::size_t>(n));
        return 0;
    }
    std::int64_t size() const { return static_cast<std::int64_t>(held_.size()); }
    T* ptrw() { return held_.data(); }
    const T* ptr() const { return held_.data(); }

private:
    std::vector<T> held_;
};
using PackedVector3Array = packed_array<Vector3>;
using PackedVector2Array = packed_array<Vector2>;
using PackedFloat32Array = packed_array<float>;
using PackedInt32Array = packed_array<std::int32_t>;

using Variant =
    std::variant<std::monostate, PackedVector3Array, PackedVector2Array, PackedFloat32Array, PackedInt32Array>;
class Array {
public:
    std::int64_t resize(std::int64_t n)
    {
        held_.resize(static_cast<std::size_t>(n));
        return 0;
    }
    Variant& operator[](std::int64_t i) { return held_[static_cast<std::size_t>(i)]; }

private:
    std::vector<Variant> held_;
};

struct Mesh {
    enum ArrayType {
        ARRAY_VERTEX,
        ARRAY_NORMAL,
        ARRAY_TANGENT,
        ARRAY_COLOR,
        ARRAY_TEX_UV,
        ARRAY_TEX_UV2,
        ARRAY_INDEX = 12,
        ARRAY_MAX
    };
};

}  // namespace godot
