#include "testbench/host/map/summed_area_table.h"

namespace repousse::host {

std::vector<std::uint64_t> summed_area_table(const HeightMap& map, int stored_bits) {
    const auto width = static_cast<std::size_t>(map.width);
    const auto height = static_cast<std::size_t>(map.height);
    const std::size_t stride = width + 1;
    // The sums themselves never leave 64 bits, so masking each entry once is exact.
    const std::uint64_t mask =
        stored_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << stored_bits) - 1;
    std::vector<std::uint64_t> table(stride * (height + 1), 0);
    for (std::size_t y = 0; y < height; ++y) {
        std::uint64_t row = 0;
        for (std::size_t x = 0; x < width; ++x) {
            row += map.texels[y * width + x];
            table[(y + 1) * stride + x + 1] = (table[y * stride + x + 1] + row) & mask;
        }
    }
    return table;
}

int summed_area_bits(int width, int height) {
    const std::uint64_t texels =
        static_cast<std::uint64_t>((width + 1) / 2) * static_cast<std::uint64_t>((height + 1) / 2);
    int bits = 0;
    while ((std::uint64_t{1} << bits) < texels) ++bits;
    return 16 + bits;
}

}  // namespace repousse::host
