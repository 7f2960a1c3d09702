#include "datapath/units/texel_cache.h"

#include <map>
#include <utility>

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using TablePointer = std::shared_ptr<const Table>;

constexpr uint32_t kLastAddress = (uint32_t{1} << kTexelAddressBits) - 1;

/// Every table has 64 x 64 words. They stand behind all addresses, folded: every bit of an address
/// makes a difference to what is read, so that a line with a wrong tag shows in the data as well.
constexpr int kSide = 64;
uint32_t folded(uint32_t address) {
    return (address ^ address >> 12 ^ address >> 24) & (kSide * kSide - 1);
}

/// What a cache remembers: for each set its ways, the next victim first, each as (number of its
/// line + 1) << 4 | way; without a line the number + 1 is 0.
using State = std::vector<std::vector<uint32_t>>;

class TexelCacheModel : public UnitModel {
public:
    explicit TexelCacheModel(const Profile& profile)
        : UnitModel(profile, kTexelCacheDesc), unit_(cache_shape(profile)) {}

    const UnitDesc& desc() const override { return kTexelCacheDesc; }
    bool reads_table() const override { return true; }
    uint64_t weight() const override { return 4; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    /// The lines stay from one scenario to the next, as in the RTL: every scenario begins with an
    /// invalidation, because its table may be another one.
    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        answer_each(scenario, outputs, [&](const Word* words) {
            const TexelCacheIn in = TexelCacheIn::unpack(words);
            const auto word = scenario.table->entries[folded(in.address)];
            return TexelCacheOut{static_cast<uint32_t>(word), unit_(in)}.pack();
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_texel_cache_model(profile);
    }

    /// Two sets of two lines of two words.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.cache_line_bits = 1, tiny.cache_set_bits = 1, tiny.cache_ways = 2;
        return tiny;
    }

private:
    TablePointer table(uint64_t seed) const {
        TablePointer& table = tables_[seed];
        if (table == nullptr) {
            Random random(seed);
            const auto made = std::make_shared<Table>(Table{kSide - 1, kSide - 1, {}});
            for (int i = 0; i < kSide * kSide; ++i) {
                made->entries.push_back(random.next() >> (64 - profile().height.width));
            }
            table = made;
        }
        return table;
    }
    uint32_t line_words() const { return uint32_t{1} << unit_.shape().line_bits; }
    /// From a line to the next one of the same set, in words.
    uint32_t set_stride() const { return line_words() << unit_.shape().set_bits; }
    State after(const State& state, uint32_t line) const;

    TexelCache unit_;
    mutable std::map<uint64_t, TablePointer> tables_;  // built when first needed
};

std::vector<Scenario> TexelCacheModel::hard_cases() const {
    std::vector<Scenario> cases;
    bool first = true;
    const auto begin = [&](const char* name, uint64_t seed = 1) {
        cases.push_back({name, {}, table(seed), {}});
        first = true;
    };
    const auto read = [&](uint32_t address, bool invalidate = false) {
        cases.back().add(TexelCacheIn{invalidate || first, address & kLastAddress});
        first = false;
    };
    const auto ways = static_cast<uint32_t>(unit_.shape().ways);
    const uint32_t stride = set_stride();
    const uint32_t line = line_words();

    begin("same_line_twice");
    for (uint32_t i = 0; i < line; ++i) read(5 * line + i);
    for (uint32_t i = line; i-- > 0;) read(5 * line + i);
    for (int i = 0; i < 4; ++i) read(5 * line);

    begin("neighbouring_lines");  // two sets, or two ways of the only one
    for (const uint32_t a : {line - 1, line, line - 1, line, 2 * line - 1, 2 * line}) read(a);

    begin("fill_a_set");  // way 0 first; everything stays
    for (int round = 0; round < 2; ++round) {
        for (uint32_t w = 0; w < ways; ++w) read(w * stride + 3);
    }

    begin("one_line_too_many");  // in turn: not one hit, with either replacement
    for (int round = 0; round < 3; ++round) {
        for (uint32_t w = 0; w <= ways; ++w) read(w * stride);
    }

    begin("hit_saves_a_line");  // least recent keeps line 0, oldest drops it
    for (uint32_t w = 0; w < ways; ++w) read(w * stride);
    read(0);
    read(ways * stride);
    read(0);
    read(stride);

    begin("same_set_backwards");
    for (uint32_t w = 2 * ways; w-- > 0;) read(w * stride + w % line);

    begin("last_address");  // its line, the lowest one, and the one before
    for (const uint32_t a : {kLastAddress, kLastAddress - line + 1, kLastAddress - line,
                             uint32_t{0}, kLastAddress, uint32_t{0}}) {
        read(a);
    }

    begin("tags_differ_in_one_bit");
    for (uint32_t bit = stride; bit <= kLastAddress; bit <<= 1) {
        read(0);
        read(bit);
    }

    begin("reset_between_frames");
    for (const uint32_t a : {0U, stride, 0U, stride}) read(a);
    begin("another_table", 2);  // the same addresses: nothing old may be read
    for (const uint32_t a : {stride, 0U, stride, 0U}) read(a);

    begin("invalidated_at_each_read");
    for (int i = 0; i < 4; ++i) read(7, true);
    read(7);

    begin("order_starts_again");  // after an invalidation way 0 is filled first
    for (uint32_t w = 0; w < ways + 1; ++w) read(w * stride);
    read(stride, true);
    for (uint32_t w = 0; w < ways; ++w) read(w * stride);
    return cases;
}

/// Walks, jumps within a window somewhat larger than the cache or much smaller, conflicts in one
/// set, and addresses anywhere; now and then an invalidation.
Scenario TexelCacheModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, table(1 + random.below(4)), {}};
    s.inputs.reserve(count * inputs());
    const uint32_t words = unit_.shape().words();
    const uint32_t rare = 1 + random.below(200);
    uint32_t base = 0, address = 0, left = 0, kind = 0, window = 1;
    for (std::size_t i = 0; i < count; ++i) {
        if (left-- == 0) {
            left = random.below(100);
            kind = random.below(5);
            window = 1 + random.below(2 * words);
            if (random.percent(30)) {
                base = static_cast<uint32_t>(random.of_any_length(kTexelAddressBits));
            }
        }
        const auto ways = static_cast<uint32_t>(unit_.shape().ways);
        if (kind == 0) address += random.below(3);
        if (kind == 1) address = base + random.below(window);
        if (kind == 2) address = base + set_stride() * random.below(ways + 2);
        if (kind == 3) address -= line_words() - random.below(2 * line_words());
        if (kind == 4) address = static_cast<uint32_t>(random.of_any_length(kTexelAddressBits));
        address &= kLastAddress;
        s.add(TexelCacheIn{i == 0 || random.below(rare) == 0, address});
    }
    return s;
}

