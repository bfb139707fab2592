
#include "joints/direct_plan.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cairn {

namespace {

// An undirected graph of n vertices, as a bit matrix.
class Graph {
  public:
    explicit Graph(std::size_t n) : words_((n + 63) / 64), bits_(n * words_), degrees_(n) {}
    bool has(std::size_t i, std::size_t j) const { return bits_[i * words_ + j / 64] >> (j % 64) & 1; }
    void link(std::size_t i, std::size_t j) {
        if (i == j || has(i, j)) return;
        flip(i, j), flip(j, i);
        ++degrees_[i], ++degrees_[j];
    }
    std::size_t degree(std::size_t i) const { return degrees_[i]; }
    std::vector<std::uint32_t> neighbors(std::size_t i) const {
        std::vector<std::uint32_t> found;
        for (std::size_t w = 0; w < words_; ++w)
            for (std::uint64_t left = bits_[i * words_ + w]; left; left &= left - 1)
                found.push_back(std::uint32_t(w * 64 + std::size_t(__builtin_ctzll(left))));
        return found;
    }
    // Removes vertex i, and links all its neighbors with each other.
    void eliminate(std::size_t i, const std::vector<std::uint32_t>& neighbors) {
        for (const std::uint32_t j : neighbors) flip(i, j), flip(j, i), --degrees_[j];
        for (std::size_t a = 0; a < neighbors.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) link(neighbors[a], neighbors[b]);
    }

  private:
    void flip(std::size_t i, std::size_t j) { bits_[i * words_ + j / 64] ^= std::uint64_t(1) << (j % 64); }
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
    std::vector<std::size_t> degrees_;
};

using NodeEnd = std::array<std::uint32_t, 2>; // node, side

// Lists the ends of nodes at each body.
std::vector<std::vector<NodeEnd>> ends_by_body(const std::vector<DirectEnds>& nodes) {
    std::vector<std::vector<NodeEnd>> ends;
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::int32_t body = nodes[i].body[side];
            if (body < 0) continue;
            if (std::size_t(body) >= ends.size()) ends.resize(std::size_t(body) + 1);
            ends[body].push_back({i, side});
        }
    return ends;
}

std::uint32_t block_at(const DirectPlan& plan, std::uint32_t row, std::uint32_t column) {
    const auto begin = plan.rows.begin() + plan.first[column], end = plan.rows.begin() + plan.first[column + 1];
    return std::uint32_t(std::lower_bound(begin, end, row) - plan.rows.begin());
}

} // namespace

bool make_direct_plan(const std::vector<DirectEnds>& nodes, std::size_t max_blocks, std::size_t max_products,
                      DirectPlan& plan, std::vector<std::uint32_t>& order) {
    const std::size_t n = nodes.size();
    const std::vector<std::vector<NodeEnd>> ends = ends_by_body(nodes);
    Graph graph(n);
    for (const std::vector<NodeEnd>& body : ends)
        for (std::size_t a = 0; a < body.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) graph.link(body[a][0], body[b][0]);

    plan = {};
    order.clear();
    std::vector<std::vector<std::uint32_t>> columns;
    std::vector<std::uint32_t> place(n, std::uint32_t(n));
    std::size_t blocks = 0, products = 0;
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i)
            if (place[i] == n && (best == n || graph.degree(i) < graph.degree(best))) best = i;
        place[best] = std::uint32_t(k);
        order.push_back(std::uint32_t(best));
        columns.push_back(graph.neighbors(best));
        const std::size_t size = columns.back().size();
        blocks += size, products += size * (size - std::size_t(size > 0)) / 2;
        if (blocks > max_blocks || products > max_products) return false;
        graph.eliminate(best, columns.back());
    }

    plan.first.push_back(0);
    for (std::vector<std::uint32_t>& column : columns) {
        for (std::uint32_t& row : column) row = place[row];
        std::sort(column.begin(), column.end());
        plan.rows.insert(plan.rows.end(), column.begin(), column.end());
        plan.first.push_back(std::uint32_t(plan.rows.size()));
    }
    plan.products.reserve(products);
    for (const std::vector<std::uint32_t>& column : columns)
        for (std::size_t a = column.size(); a-- > 0;)
            for (std::size_t b = 0; b < a; ++b) plan.products.push_back(block_at(plan, column[a], column[b]));
    for (const std::vector<NodeEnd>& body : ends)
        for (std::size_t a = 0; a < body.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                NodeEnd row = body[a], column = body[b];
                row[0] = place[row[0]], column[0] = place[column[0]];
                if (row[0] < column[0]) std::swap(row, column);
                plan.couplings.push_back({block_at(plan, row[0], column[0]), row[0], column[0], std::uint8_t(row[1]),
                                          std::uint8_t(column[1])});
            }
    return true;
}

} // namespace cairn
