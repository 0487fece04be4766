// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from <d3d11.h>, by the names and values of its documentation.

enum DXGI_FORMAT : unsigned {
    DXGI_FORMAT_R32G32B32_FLOAT = 6,
    DXGI_FORMAT_R32G32_FLOAT = 16,
    DXGI_FORMAT_R8G8B8A8_SNORM = 31,
    DXGI_FORMAT_R16G16_FLOAT = 34,
    DXGI_FORMAT_R32_UINT = 42,
    DXGI_FORMAT_R16_UINT = 57,
};
enum D3D11_INPUT_CLASSIFICATION { D3D11_INPUT_PER_VERTEX_DATA = 0 };

struct D3D11_INPUT_ELEMENT_DESC {
    const char* SemanticName;
    unsigned SemanticIndex;
    DXGI_FORMAT Format;
    unsigned InputSlot;
    unsigned AlignedByteOffset;
    D3D11_INPUT_CLASSIFICATION InputSlotClass;
    unsigned InstanceDataStepRate;
};
