#include "datapath/map_view.h"

#include "datapath/numbers/vector_clones.h"

namespace repousse {

REPOUSSE_VECTOR_CLONES
void texel_addresses(const int32_t* u, std::size_t n, int32_t offset, int frac, int size, bool wrap,
                     int32_t* to) {
    const auto address = [&](std::size_t i, bool periodic) {
        return texel_address((u[i] - offset) >> frac, size, periodic);
    };
    if (wrap) {
        REPOUSSE_INDEPENDENT
        for (std::size_t i = 0; i < n; ++i) to[i] = address(i, true);
    } else {
        REPOUSSE_INDEPENDENT
        for (std::size_t i = 0; i < n; ++i) to[i] = address(i, false);
    }
}

}  // namespace repousse