/// The state after a read in a line, by the rules of the sheet.
State TexelCacheModel::after(const State& state, uint32_t line) const {
    State next = state;
    std::vector<uint32_t>& lines = next[line & ((uint32_t{1} << unit_.shape().set_bits) - 1)];
    std::size_t at = 0;
    while (at < lines.size() && lines[at] >> 4 != line + 1) ++at;
    const bool hit = at < lines.size();
    if (hit && unit_.shape().replacement == CacheReplacement::Oldest) return next;
    const uint32_t way = lines[hit ? at : 0] & 15;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(hit ? at : 0));
    lines.push_back((line + 1) << 4 | way);
    return next;
}

/// Every state that the cache can be in, with lines of which each set has two more than ways, and
/// in each of them every read of their words, with and without an invalidation before it. A state
/// is reached from an empty cache by the shortest way.
Scenario TexelCacheModel::exhaustive(uint64_t portion) const {
    if (portion > 0) return {};
    const CacheShape& shape = unit_.shape();
    const auto ways = static_cast<uint32_t>(shape.ways);
    const uint32_t lines = (ways + 2) << shape.set_bits;
    std::vector<uint32_t> empty;
    for (uint32_t way = 0; way < ways; ++way) empty.push_back(way);
    const State start(std::size_t{1} << shape.set_bits, empty);

    std::map<State, std::vector<uint32_t>> paths = {{start, {}}};  // lines that lead to a state
    std::vector<State> found = {start};
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (uint32_t line = 0; line < lines; ++line) {
            State next = after(found[i], line);
            std::vector<uint32_t> path = paths[found[i]];
            path.push_back(line);
            if (paths.try_emplace(next, std::move(path)).second) found.push_back(std::move(next));
        }
    }
    Scenario s{"exhaustive", {}, table(1), {}};
    for (const State& state : found) {
        for (uint32_t last = 0; last < 2 * lines * line_words(); ++last) {
            bool first = true;
            for (const uint32_t line : paths[state]) {
                s.add(TexelCacheIn{std::exchange(first, false), line * line_words()});
            }
            s.add(TexelCacheIn{std::exchange(first, false) || last % 2 == 1, last / 2});
        }
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_texel_cache_model(const Profile& profile) {
    return std::make_unique<TexelCacheModel>(profile);
}

}  // namespace repousse::cosim
