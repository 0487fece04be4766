// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from Unreal Engine, by the names of its API reference. The tangent basis is packed into 8 bits
// a component, as the engine does by default: TangentX, and TangentZ with the sign of the basis in w.

#include <cmath>
#include <cstdint>
#include <vector>

struct FVector3f {
    float X, Y, Z;
};
struct FVector4f {
    float X, Y, Z, W;
};
struct FVector2f {
    float X, Y;
};

template <class T>
class TArray {
public:
    using ElementType = T;
    void SetNumUninitialized(std::int32_t n) { held_.resize(static_cast<std::size_t>(n)); }
    T* GetData() { return held_.data(); }
    std::int32_t Num() const { return static_cast<std::int32_t>(held_.size()); }
    T& operator[](std::int32_t i) { return held_[static_cast<std::size_t>(i)]; }

private:
    std::vector<T> held_;
};

class FPositionVertexBuffer {
public:
    void Init(std::uint32_t n, bool = true) { held_.resize(n); }
    FVector3f& VertexPosition(std::uint32_t i) { return held_[i]; }
    std::uint32_t GetNumVertices() const { return static_cast<std::uint32_t>(held_.size()); }

private:
    std::vector<FVector3f> held_;
};

class FStaticMeshVertexBuffer {
public:
    void Init(std::uint32_t n, std::uint32_t, bool = true) { held_.resize(n); }
    void SetVertexTangents(std::uint32_t i, FVector3f X, FVector3f Y, FVector3f Z)
    {
        const float determinant =
            X.X * (Y.Y * Z.Z - Y.Z * Z.Y) - X.Y * (Y.X * Z.Z - Y.Z * Z.X) + X.Z * (Y.X * Z.Y - Y.Y * Z.X);
        const auto pack = [](float f) { return static_cast<std::int8_t>(std::lround(f * 127.0f)); };
        const std::int8_t x[] = {pack(X.X), pack(X.Y), pack(X.Z)}, z[] = {pack(Z.X), pack(Z.Y), pack(Z.Z)};
        for (int k = 0; k < 3; ++k) held_[i].x[k] = x[k], held_[i].z[k] = z[k];
        held_[i].z[3] = determinant < 0.0f ? -127 : 127;
    }
    void SetVertexUV(std::uint32_t i, std::uint32_t, FVector2f uv) { held_[i].uv = uv; }
    FVector2f GetVertexUV(std::uint32_t i, std::uint32_t) const { return held_[i].uv; }
    FVector4f VertexTangentX(std::uint32_t i) const { return read(held_[i].x); }
    FVector4f VertexTangentZ(std::uint32_t i) const { return read(held_[i].z); }

private:
    struct vertex {
        std::int8_t x[4] = {}, z[4] = {};
        FVector2f uv{};
    };
    static FVector4f read(const std::int8_t (&b)[4])
    {
        return {static_cast<float>(b[0]) / 127.0f, static_cast<float>(b[1]) / 127.0f, static_cast<float>(b[2]) / 127.0f,
                static_cast<float>(b[3]) / 127.0f};
    }
    std::vector<vertex> held_;
};

struct FStaticMeshVertexBuffers {
    FStaticMeshVertexBuffer StaticMeshVertexBuffer;
    FPositionVertexBuffer PositionVertexBuffer;
};
