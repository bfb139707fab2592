#include "scene/accessors.h"

#include "scene/document.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cairn::scene {

namespace {

// glTF 2.0, table "accessor.componentType".
enum ComponentType : std::uint64_t {
    signed_byte = 5120,
    unsigned_byte = 5121,
    signed_short = 5122,
    unsigned_short = 5123,
    unsigned_int = 5125,
    float_number = 5126,
};

constexpr std::size_t max_elements = std::size_t{1} << 26;

std::size_t size_of(std::uint64_t type) {
    if (type == signed_byte || type == unsigned_byte) return 1;
    return type == signed_short || type == unsigned_short ? 2 : 4;
}

std::uint64_t read_component_type(const Value& value) {
    const std::uint64_t type = value.whole(0, 0xFFFFFFFFu);
    if (type < signed_byte || type > float_number || type == 5124) {
        value.fail("must be 5120, 5121, 5122, 5123, 5125 or 5126");
    }
    return type;
}

// Reads one number, stored in little-endian order. Normalized integers stand for -1 to 1 (glTF 2.0, section 3.11).
double component(const std::byte* at, std::uint64_t type, bool normalized) {
    std::uint32_t bits = 0;
    const std::size_t size = size_of(type);
    for (std::size_t i = 0; i < size; ++i) bits |= std::to_integer<std::uint32_t>(at[i]) << (8 * i);
    const auto scaled = [&](double value, double greatest) {
        return normalized ? std::max(value / greatest, -1.0) : value;
    };
    switch (type) {
    case signed_byte:
        return scaled(static_cast<std::int8_t>(bits), 127.0);
    case unsigned_byte:
        return scaled(bits, 255.0);
    case signed_short:
        return scaled(static_cast<std::int16_t>(bits), 32767.0);
    case unsigned_short:
        return scaled(bits, 65535.0);
    case unsigned_int:
        return bits;
    default:
        break;
    }
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
}

// Returns the stride in bytes of elements that begin at `offset` in the view. Throws if they do not fit into the view.
std::size_t checked_stride(const Value& owner, const Buffers::View& view, std::size_t offset, std::size_t count,
                           std::size_t element_size) {
    const std::size_t stride = view.stride != 0 ? view.stride : element_size;
    if (stride < element_size) {
        owner.fail("must not have elements of " + std::to_string(element_size) + " bytes in a view with a stride of " +
                   std::to_string(stride));
    }
    // The sum cannot overflow: the count is at most 2^26, the stride 252, the offset 2^29.
    const std::uint64_t end = std::uint64_t{offset} + std::uint64_t{stride} * (count - 1) + element_size;
    if (end > view.bytes.size()) {
        owner.fail("must end in its buffer view of " + std::to_string(view.bytes.size()) + " bytes, and reaches to " +
                   std::to_string(end));
    }
    return stride;
}

std::size_t byte_offset(const Value& owner) {
    const auto offset = owner.find("byteOffset");
    return offset ? static_cast<std::size_t>(offset->whole(0, max_buffer_bytes)) : 0;
}

} // namespace

struct Accessors::Layout {
    std::size_t count = 0, components = 1;
    std::uint64_t type = 0;
    bool normalized = false;
    std::size_t element_size() const { return components * size_of(type); }
};

Value Accessors::find(const Value& index) const { return element(accessors_, index, max_accessors, "accessors"); }

std::size_t Accessors::count(const Value& index) const {
    return static_cast<std::size_t>(find(index).require("count").whole(1, max_elements));
}

Accessors::Layout Accessors::layout(const Value& accessor, const char* type, std::size_t components) {
    Layout layout;
    layout.components = components;
    const Value given_type = accessor.require("type");
    if (given_type.text() != type) given_type.fail(std::string("must be \"") + type + "\" here");
    layout.type = read_component_type(accessor.require("componentType"));
    if (const auto normalized = accessor.find("normalized")) layout.normalized = normalized->boolean();
    const Value count = accessor.require("count");
    layout.count = static_cast<std::size_t>(count.whole(1, max_elements));
    count_against_limit(std::uint64_t{layout.count} * components, count);
    return layout;
}

void Accessors::count_against_limit(std::uint64_t numbers, const Value& place) {
    if (numbers > remaining_numbers_) {
        place.fail("must not raise the total of numbers in the file above " + std::to_string(max_accessor_numbers));
    }
    remaining_numbers_ -= numbers;
}

std::vector<double> Accessors::numbers(const Value& accessor, const Layout& layout) {
    std::vector<double> result;
    if (const auto index = accessor.find("bufferView")) {
        const Buffers::View view = buffers_.view(*index);
        const std::size_t offset = byte_offset(accessor), size = size_of(layout.type);
        const std::size_t stride = checked_stride(accessor, view, offset, layout.count, layout.element_size());
        result.reserve(layout.count * layout.components);
        for (std::size_t i = 0; i < layout.count; ++i) {
            const std::byte* at = view.bytes.data() + offset + stride * i;
            for (std::size_t k = 0; k < layout.components; ++k) {
                result.push_back(component(at + k * size, layout.type, layout.normalized));
            }
        }
    } else {
        result.assign(layout.count * layout.components, 0.0); // glTF: without a buffer view, all elements are zero
    }
    if (const auto sparse = accessor.find("sparse")) read_sparse(*sparse, layout, result);
    return result;
}

