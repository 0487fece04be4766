// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// Scratch memory that works as a stack: stages take memory and give it back. The memory is kept for the next call.
///
///     workspace::scope scratch{space};                // its destructor gives back everything taken through it
///     auto* rank = scratch.take<std::uint32_t>(n);    // n values, not initialised; null when out of memory
///
/// Blocks never move: pointers stay valid until their scope ends. If several blocks were needed, one block replaces
/// them when the outermost scope ends. This block is as large as all memory that was ever taken at one time, so nothing
/// is allocated after warm-up. It is kept until trim(). A workspace serves one thread at a time.
class workspace {
    static constexpr std::size_t alignment = 64;     // a cache line, and enough for any vector register
    static constexpr std::size_t least = 16 * 1024;  // bytes per block; a larger take makes a larger block

    struct alignas(alignment) block {
        block* next;
        std::size_t bytes;  // after the header
        std::size_t used;
        [[nodiscard]] std::byte* data() noexcept { return reinterpret_cast<std::byte*>(this + 1); }
    };

public:
    explicit workspace(memory source = heap()) noexcept : source_{source} {}
    workspace(workspace&& other) noexcept
        : source_{other.source_},
          first_{taken(other.first_)},
          current_{taken(other.current_)},
          most_{taken(other.most_)},
          joined_{taken(other.joined_)}
    {
        TYPEMESH_ASSERT(other.depth_ == 0, "a workspace was moved while a scope was open");
    }
    workspace& operator=(workspace&& other) noexcept
    {
        TYPEMESH_ASSERT(depth_ == 0 && other.depth_ == 0, "a workspace was moved while a scope was open");
        swap_values(source_, other.source_);
        swap_values(first_, other.first_);
        swap_values(current_, other.current_);
        swap_values(most_, other.most_);
        swap_values(joined_, other.joined_);
        return *this;
    }
    ~workspace() { release(first_); }

    /// The source of its memory, for buffers that should share the source.
    [[nodiscard]] memory source() const noexcept { return source_; }

    /// The bytes that it holds now, used or not.
    [[nodiscard]] std::size_t capacity() const noexcept
    {
        std::size_t total = 0;
        for (const block* b = first_; b != nullptr; b = b->next) total += b->bytes;
        return total;
    }

    /// Gives all memory back to its source, for example after a text of unusual glyphs. The next call allocates again.
    void trim() noexcept
    {
        TYPEMESH_ASSERT(depth_ == 0, "a workspace was trimmed while a scope was open");
        release(first_);
        current_ = nullptr;
        most_ = 0;
        joined_ = false;
    }

    /// When a scope ends, it gives back everything taken through it. Scopes nest.
    class scope {
    public:
        explicit scope(workspace& w) noexcept
            : workspace_{w}, block_{w.current_}, used_{w.current_ != nullptr ? w.current_->used : 0}, taken_{w.taken_}
        {
            ++w.depth_;
        }
        scope(const scope&) = delete;
        scope& operator=(const scope&) = delete;
        ~scope()
        {
            workspace_.rewind(block_, used_, taken_);
            workspace_.leave();
        }

        /// Takes `count` uninitialised values; null when out of memory. The result for count = 0 is not null.
        template <class T>
        [[nodiscard]] T* take(std::size_t count) noexcept
        {
            static_assert(std::is_trivially_copyable_v<T>, "scratch memory holds plain values");
            static_assert(alignof(T) <= alignment);
            if (count > (~std::size_t{0} >> 2) / sizeof(T)) return nullptr;
            return static_cast<T*>(workspace_.take_bytes(count * sizeof(T)));
        }

        /// Memory for buffers that live no longer than the scope. Memory that these buffers release is given back when
        /// the scope ends. The buffers must not grow while an inner scope is open.
        [[nodiscard]] memory source() noexcept
        {
            return {&workspace_,
                    [](void* user, std::size_t bytes, std::size_t) noexcept -> void* {
                        return static_cast<workspace*>(user)->take_bytes(bytes);
                    },
                    [](void*, void*, std::size_t, std::size_t) noexcept {}};
        }

        /// Ensures that the next `bytes` bytes fit into the rest of this block and one more block. Otherwise many
        /// blocks could have unused space at their end. Returns false when out of memory. No inner scope may be open.
        [[nodiscard]] bool reserve(std::size_t bytes) noexcept
        {
            scope whole{workspace_};
            return whole.take<std::byte>(bytes) != nullptr;
        }

