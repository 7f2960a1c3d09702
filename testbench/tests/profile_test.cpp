// Profiles: every key is needed, no other is taken, widths that overflow are refused by name, and
// the hash sees exactly the keys it is given.

#include "datapath/profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "testbench/tests/support/profiles.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;
using testing::HasSubstr;

Pairs default_pairs() {
    const Profile profile = test::profile_with("default", {});
    Pairs pairs;
    for (const ProfileEntry& entry : profile_entries()) {
        pairs.emplace_back(entry.key, entry_text(profile, entry));
    }
    return pairs;
}

Pairs replaced(const std::string& key, const std::string& value) {
    Pairs pairs = default_pairs();
    for (auto& [k, v] : pairs) {
        if (k == key) v = value;
    }
    return pairs;
}

TEST(Profile, ShippedProfilesParseAndComeBackFromTheirOwnText) {
    const auto names = shipped_profile_names();
    ASSERT_GE(names.size(), 2u);
    EXPECT_EQ(names[0], "default");
    EXPECT_NE(std::find(names.begin(), names.end(), "narrow"), names.end());
    for (const auto name : names) {
        const auto profile = shipped_profile(name);
        ASSERT_TRUE(profile) << profile.error().message();
        Pairs pairs;
        for (const ProfileEntry& entry : profile_entries()) {
            pairs.emplace_back(entry.key, entry_text(*profile, entry));
            EXPECT_FALSE(entry.doc.empty());
        }
        const auto again = make_profile(pairs);
        ASSERT_TRUE(again);
        for (const ProfileEntry& entry : profile_entries()) {
            EXPECT_EQ(entry_text(*again, entry), entry_text(*profile, entry)) << entry.key;
        }
    }
}

