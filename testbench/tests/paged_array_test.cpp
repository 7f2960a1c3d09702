// The sequence that results are kept in: nothing is lost, moved or mixed up at the border of a
// page.

#include "datapath/paged_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace repousse {
namespace {

using Array = PagedArray<uint32_t>;

std::vector<uint32_t> numbers(std::size_t count) {
    std::vector<uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

Array appended(const std::vector<uint32_t>& all, std::size_t most, std::mt19937& random) {
    Array array;
    for (std::size_t done = 0; done < all.size();) {
        const std::size_t n = std::min(all.size() - done, std::size_t(random()) % (most + 1));
        array.append({all.data() + done, n});
        done += n;
    }
    return array;
}

TEST(PagedArray, HoldsWhatWasAppended) {
    std::mt19937 random(3);
    constexpr std::size_t kPage = Array::kPageSize;
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, kPage - 1, kPage, kPage + 1, 5 * kPage + 77}) {
        const auto all = numbers(count);
        for (const std::size_t most : {std::size_t{100}, 3 * kPage}) {
            const Array array = appended(all, most, random);
            ASSERT_EQ(array.size(), count);
            ASSERT_EQ(array.empty(), count == 0);
            std::size_t i = 0;
            for (const uint32_t number : array) ASSERT_EQ(number, i++);
            ASSERT_EQ(i, count);
            for (std::size_t k = 0; k < count; k += 997) ASSERT_EQ(array[k], k);
            if (count != 0) {
                ASSERT_EQ(array.back(), count - 1);
            }
        }
    }
}

TEST(PagedArray, StaysWhereItIs) {
    Array array;
    const auto all = numbers(100);
    array.append(all);
    const uint32_t* const first = &array[0];
    for (std::size_t i = 0; i < Array::kPageSize; ++i) array.append(all);
    EXPECT_EQ(first, &array[0]);
}

TEST(PagedArray, IsEqualByItemsAlone) {
    std::mt19937 random(4);
    const auto all = numbers(3 * Array::kPageSize + 5);
    const Array array = appended(all, 1000, random);
    EXPECT_TRUE(array == appended(all, 7, random));
    auto shorter = all, other = all;
    shorter.pop_back();
    ++other[Array::kPageSize];
    EXPECT_FALSE(array == appended(shorter, 1000, random));
    EXPECT_FALSE(array == appended(other, 1000, random));
}

}  // namespace
}  // namespace repousse
