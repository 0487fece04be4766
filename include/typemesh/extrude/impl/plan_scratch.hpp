// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/place_of_type.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <new>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan data of one glyph after another, for any extruder, or the scratch of a region_step. Its storage is kept for
/// the next glyph; if this is planned with data of another type, the old data is destroyed.
class plan_scratch {
public:
    explicit plan_scratch(memory source = heap()) noexcept : source_{source} {}
    plan_scratch(plan_scratch&& other) noexcept
        : source_{other.source_}, type_{taken(other.type_)}, data_{taken(other.data_)}, how_{other.how_}
    {
    }
    plan_scratch& operator=(plan_scratch&& other) noexcept
    {
        swap_values(source_, other.source_);
        swap_values(type_, other.type_);
        swap_values(data_, other.data_);
        swap_values(how_, other.how_);
        return *this;
    }
    ~plan_scratch() { release(); }

    /// Data of this type, empty; null if out of memory.
    template <class Data>
    [[nodiscard]] Data* fresh() noexcept
    {
        if (type_ != &detail::place_of_type<Data>) {
            release();
            void* place = source_.allocate(source_.user, sizeof(Data), alignof(Data));
            if (place == nullptr) return nullptr;
            data_ = new (place) Data{source_};
            type_ = &detail::place_of_type<Data>;
            how_ = &operations_on<Data>;
        }
        Data* data = static_cast<Data*>(data_);
        data->clear();
        return data;
    }

    /// For the storage of a glyph: the number of bytes of its data, and the data itself, for Data::read_from().
    [[nodiscard]] std::size_t bytes() const noexcept { return data_ == nullptr ? 0 : how_->bytes(data_); }
    void copy_to(std::byte* block) const noexcept
    {
        if (data_ != nullptr) how_->copy(data_, block);
    }

    /// Returns all memory to its source.
    void release() noexcept
    {
        if (data_ != nullptr) how_->end(data_, source_);
        type_ = nullptr;
        data_ = nullptr;
    }

private:
    struct operations {
        void (*end)(void* data, const memory& source) noexcept;
        std::size_t (*bytes)(const void* data) noexcept;
        void (*copy)(const void* data, std::byte* block) noexcept;
    };
    template <class Data>
    static constexpr operations operations_on = {[](void* data, const memory& source) noexcept {
                                                     static_cast<Data*>(data)->~Data();
                                                     source.deallocate(source.user, data, sizeof(Data), alignof(Data));
                                                 },
                                                 [](const void* data) noexcept -> std::size_t {
                                                     if constexpr (requires(const Data& d) { d.bytes(); })
                                                         return static_cast<const Data*>(data)->bytes();
                                                     else
                                                         return 0 * sizeof data;
                                                 },
                                                 [](const void* data, std::byte* block) noexcept {
                                                     if constexpr (requires(const Data& d) { d.copy_to(block); })
                                                         static_cast<const Data*>(data)->copy_to(block);
                                                     else
                                                         (void)data, (void)block;
                                                 }};

    memory source_;
    const void* type_ = nullptr;
    void* data_ = nullptr;
    const operations* how_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI
