// SPDX-License-Identifier: MIT
#pragma once

#include <unknwn.h>

/// A function of an interface that no test needs.
#define TYPEMESH_TEST_UNUSED(name, ...) \
    HRESULT STDMETHODCALLTYPE name(__VA_ARGS__) noexcept override { return E_NOTIMPL; }

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
