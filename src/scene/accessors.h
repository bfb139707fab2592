// Typed arrays of numbers in buffers (glTF 2.0, section 3.6.2): every offset is checked before anything is read.
#pragma once

#include "scene/buffers.h"

#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_accessors = 1'000'000;
// The most numbers that the accessors of one file may yield, so that a small file cannot ask for endless memory.
inline constexpr std::uint64_t max_accessor_numbers = std::uint64_t{1} << 26;

class Accessors {
  public:
    Accessors(const Value& document, Buffers buffers)
        : accessors_(document.find("accessors")), buffers_(std::move(buffers)) {}

    // Each of these throws Error naming the place of the fault. `index` refers to an accessor.
    std::vector<Vec3> vectors(const Value& index);          // VEC3 of floats, or of integers (KHR_mesh_quantization)
    std::vector<glm::vec2> coordinates(const Value& index); // VEC2 of floats, or of normalized integers
    std::vector<glm::vec4> quadruples(const Value& index);  // VEC4, of any numbers
    std::vector<Vec3> colors(const Value& index);           // VEC3, or VEC4 without its last component
    std::vector<glm::dmat4> matrices(const Value& index);   // MAT4 of floats
    std::vector<float> scalars(const Value& index);         // SCALAR of floats
    std::vector<std::uint32_t> indices(const Value& index); // SCALAR of unsigned bytes, shorts or ints
    std::size_t count(const Value& index) const;            // number of elements of the accessor
    // Takes `numbers` off the limit `max_accessor_numbers` of the file; throws Error at `place` when it is exceeded.
    void count_against_limit(std::uint64_t numbers, const Value& place);
    Buffers& buffers() { return buffers_; }

  private:
    struct Layout;
    Value find(const Value& index) const;
    Layout layout(const Value& accessor, const char* type, std::size_t components);
    std::vector<double> numbers(const Value& accessor, const Layout& layout);
    template <class Tuple> std::vector<Tuple> tuples(const Value& index, const char* type);
    std::vector<float> finite_numbers(const Value& accessor, const Layout& layout);
    void read_sparse(const Value& sparse, const Layout& layout, std::vector<double>& numbers);

    std::optional<Value> accessors_;
    Buffers buffers_;
    std::uint64_t remaining_numbers_ = max_accessor_numbers;
};

} // namespace cairn::scene
