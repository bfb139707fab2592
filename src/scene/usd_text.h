// Parses USD text layers (.usda), with limits: prims, their schemas and the values of their properties. References to
// other layers, and variants, are not followed.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

// A value flattened to numbers (true and false as 1 and 0) and words (strings, paths, assets), in the order of the
// file; its brackets are dropped.
struct UsdValue {
    std::vector<double> numbers;
    std::vector<std::string> words;
    int line = 0;
};

struct UsdPrim {
    std::string kind, type, name, path; // def, over or class; Xform; as in </World/Box>
    int line = 0;
    bool is_active = true;
    std::vector<std::string> schemas; // the applied schemas
    std::map<std::string, UsdValue> properties;
    std::vector<UsdPrim> children;
};

struct UsdLayer {
    std::map<std::string, UsdValue> metadata;
    std::vector<UsdPrim> prims;
    // Unsupported features and how often each occurs: references, variantSet, timeSamples.
    std::map<std::string, int> left_out;
};

// The kind of USD file, if any.
enum class UsdKind { none, text, binary, package };
UsdKind usd_kind(std::span<const std::byte> bytes);

// `name` stands for the file in messages. Throws Error (invalid_file) naming the line.
UsdLayer parse_usd(std::span<const std::byte> bytes, const std::string& name);

} // namespace cairn::scene
