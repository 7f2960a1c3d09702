#include "testbench/cosim/table_pool.h"

#include <array>

namespace repousse::cosim {
namespace {

uint64_t mask(int bits) { return ~uint64_t{0} >> (64 - bits); }

std::shared_ptr<Table> empty_table(int width, int height) {
    const auto entries = static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1);
    return std::make_shared<Table>(Table{width, height, std::vector<uint64_t>(entries)});
}

}  // namespace

std::shared_ptr<const Table> prefix_sums(int width, int height, int stored_bits,
                                         const std::function<uint64_t(int x, int y)>& texel) {
    const std::shared_ptr<Table> table = empty_table(width, height);
    const auto columns = static_cast<std::size_t>(width) + 1;
    for (int y = 0; y < height; ++y) {
        const uint64_t* above = &table->entries[static_cast<std::size_t>(y) * columns];
        uint64_t* here = &table->entries[static_cast<std::size_t>(y + 1) * columns];
        uint64_t row = 0;
        for (int x = 0; x < width; ++x) {
            row += texel(x, y);
            here[x + 1] = (above[x + 1] + row) & mask(stored_bits);
        }
    }
    return table;
}

std::shared_ptr<const Table> offset_table(const Table& table, uint64_t offset, int stored_bits) {
    const auto moved = std::make_shared<Table>(table);
    for (uint64_t& entry : moved->entries) entry = (entry + offset) & mask(stored_bits);
    return moved;
}

std::shared_ptr<const Table> random_words(int width, int height, int stored_bits, Random& random) {
    const std::shared_ptr<Table> table = empty_table(width, height);
    for (uint64_t& entry : table->entries) entry = random.next() & mask(stored_bits);
    return table;
}

std::vector<std::shared_ptr<const Table>> table_pool(int max_size, int height_bits,
                                                     int stored_bits) {
    struct Shape {
        int width, height;
    };
    // Powers of two and not, square and not, one texel, and 4096 texels at least in one direction.
    constexpr std::array kShapes = {Shape{1, 1},     Shape{2, 3},     Shape{8, 8},
                                    Shape{7, 5},     Shape{64, 64},   Shape{257, 257},
                                    Shape{403, 344}, Shape{4096, 16}, Shape{16, 4096}};
    Random random(1);
    const uint64_t most = mask(height_bits);
    std::vector<std::shared_ptr<const Table>> pool;
    for (const Shape& shape : kShapes) {
        if (shape.width > max_size || shape.height > max_size) continue;
        const auto add = [&](const std::function<uint64_t(int, int)>& texel) {
            pool.push_back(prefix_sums(shape.width, shape.height, stored_bits, texel));
        };
        add([&](int, int) { return random.next() & most; });
        add([&](int, int) { return most; });
        add([&](int x, int y) { return static_cast<uint64_t>(100 * x + 100 * y) & most; });
        pool.push_back(random_words(shape.width, shape.height, stored_bits, random));
    }
    return pool;
}

}  // namespace repousse::cosim