        /// Gives back everything taken through this scope except these values, which move down to its beginning, one
        /// array after the other. List them in the order in which they were taken. No inner scope may be open. It
        /// allocates nothing. Empty blocks go back to their source, so that later takes do not add to them.
        template <class... T>
        void keep(array_view<T>&... kept) noexcept
        {
            workspace_.rewind(block_, used_, taken_);
            (move_down(kept), ...);
            workspace_.release_empty();
        }

    private:
        template <class T>
        void move_down(array_view<T>& values) noexcept
        {
            static_assert(std::is_trivially_copyable_v<T>);
            void* const place = workspace_.take_there(values.size_bytes());
            if (!values.empty()) std::memmove(place, static_cast<const void*>(values.data()), values.size_bytes());
            values = {static_cast<T*>(place), values.size()};
        }

        workspace& workspace_;
        block* block_;
        std::size_t used_;
        std::size_t taken_;
    };

private:
    static constexpr std::size_t rounded(std::size_t bytes) noexcept
    {
        return (bytes + alignment - 1) & ~(alignment - 1);
    }

    void* take_bytes(std::size_t wanted) noexcept
    {
        wanted = rounded(wanted);
        if (current_ != nullptr && wanted <= current_->bytes - current_->used) return take_here(wanted);
        return take_from_next(wanted);
    }

    /// Takes from the next block that is large enough, or from a new one.
    void* take_from_next(std::size_t wanted) noexcept
    {
        do {
            block*& next = current_ == nullptr ? first_ : current_->next;
            while (next != nullptr && next->bytes < wanted) {  // empty: left over from a scope that has ended
                block* too_small = next;
                next = too_small->next;
                too_small->next = nullptr;
                release(too_small);
            }
            if (next == nullptr) {
                next = make_block(wanted > least ? wanted : least);
                if (next == nullptr) return nullptr;
            }
            current_ = next;
        } while (wanted > current_->bytes - current_->used);
        return take_here(wanted);
    }

    /// Takes from the first existing block with enough space.
    void* take_there(std::size_t wanted) noexcept
    {
        wanted = rounded(wanted);
        if (current_ == nullptr) current_ = first_;
        if (current_ == nullptr) return nullptr;  // nothing was ever taken
        while (wanted > current_->bytes - current_->used) current_ = current_->next;
        return take_here(wanted);
    }

    void* take_here(std::size_t wanted) noexcept
    {
        void* const taken = current_->data() + current_->used;
        current_->used += wanted;
        taken_ += wanted;
        return taken;
    }

    block* make_block(std::size_t bytes) noexcept
    {
        void* raw = source_.allocate(source_.user, sizeof(block) + bytes, alignof(block));
        return raw == nullptr ? nullptr : new (raw) block{nullptr, bytes, 0};
    }

    void rewind(block* to, std::size_t used, std::size_t taken) noexcept
    {
        for (block* b = to == nullptr ? first_ : to->next; b != nullptr; b = b->next) b->used = 0;
        if (to != nullptr) to->used = used;
        current_ = to;
        if (taken_ > most_) most_ = taken_;
        taken_ = taken;
    }

    /// Releases all empty blocks, except the one block that holds everything after warm-up.
    void release_empty() noexcept
    {
        const bool is_warm = current_ == nullptr && first_ != nullptr && joined_;
        release(is_warm ? first_->next : current_ == nullptr ? first_ : current_->next);
    }

    void leave() noexcept
    {
        if (--depth_ != 0 || most_ == 0) return;
        if (first_ != nullptr && first_->next == nullptr && first_->bytes >= most_) return;
        release(first_);
        current_ = nullptr;
        const std::size_t joint = most_ + most_ / 16;
        first_ = make_block(joint > least ? rounded(joint) : least);  // null is fine: the next take tries again
        joined_ = first_ != nullptr;
    }

    void release(block*& from) noexcept
    {
        while (from != nullptr) {
            block* next = from->next;
            source_.deallocate(source_.user, from, sizeof(block) + from->bytes, alignof(block));
            from = next;
        }
    }

    memory source_;
    block* first_ = nullptr;
    block* current_ = nullptr;
    std::size_t depth_ = 0;
    std::size_t taken_ = 0;  // now
    std::size_t most_ = 0;   // maximum at a time
    bool joined_ = false;    // leave() has made the first block
};

}  // namespace typemesh::inline TYPEMESH_ABI
