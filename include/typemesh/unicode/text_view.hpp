// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The encoding of a text's units.
enum class encoding : std::uint8_t { utf8, utf16 };

/// The caller's text in place: UTF-8 (char, char8_t) or UTF-16 (char16_t). The view copies nothing and owns nothing.
///
/// Offsets and clusters count units: bytes of UTF-8, 16-bit units of UTF-16. Invalid units read as U+FFFD (utf.hpp).
class text_view {
public:
    constexpr text_view() noexcept = default;

    template <class Text>
        requires std::is_convertible_v<const Text&, std::string_view>
    constexpr text_view(const Text& text) noexcept : text_view{std::string_view{given(text)}}
    {
    }
    template <class Text>
        requires std::is_convertible_v<const Text&, std::u8string_view>
    constexpr text_view(const Text& text) noexcept : text_view{std::u8string_view{given(text)}}
    {
    }
    template <class Text>
        requires std::is_convertible_v<const Text&, std::u16string_view>
    constexpr text_view(const Text& text) noexcept : text_view{std::u16string_view{given(text)}}
    {
    }
    constexpr text_view(std::string_view text) noexcept : units_{text.data()}, size_{text.size()} {}
    constexpr text_view(std::u8string_view text) noexcept : units_{text.data()}, size_{text.size()} {}
    constexpr text_view(std::u16string_view text) noexcept
        : units_{text.data()}, size_{text.size()}, encoding_{typemesh::encoding::utf16}
    {
    }

    /// The number of units, and their encoding.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr typemesh::encoding encoding() const noexcept { return encoding_; }

    /// The units. Call utf8() only for UTF-8, and utf16() only for UTF-16.
    [[nodiscard]] const char* utf8() const noexcept
    {
        TYPEMESH_ASSERT(encoding_ == typemesh::encoding::utf8, "a text in UTF-16 was read as UTF-8");
        return static_cast<const char*>(units_);
    }
    /// The units of a text in UTF-16.
    [[nodiscard]] const char16_t* utf16() const noexcept
    {
        TYPEMESH_ASSERT(encoding_ == typemesh::encoding::utf16, "a text in UTF-8 was read as UTF-16");
        return static_cast<const char16_t*>(units_);
    }

    /// The unit at i, as a number. Precondition: i < size().
    [[nodiscard]] std::uint32_t unit(std::size_t i) const noexcept
    {
        return encoding_ == typemesh::encoding::utf8 ? static_cast<unsigned char>(utf8()[i]) : utf16()[i];
    }

private:
    template <class Text>
    static constexpr const Text& given(const Text& text) noexcept
    {
        if constexpr (std::is_pointer_v<Text>) TYPEMESH_ASSERT(text != nullptr, "a text was given as a null pointer");
        return text;
    }

    const void* units_ = nullptr;
    std::size_t size_ = 0;
    typemesh::encoding encoding_ = typemesh::encoding::utf8;
};

/// A temporary text that owns its units, such as a std::string. Overloads refuse it if they would keep a view of it.
template <class Text>
concept dying_text = !std::is_reference_v<Text> && !std::is_trivially_copyable_v<std::remove_cv_t<Text>> &&
                     std::is_convertible_v<const Text&, text_view>;

/// Text in an encoding that text_view does not accept: UTF-32, or wchar_t, which differs between systems.
template <class Text>
concept foreign_text =
    !std::is_convertible_v<const Text&, text_view> && !std::is_convertible_v<const Text&, std::string_view> &&
    (std::is_convertible_v<const Text&, std::u32string_view> || std::is_convertible_v<const Text&, std::wstring_view>);

/// Makes the compiler refuse text in other encodings in one sentence. It is for overloads beside functions that take a
/// text.
template <class Text>
constexpr error refuse_text() noexcept
{
    static_assert(sizeof(Text) == 0,
                  "typemesh: text is UTF-8 (char, char8_t) or UTF-16 (char16_t), not UTF-32 or wchar_t. Windows' "
                  "wchar_t is UTF-16: `std::u16string_view{reinterpret_cast<const char16_t*>(text), length}`.");
    return error::bad_option;
}

}  // namespace typemesh::inline TYPEMESH_ABI
