#include "testbench/cosim/map_stimuli.h"

#include <algorithm>

#include "testbench/cosim/raw_words.h"

namespace repousse::cosim {

std::shared_ptr<const Table> texel_table(int width, int height,
                                         const std::function<uint64_t(int x, int y)>& texel) {
    const auto columns = static_cast<std::size_t>(width) + 1;
    const auto table = std::make_shared<Table>(Table{width, height, {}});
    table->entries.resize(columns * (static_cast<std::size_t>(height) + 1));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            table->entries[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] =
                texel(x, y);
        }
    }
    return table;
}

int32_t within_a_period(const Format& uv, int64_t u, int size) {
    const int64_t one = int64_t{1} << uv.frac;
    return limited(uv, std::clamp(u, -size * one + one, (2 * size - 1) * one - one));
}

int32_t map_coordinate(Random& random, const Format& uv, int size, bool wrap, bool centres) {
    const int64_t one = int64_t{1} << uv.frac;
    const int64_t whole = size * one;
    int64_t x = random.between(-whole / 2, whole + whole / 2);
    const uint32_t kind = random.below(100);
    if (kind < 25) x = (random.percent(50) ? 0 : whole) + random.between(-2 * one, 2 * one);
    if (kind >= 15 && kind < 40) x = (x & -one) + random.between(-1, 1);
    if (centres && kind >= 40 && kind < 60) x = (x & -one) + one / 2 + random.between(-1, 1);
    return wrap ? within_a_period(uv, x, size) : limited(uv, x);
}

}  // namespace repousse::cosim