TEST(Profile, EveryKeyIsRequiredOnce) {
    const Pairs all = default_pairs();
    ASSERT_TRUE(make_profile(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
        Pairs fewer = all;
        fewer.erase(fewer.begin() + std::ptrdiff_t(i));
        const auto missing = make_profile(fewer);
        ASSERT_FALSE(missing);
        EXPECT_EQ(missing.error().where, all[i].first);
        EXPECT_EQ(missing.error().what, "missing key");
        EXPECT_EQ(missing.error().kind, ErrorKind::Input);
        Pairs more = all;
        more.push_back(all[i]);
        const auto twice = make_profile(more);
        ASSERT_FALSE(twice);
        EXPECT_EQ(twice.error().where, all[i].first);
        EXPECT_EQ(twice.error().what, "given twice");
    }
}

TEST(Profile, UnknownKeysAreRefused) {
    Pairs pairs = default_pairs();
    pairs.emplace_back("flavour", "s1.2");
    const auto profile = make_profile(pairs);
    ASSERT_FALSE(profile);
    EXPECT_EQ(profile.error().where, "flavour");
    EXPECT_EQ(profile.error().what, "unknown key");
}

TEST(Profile, ValuesOutOfRangeAreRefusedByKey) {
    for (const ProfileEntry& entry : profile_entries()) {
        const std::string key(entry.key);
        std::vector<std::string> bad = {"", "many", "-1", "99999999999"};
        if (entry.format != nullptr) {
            const char sign = entry.is_signed ? 's' : 'u';
            const char other = entry.is_signed ? 'u' : 's';
            const int extra = entry.is_signed ? 1 : 0;
            bad.push_back(sign + std::to_string(entry.high - extra + 1) + ".0");
            bad.push_back(sign + std::to_string(entry.low - extra - 1) + ".0");
            bad.push_back(other + std::string("4.4"));
            bad.push_back(sign + std::string("4.4 SC_ROUND"));
        } else {
            bad.push_back(std::to_string(entry.low - 1));
            bad.push_back(std::to_string(entry.high + 1));
            bad.push_back("7.5");
        }
        for (const std::string& value : bad) {
            const auto profile = make_profile(replaced(key, value));
            ASSERT_FALSE(profile) << key << " = " << value;
            EXPECT_EQ(profile.error().where, key) << value;
            EXPECT_FALSE(profile.error().expected.empty()) << key << " = " << value;
        }
    }
}

// One case for each rule that the ranges of single keys leave to be broken: an intermediate result
// longer than 64 bits, or terms that do not align.
TEST(Profile, GrowthRulesNameTheKey) {
    struct Case {
        const char* rule;
        Pairs changes;
    };
    const Case cases[] = {
        {"position", {{"position", "s31.0"}}},
        {"displacement", {{"displacement", "s8.4"}, {"normal", "s1.11"}, {"position", "s7.16"}}},
        {"filtered_height", {{"filtered_height", "u0.15"}}},
        {"normal", {{"normal", "s1.10"}}},
        {"cosine", {{"cosine", "s0.16"}}},
        {"uv", {{"uv", "s10.17"}, {"sweep_data", "s13.16"}}},
    };
    for (const Case& c : cases) {
        Pairs pairs = default_pairs();
        for (auto& [key, value] : pairs) {
            for (const auto& [k, v] : c.changes) {
                if (k == key) value = v;
            }
        }
        const auto profile = make_profile(pairs);
        ASSERT_FALSE(profile) << c.rule;
        EXPECT_EQ(profile.error().where, c.rule) << profile.error().message();
        EXPECT_FALSE(profile.error().expected.empty());
    }
}

TEST(Profile, HashSeesTheKeysOfItsUnitAndNoOther) {
    const std::string_view keys[] = {"uv", "sat_width"};
    const Profile base = test::profile_with("default", {});
    const uint64_t hash = profile_hash(base, keys);
    std::set<uint64_t> hashes = {hash};
    for (const ProfileEntry& entry : profile_entries()) {
        const std::string key(entry.key);
        std::string value;
        if (entry.format != nullptr) {
            Format format = base.*entry.format;
            format.overflow =
                format.overflow == Overflow::SC_WRAP ? Overflow::SC_SAT : Overflow::SC_WRAP;
            value = to_string(format);
        } else {
            const int now = base.*entry.integer;
            value = std::to_string(now == entry.low ? now + 1 : now - 1);
        }
        const uint64_t changed = profile_hash(test::profile_with("default", {{key, value}}), keys);
        EXPECT_EQ(changed != hash, key == "uv" || key == "sat_width") << key;
        EXPECT_EQ(hashes.insert(changed).second, changed != hash) << key;
    }
    const std::string_view unknown[] = {"uv", "sat_width", "flavour"};
    EXPECT_EQ(profile_hash(base, unknown), hash);
    // Stored in vector files: this value may change with the shipped profile's uv or sat_width.
    EXPECT_NE(profile_hash(test::profile_with("narrow", {}), keys), hash);
}

TEST(ProfileReader, ErrorsSayFileLineAndColumn) {
    std::string text;
    for (const auto& [key, value] : default_pairs()) {
        const bool number = value.find_first_not_of("0123456789") == std::string::npos;
        text += key + " = " + (number ? value : '"' + value + '"') + "\n";
    }
    ASSERT_TRUE(parse_profile(text, "my.toml"));
    const auto message = [&](const std::string& changed) {
        const auto profile = parse_profile(changed, "my.toml");
        return profile ? std::string("accepted") : profile.error().message();
    };
    EXPECT_THAT(message(text + "flavour = 3\n"), HasSubstr("my.toml:"));
    EXPECT_THAT(message(text + "flavour = 3\n"), HasSubstr("unknown key"));
    EXPECT_THAT(message("# one\nflavour = 3\n" + text), HasSubstr("my.toml:2:"));
    EXPECT_THAT(message("\n\nuv = \"s14\n"), HasSubstr("my.toml:3:"));  // no TOML
    EXPECT_THAT(message("\nuv = 1.5\n"), HasSubstr("my.toml:2:"));      // a wrong kind
    EXPECT_THAT(message("uv = \"u14.8\"\n"), HasSubstr("my.toml:1:"));  // a wrong value
    EXPECT_THAT(message(text.substr(text.find('\n') + 1)), HasSubstr("\"uv\": missing key"));
    EXPECT_EQ(parse_profile("\n", "x").error().kind, ErrorKind::Input);
}

TEST(ProfileReader, AMissingFileListsWhatIsShipped) {
    const auto profile = find_profile("no/such/profile.toml");
    ASSERT_FALSE(profile);
    EXPECT_THAT(profile.error().message(), HasSubstr("no/such/profile.toml"));
    EXPECT_THAT(profile.error().message(), HasSubstr("narrow"));
    ASSERT_TRUE(find_profile("narrow"));
    ASSERT_TRUE(find_profile("tlm/config/profiles/narrow.toml"));
}

}  // namespace
}  // namespace repousse
