// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>

#include <dwrite.h>

#include <cstdint>
#include <utility>

#if defined(_MSC_VER)  // for users who copy the headers
#pragma comment(lib, "dwrite")
#endif

namespace typemesh::inline TYPEMESH_ABI {

/// The error for an HRESULT of DirectWrite: none for success, error::out_of_memory, unreadable_file, not_a_font,
/// no_such_family, otherwise font_library_failed with the HRESULT as an unsigned number in `count`.
[[nodiscard]] inline error directwrite_error(HRESULT code) noexcept
{
    if (SUCCEEDED(code)) return {};
    const auto number = static_cast<std::uint32_t>(code);
    switch (number) {
    case 0x8007'000Eu: return error::out_of_memory;   // E_OUTOFMEMORY
    case 0x8898'5000u: return error::not_a_font;      // DWRITE_E_FILEFORMAT
    case 0x8898'5002u: return error::no_such_family;  // DWRITE_E_NOFONT
    case 0x8007'0002u:                                // HRESULT_FROM_WIN32(ERROR_FILE_NOT_FOUND), ..._PATH_NOT_FOUND,
    case 0x8007'0003u:                                // ERROR_ACCESS_DENIED
    case 0x8007'0005u:
    case 0x8898'5003u:                                 // DWRITE_E_FILENOTFOUND
    case 0x8898'5004u: return error::unreadable_file;  // DWRITE_E_FILEACCESS
    default: return error{error::font_library_failed, number};
    }
}

namespace detail {

/// Owns one reference to a COM object, or none.
template <class T>
class com_ptr {
public:
    com_ptr() noexcept = default;
    com_ptr(com_ptr&& other) noexcept : object_{std::exchange(other.object_, nullptr)} {}
    com_ptr& operator=(com_ptr&& other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    ~com_ptr()
    {
        if (object_ != nullptr) object_->Release();
    }

    /// Holds its own reference in addition to the caller's.
    [[nodiscard]] static com_ptr share(T* object) noexcept
    {
        com_ptr made;
        made.object_ = object;
        if (object != nullptr) object->AddRef();
        return made;
    }

    [[nodiscard]] T* get() const noexcept { return object_; }
    [[nodiscard]] T* operator->() const noexcept { return object_; }
    [[nodiscard]] explicit operator bool() const noexcept { return object_ != nullptr; }

    /// The address where a function stores a reference for this object. Only while it holds none.
    [[nodiscard]] T** put() noexcept
    {
        TYPEMESH_ASSERT(object_ == nullptr, "a com_ptr was filled while it held an object");
        return &object_;
    }

    /// Another interface of the object; empty if it does not have this interface.
    template <class U>
    [[nodiscard]] com_ptr<U> as(REFIID id = __uuidof(U)) const noexcept
    {
        com_ptr<U> made;
        void* found = nullptr;
        if (object_ != nullptr && SUCCEEDED(object_->QueryInterface(id, &found))) *made.put() = static_cast<U*>(found);
        return made;
    }

private:
    T* object_ = nullptr;
};

/// The base of all our COM objects: they live on the stack during one call of DirectWrite. References are counted only
/// to check that nothing keeps them longer. No call of DirectWrite does, Microsoft's or Wine's. If one did, an
/// assertion would report it; with NDEBUG, its Release() would access memory that is then used otherwise. Replacements
/// of DirectWrite's objects must release ours before they return.
template <class Interface>
class stack_object : public Interface {
public:
    stack_object() noexcept = default;
    stack_object(const stack_object&) = delete;
    stack_object& operator=(const stack_object&) = delete;

    ULONG STDMETHODCALLTYPE AddRef() noexcept override { return ++references_; }
    ULONG STDMETHODCALLTYPE Release() noexcept override { return --references_; }
    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID wanted, void** out) noexcept override
    {
        if (out == nullptr) return E_POINTER;
        *out = nullptr;
        if (!IsEqualGUID(wanted, __uuidof(IUnknown)) && !IsEqualGUID(wanted, __uuidof(Interface)) && !is_also(wanted))
            return E_NOINTERFACE;
        *out = static_cast<Interface*>(this);
        AddRef();
        return S_OK;
    }

protected:
    ~stack_object() { TYPEMESH_ASSERT(references_ == 1, "a COM object was kept beyond the call that lent it"); }

    /// Whether `wanted` is another base interface of Interface.
    [[nodiscard]] virtual bool is_also(REFIID) const noexcept { return false; }

private:
    ULONG references_ = 1;
};

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI
