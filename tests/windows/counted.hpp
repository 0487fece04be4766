// SPDX-License-Identifier: MIT
#pragma once

#include <unknwn.h>

namespace test {

/// An object with one interface, which counts its references and lives as long as its variable.
template <class Interface>
class counted : public Interface {
public:
    ULONG references = 1;

    ULONG STDMETHODCALLTYPE AddRef() noexcept override { return ++references; }
    ULONG STDMETHODCALLTYPE Release() noexcept override { return --references; }
    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID, void** out) noexcept override
    {
        *out = nullptr;
        return E_NOINTERFACE;
    }
};

}  // namespace test
