// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A growing array of trivially copyable values over `memory`, whose growth can fail without an exception.
///
/// Everything that grows returns false (or null) when memory runs out, and then nothing has changed. clear() keeps the
/// storage: after warm-up nothing is allocated. Growth moves the elements and invalidates spans and pointers to them.
template <class T>
class buffer {
    static_assert(std::is_trivially_copyable_v<T>, "a typemesh::buffer holds values that can be copied as bytes");

public:
    explicit buffer(memory source = heap()) noexcept : source_{source} {}
    buffer(buffer&& other) noexcept
        : data_{std::exchange(other.data_, nullptr)},
          size_{std::exchange(other.size_, 0)},
          capacity_{std::exchange(other.capacity_, 0)},
          source_{other.source_}
    {
    }
    buffer& operator=(buffer&& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        std::swap(source_, other.source_);
        return *this;
    }
    ~buffer() { release(); }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] T* begin() noexcept { return data_; }
    [[nodiscard]] T* end() noexcept { return data_ + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data_; }
    [[nodiscard]] const T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] T& operator[](std::size_t i) noexcept
    {
        TYPEMESH_ASSERT(i < size_, "a buffer was read past its end");
        return data_[i];
    }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept
    {
        TYPEMESH_ASSERT(i < size_, "a buffer was read past its end");
        return data_[i];
    }
    [[nodiscard]] T& back() noexcept { return (*this)[size_ - 1]; }
    [[nodiscard]] const T& back() const noexcept { return (*this)[size_ - 1]; }
    [[nodiscard]] std::span<T> view() noexcept { return {data_, size_}; }
    [[nodiscard]] std::span<const T> view() const noexcept { return {data_, size_}; }

    void clear() noexcept { size_ = 0; }

    /// Removes all elements from index `size` on.
    void truncate(std::size_t size) noexcept
    {
        TYPEMESH_ASSERT(size <= size_, "truncate() cannot grow a buffer");
        size_ = size;
    }

    /// Makes the capacity at least `wanted`: growth up to that size then neither fails nor moves the elements.
    [[nodiscard]] bool reserve(std::size_t wanted) noexcept { return wanted <= capacity_ || grow(wanted); }

    /// Appends `count` uninitialised elements and returns the first; null when memory runs out (or, for count = 0, when
    /// there is no storage yet).
    [[nodiscard]] T* append(std::size_t count) noexcept
    {
        if (count > capacity_ - size_ && !grow_by(count)) return nullptr;
        T* first = data_ + size_;
        size_ += count;
        return first;
    }

    /// Appends copies of `values`, which may lie in this very buffer.
    [[nodiscard]] bool append(std::span<const T> values) noexcept
    {
        if (values.empty()) return true;
        const auto at = reinterpret_cast<std::uintptr_t>(values.data()) - reinterpret_cast<std::uintptr_t>(data_);
        const bool own = at < size_ * sizeof(T);  // growing would move them
        T* first = append(values.size());
        if (first == nullptr) return false;
        std::memcpy(static_cast<void*>(first), own ? data_ + at / sizeof(T) : values.data(), values.size_bytes());
        return true;
    }

    [[nodiscard]] bool push_back(const T& value) noexcept
    {
        if (size_ == capacity_) {
            const T copy = value;  // `value` may lie in this buffer
            if (!grow_by(1)) return false;
            data_[size_++] = copy;
            return true;
        }
        data_[size_++] = value;
        return true;
    }

    /// For inner loops after reserve().
    void push_back_unchecked(const T& value) noexcept
    {
        TYPEMESH_ASSERT(size_ < capacity_, "push_back_unchecked() needs reserve() before it");
        data_[size_++] = value;
    }

    void swap(buffer& other) noexcept { std::swap(*this, other); }

private:
    bool grow_by(std::size_t count) noexcept
    {
        if (count > (std::numeric_limits<std::size_t>::max)() / 2 - size_) return false;
        const std::size_t doubled = capacity_ < 16 ? 32 : capacity_ * 2;
        return grow(size_ + count > doubled ? size_ + count : doubled);
    }

    bool grow(std::size_t wanted) noexcept
    {
        if (wanted > (std::numeric_limits<std::size_t>::max)() / sizeof(T) / 2) return false;
        T* fresh = static_cast<T*>(source_.allocate(source_.user, wanted * sizeof(T), alignof(T)));
        if (fresh == nullptr) return false;
        if (size_ != 0) std::memcpy(static_cast<void*>(fresh), data_, size_ * sizeof(T));
        release();
        data_ = fresh;
        capacity_ = wanted;
        return true;
    }

    void release() noexcept
    {
        if (data_ != nullptr) source_.deallocate(source_.user, data_, capacity_ * sizeof(T), alignof(T));
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
    memory source_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
