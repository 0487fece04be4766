// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from <d3d9.h>, by the names and values of its documentation, without a device behind it.

#include <cstdint>
#include <vector>

using DWORD = std::uint32_t;
using UINT = unsigned;
using BYTE = std::uint8_t;
using WORD = std::uint16_t;
using HRESULT = std::int32_t;

inline constexpr DWORD D3DFVF_XYZ = 0x002, D3DFVF_NORMAL = 0x010, D3DFVF_TEX1 = 0x100;
enum D3DFORMAT : std::uint32_t { D3DFMT_INDEX16 = 101, D3DFMT_INDEX32 = 102 };
inline constexpr BYTE D3DDECLTYPE_FLOAT2 = 1, D3DDECLTYPE_FLOAT3 = 2, D3DDECLTYPE_UNUSED = 17;
inline constexpr BYTE D3DDECLMETHOD_DEFAULT = 0;
inline constexpr BYTE D3DDECLUSAGE_POSITION = 0, D3DDECLUSAGE_NORMAL = 3, D3DDECLUSAGE_TEXCOORD = 5;

struct D3DVERTEXELEMENT9 {
    WORD Stream, Offset;
    BYTE Type, Method, Usage, UsageIndex;
};
struct D3DVERTEXBUFFER_DESC {
    UINT Size;
    DWORD FVF;
};
struct D3DINDEXBUFFER_DESC {
    D3DFORMAT Format;
    UINT Size;
};

struct IDirect3DVertexBuffer9 {
    std::vector<std::uint8_t> bytes;
    int locks = 0;

    HRESULT GetDesc(D3DVERTEXBUFFER_DESC* d) noexcept
    {
        *d = {static_cast<UINT>(bytes.size()), D3DFVF_XYZ | D3DFVF_NORMAL | D3DFVF_TEX1};
        return 0;
    }
    HRESULT Lock(UINT offset, UINT, void** data, DWORD) noexcept
    {
        *data = bytes.data() + offset;
        ++locks;
        return 0;
    }
    HRESULT Unlock() noexcept
    {
        --locks;
        return 0;
    }
};
struct IDirect3DIndexBuffer9 {
    D3DFORMAT format = D3DFMT_INDEX16;
    std::vector<std::uint8_t> bytes;
    int locks = 0;

    HRESULT GetDesc(D3DINDEXBUFFER_DESC* d) noexcept
    {
        *d = {format, static_cast<UINT>(bytes.size())};
        return 0;
    }
    HRESULT Lock(UINT offset, UINT, void** data, DWORD) noexcept
    {
        *data = bytes.data() + offset;
        ++locks;
        return 0;
    }
    HRESULT Unlock() noexcept
    {
        --locks;
        return 0;
    }
};