// Sparse elements replace those of the view, each with its index (glTF 2.0, section 3.6.2.3).
void Accessors::read_sparse(const Value& sparse, const Layout& layout, std::vector<double>& numbers) {
    const std::size_t count = static_cast<std::size_t>(sparse.require("count").whole(1, layout.count));
    const Value indices = sparse.require("indices"), values = sparse.require("values");
    const std::uint64_t index_type = read_component_type(indices.require("componentType"));
    if (index_type != unsigned_byte && index_type != unsigned_short && index_type != unsigned_int) {
        indices.require("componentType").fail("must be 5121, 5123 or 5125 here");
    }
    const Buffers::View index_view = buffers_.view(indices.require("bufferView"));
    const Buffers::View value_view = buffers_.view(values.require("bufferView"));
    const std::size_t index_offset = byte_offset(indices), value_offset = byte_offset(values);
    const std::size_t index_stride = checked_stride(indices, index_view, index_offset, count, size_of(index_type));
    const std::size_t value_stride = checked_stride(values, value_view, value_offset, count, layout.element_size());
    std::size_t least = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(
            component(index_view.bytes.data() + index_offset + index_stride * i, index_type, false));
        if (index < least || index >= layout.count) {
            indices.fail("must increase, and stay below the accessor's count of " + std::to_string(layout.count));
        }
        least = index + 1;
        const std::byte* at = value_view.bytes.data() + value_offset + value_stride * i;
        for (std::size_t k = 0; k < layout.components; ++k) {
            numbers[index * layout.components + k] =
                component(at + k * size_of(layout.type), layout.type, layout.normalized);
        }
    }
}

std::vector<float> Accessors::finite_numbers(const Value& accessor, const Layout& layout) {
    const std::vector<double> values = numbers(accessor, layout);
    std::vector<float> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            accessor.fail("must hold finite numbers, and element " + std::to_string(i / layout.components) +
                          " does not");
        }
        result[i] = static_cast<float>(values[i]);
    }
    return result;
}

template <class Tuple> std::vector<Tuple> Accessors::tuples(const Value& index, const char* type) {
    constexpr int components = Tuple::length();
    const Value accessor = find(index);
    const Layout form = layout(accessor, type, std::size_t(components));
    const std::vector<float> values = finite_numbers(accessor, form);
    std::vector<Tuple> result(form.count);
    for (std::size_t i = 0; i < values.size(); ++i)
        result[i / std::size_t(components)][int(i % std::size_t(components))] = values[i];
    return result;
}

std::vector<Vec3> Accessors::vectors(const Value& index) { return tuples<Vec3>(index, "VEC3"); }
std::vector<glm::vec2> Accessors::coordinates(const Value& index) { return tuples<glm::vec2>(index, "VEC2"); }
std::vector<glm::vec4> Accessors::quadruples(const Value& index) { return tuples<glm::vec4>(index, "VEC4"); }

std::vector<Vec3> Accessors::colors(const Value& index) {
    const Value accessor = find(index);
    const Value type = accessor.require("componentType");
    const auto normalized = accessor.find("normalized");
    const std::uint64_t code = read_component_type(type);
    const bool is_unsigned = code == unsigned_byte || code == unsigned_short;
    if (code != float_number && !(is_unsigned && normalized && normalized->boolean()))
        type.fail("must be 5126, or of normalized numbers 5121 or 5123, for colors");
    std::vector<Vec3> result;
    if (accessor.require("type").text() == "VEC4")
        for (const glm::vec4& color : quadruples(index)) result.emplace_back(color);
    else
        result = vectors(index);
    for (Vec3& color : result) color = glm::clamp(color, 0.0f, 1.0f);
    return result;
}

std::vector<glm::dmat4> Accessors::matrices(const Value& index) {
    constexpr int size = 4;
    const Value accessor = find(index);
    const Layout form = layout(accessor, "MAT4", size * size);
    if (form.type != float_number) accessor.require("componentType").fail("must be 5126 here");
    const std::vector<float> values = finite_numbers(accessor, form);
    std::vector<glm::dmat4> result(form.count);
    for (std::size_t i = 0; i < values.size(); ++i)
        result[i / 16][int(i % 16) / size][int(i % size)] = double(values[i]); // column-major
    return result;
}

std::vector<float> Accessors::scalars(const Value& index) {
    const Value accessor = find(index);
    const Layout form = layout(accessor, "SCALAR", 1);
    if (form.type != float_number) accessor.require("componentType").fail("must be 5126 here");
    return finite_numbers(accessor, form);
}

std::vector<std::uint32_t> Accessors::indices(const Value& index) {
    const Value accessor = find(index);
    const Layout form = layout(accessor, "SCALAR", 1);
    if (form.type != unsigned_byte && form.type != unsigned_short && form.type != unsigned_int) {
        accessor.require("componentType").fail("must be 5121, 5123 or 5125 here");
    }
    if (form.normalized) accessor.require("normalized").fail("must be false for indices");
    const std::vector<double> values = numbers(accessor, form);
    std::vector<std::uint32_t> result(form.count);
    for (std::size_t i = 0; i < form.count; ++i) result[i] = static_cast<std::uint32_t>(values[i]);
    return result;
}

} // namespace cairn::scene
