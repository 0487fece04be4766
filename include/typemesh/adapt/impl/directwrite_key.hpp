// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_axes.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/outline/impl/variation_key.hpp>

#include <dwrite.h>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The drawing of a DirectWrite face, in 64 bits for a variation_key(). If DirectWrite does not report it, the key is
/// unique.
class directwrite_key {
public:
    void mix(std::uint64_t number) noexcept { key_ = mixed_key(key_, number); }
    void mix(double number) noexcept { mix(option_bits{number}.words[0]); }

    /// Adds the font (by the checksum in its 'head' table, its number of glyphs and its face index) and the state of
    /// the face: its simulations and its axes.
    void mix_state(IDWriteFontFace* face) noexcept
    {
        mix(checksum(face));
        mix(std::uint64_t{face->GetGlyphCount()});
        mix(std::uint64_t{face->GetIndex()});
        mix(static_cast<std::uint64_t>(face->GetSimulations()));
        const auto on_axes = varied(face);
        if (!on_axes) return;
        directwrite_axis_value axes[max_axes] = {};
        const UINT32 count = on_axes->GetFontAxisValueCount();
        if (count > max_axes || FAILED(on_axes->GetFontAxisValues(axes, count))) {
            is_known_ = false;
            return;
        }
        mix(std::uint64_t{count});
        for (UINT32 i = 0; i < count; ++i) {
            mix(std::uint64_t{axes[i].tag});
            mix(double{axes[i].value});
        }
    }

    /// Adds the files of the face, by path and time of writing. Files outside the system (in memory, or from a caller's
    /// loader) count as unknown: a loader's keys mean nothing after the loader is gone.
    void mix_files(IDWriteFontFace* face) noexcept
    {
        IDWriteFontFile* files[max_files] = {};
        UINT32 count = 0;
        if (FAILED(face->GetFiles(&count, nullptr)) || count == 0 || count > max_files ||
            FAILED(face->GetFiles(&count, files))) {
            is_known_ = false;
            return;
        }
        mix(std::uint64_t{count});
        for (UINT32 i = 0; i < count; ++i) {
            com_ptr<IDWriteFontFile> file;
            *file.put() = files[i];
            if (!mix_file(file)) is_known_ = false;
        }
    }

    /// The key. No two calls may have both `owner` and `time` in common.
    [[nodiscard]] std::uint64_t value(const void* owner, std::uint64_t time) const noexcept
    {
        if (is_known_) return key_;
        return mixed_key(mixed_key(key_, reinterpret_cast<std::uintptr_t>(owner)), time);
    }

    /// A number that only grows, for value(): ticks of at most a microsecond.
    [[nodiscard]] static std::uint64_t now() noexcept
    {
        LARGE_INTEGER ticks = {};
        QueryPerformanceCounter(&ticks);
        return static_cast<std::uint64_t>(ticks.QuadPart);
    }

private:
    static constexpr UINT32 max_axes = 64, max_files = 8, longest_path = 1024;

    /// checkSumAdjustment, over the whole file; 0 if there is none.
    static std::uint64_t checksum(IDWriteFontFace* face) noexcept
    {
        constexpr UINT32 head = 0x6461'6568;  // as DirectWrite writes tags: the first letter lowest
        const void* data = nullptr;
        void* context = nullptr;
        UINT32 size = 0;
        BOOL exists = FALSE;
        if (FAILED(face->TryGetFontTable(head, &data, &size, &context, &exists)) || exists == FALSE) return 0;
        std::uint64_t sum = 0;
        for (UINT32 i = 8; i < 12 && i < size; ++i) sum = sum << 8 | static_cast<const unsigned char*>(data)[i];
        if (context != nullptr) face->ReleaseFontTable(context);
        return sum;
    }

    bool mix_file(const com_ptr<IDWriteFontFile>& file) noexcept
    {
        const void* key = nullptr;
        UINT32 size = 0, length = 0;
        FILETIME written = {};
        wchar_t path[longest_path] = {};
        com_ptr<IDWriteFontFileLoader> loader;
        if (!file || FAILED(file->GetReferenceKey(&key, &size)) || FAILED(file->GetLoader(loader.put()))) return false;
        const auto local = loader.as<IDWriteLocalFontFileLoader>();
        if (!local || FAILED(local->GetLastWriteTimeFromKey(key, size, &written)) ||
            FAILED(local->GetFilePathLengthFromKey(key, size, &length)) || length >= longest_path ||
            FAILED(local->GetFilePathFromKey(key, size, path, longest_path)))
            return false;
        mix(std::uint64_t{written.dwHighDateTime} << 32 | written.dwLowDateTime);
        mix(std::uint64_t{length});
        for (UINT32 i = 0; i < length; ++i) mix(static_cast<std::uint64_t>(path[i]));
        return true;
    }

    std::uint64_t key_ = 0x6477'7269'7465;
    bool is_known_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
