// Read by functions.awk alone: each function is called after its lines and parameters, name_LINES_PARAMETERS.
#pragma once
#define NOT_A_FUNCTION(a, b) \
    f(a, b) {}

namespace sample {

int declared_0_2(int a, int b = f(1, 2));
inline int short_1_0() { return g(1, 2, 3); }

/* a comment with { and
   void not_a_function(int) { */
template <class A, class B = std::pair<int, int>, int N = (1 > 0 ? 1 : 2)>
    requires(sizeof(A) > 1) && requires(A a) { a.x(); }
[[nodiscard]] constexpr auto constrained_7_3(const std::map<A, B>& m, std::function<void(A, B)> f, int c = N) noexcept(noexcept(A{}))
    -> std::pair<A, B>
{
    if (f) return {m, "}{"};
}

template <class T>
concept not_a_function = requires(T t) {
    { t.f(1, 2) } noexcept;
};

inline constexpr table no_function_either{.a = {1, 2}, .b = f(3)};
inline constexpr auto nor_this = [](int a, int b) { return a + b; };

struct alignas(16) thing {
    explicit thing(int a, options o = {.x = 1, .y = 2}) : a_{a}, b_(o.x), c_{g(a, 1)}
    {
        start();
    }
    explicit(false) thing(int) {}
    ~thing() = default;
    bool operator==(const thing&) const = default;
    bool operator<(const thing& b) const { return a_ < b.a_; }
    void operator()(int a, int b, char c = '}') const noexcept
    {
        struct local {
            void not_seen(int) {}
        };
        for (;;) {
        }
    }
    static constexpr int n = f(1, 2);
    const thing* (*pointer)(void* object, int a);
    int a_ = g(1, 2);
    std::array<int, 3> b_{1, 2, 3};

public:
    template <class F>
    friend void befriended_3_1(F&& f)
    {}
};

}  // namespace sample
