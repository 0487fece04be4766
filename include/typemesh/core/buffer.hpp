// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The part of a buffer that does not depend on the type of its elements. It counts in bytes.
class buffer_bytes {
public:
    buffer_bytes(const buffer_bytes&) = delete;
    buffer_bytes& operator=(const buffer_bytes&) = delete;

protected:
    explicit buffer_bytes(memory source) noexcept : source_{source} {}
    buffer_bytes(buffer_bytes&& other) noexcept
        : data_{taken(other.data_)},
          size_{taken(other.size_)},
          capacity_{taken(other.capacity_)},
          source_{other.source_}
    {
    }
    ~buffer_bytes() = default;

    void swap(buffer_bytes& other) noexcept
    {
        swap_values(data_, other.data_);
        swap_values(size_, other.size_);
        swap_values(capacity_, other.capacity_);
        swap_values(source_, other.source_);
    }

    [[nodiscard]] bool grow_by(std::size_t count, std::size_t each, std::size_t alignment) noexcept
    {
        if (count > ~std::size_t{0} / 2 - size_) return false;
        const std::size_t doubled = capacity_ < 16 ? 32 : capacity_ * 2;
        return grow(size_ + count > doubled ? size_ + count : doubled, each, alignment);
    }

    [[nodiscard]] bool grow(std::size_t wanted, std::size_t each, std::size_t alignment) noexcept
    {
        if (wanted > ~std::size_t{0} / each / 2) return false;
        void* fresh = source_.allocate(source_.user, wanted * each, alignment);
        if (fresh == nullptr) return false;
        if (size_ != 0) std::memcpy(fresh, data_, size_ * each);
        release(each, alignment);
        data_ = fresh;
        capacity_ = wanted;
        return true;
    }

    void release(std::size_t each, std::size_t alignment) noexcept
    {
        if (data_ != nullptr) source_.deallocate(source_.user, data_, capacity_ * each, alignment);
    }

    void* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
    memory source_;
};

}  // namespace detail

/// A growing array of trivially copyable values over `memory`. Its growth can fail without an exception.
///
/// Every function that grows the buffer returns false (or null) when out of memory, and then leaves the buffer
/// unchanged. clear() keeps the storage, so nothing is allocated after warm-up. Growth moves the elements and
/// invalidates spans and pointers to them.
template <class T>
class buffer : detail::buffer_bytes {
    static_assert(__is_trivially_copyable(T), "a typemesh::buffer holds values that can be copied as bytes");

public:
    explicit buffer(memory source = heap()) noexcept : buffer_bytes{source} {}

    /// The memory source that the buffer was made with.
    [[nodiscard]] memory source() const noexcept { return source_; }
    buffer(buffer&& other) noexcept : buffer_bytes{static_cast<buffer_bytes&&>(other)} {}
    buffer& operator=(buffer&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~buffer() { release(sizeof(T), alignof(T)); }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] T* data() noexcept { return static_cast<T*>(data_); }
    [[nodiscard]] const T* data() const noexcept { return static_cast<const T*>(data_); }
    [[nodiscard]] T* begin() noexcept { return data(); }
    [[nodiscard]] T* end() noexcept { return data() + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data(); }
    [[nodiscard]] const T* end() const noexcept { return data() + size_; }
    [[nodiscard]] T& operator[](std::size_t i) noexcept
    {
        TYPEMESH_ASSERT(i < size_, "a buffer was read past its end");
        return data()[i];
    }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept
    {
        TYPEMESH_ASSERT(i < size_, "a buffer was read past its end");
        return data()[i];
    }
    [[nodiscard]] T& back() noexcept { return (*this)[size_ - 1]; }
    [[nodiscard]] const T& back() const noexcept { return (*this)[size_ - 1]; }
    [[nodiscard]] array_view<T> view() noexcept { return {data(), size_}; }
    [[nodiscard]] array_view<const T> view() const noexcept { return {data(), size_}; }

    void clear() noexcept { size_ = 0; }

    /// Removes all elements from index `size` on.
    void truncate(std::size_t size) noexcept
    {
        TYPEMESH_ASSERT(size <= size_, "truncate() cannot grow a buffer");
        size_ = size;
    }

    /// Makes the capacity at least `wanted`. Growth up to that size then neither fails nor moves the elements.
    [[nodiscard]] bool reserve(std::size_t wanted) noexcept
    {
        return wanted <= capacity_ || grow(wanted, sizeof(T), alignof(T));
    }

    /// Appends `count` uninitialised elements and returns the first. Returns null when out of memory (or, for count =
    /// 0, if there is no storage yet).
    [[nodiscard]] T* append(std::size_t count) noexcept
    {
        if (count > capacity_ - size_ && !grow_by(count, sizeof(T), alignof(T))) return nullptr;
        T* first = data() + size_;
        size_ += count;
        return first;
    }

    /// Appends copies of `values`, which may lie in this buffer.
    [[nodiscard]] bool append(array_view<const T> values) noexcept
    {
        if (values.empty()) return true;
        const auto at = reinterpret_cast<std::uintptr_t>(values.data()) - reinterpret_cast<std::uintptr_t>(data_);
        const bool own = at < size_ * sizeof(T);  // growing would move them
        T* first = append(values.size());
        if (first == nullptr) return false;
        std::memcpy(static_cast<void*>(first), own ? data() + at / sizeof(T) : values.data(), values.size_bytes());
        return true;
    }

    [[nodiscard]] bool push_back(const T& value) noexcept
    {
        if (size_ == capacity_) {
            const T copy = value;  // `value` may lie in this buffer
            if (!grow_by(1, sizeof(T), alignof(T))) return false;
            data()[size_++] = copy;
            return true;
        }
        data()[size_++] = value;
        return true;
    }

    /// Appends without a check, for inner loops after reserve().
    void push_back_unchecked(const T& value) noexcept
    {
        TYPEMESH_ASSERT(size_ < capacity_, "push_back_unchecked() needs reserve() before it");
        data()[size_++] = value;
    }

    void swap(buffer& other) noexcept { buffer_bytes::swap(other); }
};

}  // namespace typemesh::inline TYPEMESH_ABI
