// Lists of the members of structs, and a compile-time check that a list names all of them.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cairn {

namespace fields_detail {

struct Anything {
    template <class T> operator T() const noexcept; // never called
};
template <std::size_t> using AnythingAt = Anything;

// With braces around each, every member takes one initializer, whatever it is: a number, an array, a plain struct, a
// base. Without them, members with constructors take one as well, but arrays one per element.
template <class T, bool InBraces, std::size_t... I> constexpr bool takes(std::index_sequence<I...>) {
    if constexpr (InBraces) return requires {
            T{{AnythingAt<I>{}}...};
        };
    else
        return requires { T{AnythingAt<I>{}...}; };
}
template <class T, bool InBraces, std::size_t N = 0> constexpr std::size_t count() {
    if constexpr (takes<T, InBraces>(std::make_index_sequence<N + 1>{}))
        return count<T, InBraces, N + 1>();
    else
        return N;
}

template <class A, class B> constexpr bool same_member(A a, B b) {
    if constexpr (std::is_same_v<A, B>)
        return a == b;
    else
        return false;
}

} // namespace fields_detail

// The number of members and bases of an aggregate of plain data. A base counts as one, and so does an array.
template <class T> constexpr std::size_t field_count() {
    static_assert(std::is_aggregate_v<T>);
    return fields_detail::count<T, true>();
}
// The same for an aggregate with members that have constructors (strings, vectors), but without arrays.
template <class T> constexpr std::size_t class_field_count() {
    static_assert(std::is_aggregate_v<T>);
    return fields_detail::count<T, false>();
}

// Whether a list of pointers to members contains this one.
template <class... Members, class Member> constexpr bool has_field(const std::tuple<Members...>& list, Member member) {
    return std::apply([&](auto... m) { return (fields_detail::same_member(m, member) || ...); }, list);
}

// Whether a list of pointers to members of T names each of them exactly once. `bases`: the number of bases of T, whose
// members are listed elsewhere.
template <class T, class... Members> constexpr bool lists_fields(const std::tuple<Members...>& list, int bases = 0) {
    const auto times = [&](auto member) {
        return std::apply([&](auto... m) { return (0 + ... + int(fields_detail::same_member(m, member))); }, list);
    };
    const bool is_distinct = std::apply([&](auto... m) { return (true && ... && (times(m) == 1)); }, list);
    return is_distinct && sizeof...(Members) + std::size_t(bases) == field_count<T>();
}

} // namespace cairn
