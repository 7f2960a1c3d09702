#include "datapath/numbers/format.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <utility>

namespace repousse {
namespace {

Format parsed(std::string_view text) {
    const Result<Format> format = parse_format(text);
    EXPECT_TRUE(format) << text;
    return format ? *format : Format{};
}

std::string refusal(std::string_view text) {
    const Result<Format> format = parse_format(text);
    EXPECT_FALSE(format) << text << " was accepted";
    return format ? "" : format.error().message();
}

TEST(Format, CountsTheSignAmongTheBits) {
    const Format format = parsed("s14.8");
    EXPECT_EQ(format.width, 23);
    EXPECT_EQ(format.frac, 8);
    EXPECT_EQ(format.integer_bits(), 14);
    EXPECT_TRUE(format.is_signed);
    EXPECT_EQ(format.min_raw(), -(1 << 22));
    EXPECT_EQ(format.max_raw(), (1 << 22) - 1);
    EXPECT_EQ(parsed("u0.16").width, 16);
    EXPECT_EQ(parsed("u0.16").max_raw(), 65535);
}

TEST(Format, HasTheStandardsDefaults) {
    const Format format = parsed("u4.4");
    EXPECT_EQ(format.quantization, Quantization::SC_TRN);
    EXPECT_EQ(format.overflow, Overflow::SC_WRAP);
    EXPECT_EQ(format.saturated_bits, 0);
    EXPECT_EQ(parsed("u4.4 SC_TRN SC_WRAP 0"), format);
}

TEST(Format, AcceptsPointsOutsideTheBits) {
    EXPECT_EQ(parsed("s20.-4").width, 17);
    EXPECT_EQ(parsed("u-4.16").width, 12);
    EXPECT_EQ(parsed("u-4.16").integer_bits(), -4);
}

TEST(Format, ReachesBothEndsOf63Bits) {
    EXPECT_EQ(parsed("s62.0").min_raw(), -(int64_t{1} << 62));
    EXPECT_EQ(parsed("u63.0").max_raw(), INT64_MAX);
    EXPECT_TRUE(parsed("u63.0").contains(INT64_MAX));
    EXPECT_FALSE(parsed("u63.0").contains(-1));
    EXPECT_EQ(parsed("s0.0").min_raw(), -1);
    EXPECT_EQ(parsed("s0.0").max_raw(), 0);
}

TEST(Format, RefusesWhatItDoesNotKnowAndSaysWhatItExpected) {
    for (const char* text : {"",
                             "14.8",
                             "s14",
                             "q14.8",
                             "S14.8",
                             "s.8",
                             "s14.",
                             "s 14.8",
                             "s+1.8",
                             "s01.8",
                             "s1.08",
                             "s-0.8",
                             "s1.8x",
                             "s1234.8",
                             " s1.8",
                             "s1.8 ",
                             "s1.8  SC_RND",
                             "s1.8 RND",
                             "s1.8 SC_SAT",
                             "s1.8 SC_RND SC_TRN",
                             "s1.8 SC_RND SC_SAT 2",
                             "s1.8 SC_RND SC_WRAP -1",
                             "s1.8 SC_RND SC_WRAP 3 4",
                             "s1.8\tSC_RND",
                             "s1.8.2"}) {
        EXPECT_NE(refusal(text).find(", expected "), std::string::npos) << text;
    }
    EXPECT_EQ(refusal("s1.8 SC_RUND"),
              "format 's1.8 SC_RUND' has no meaning at 'SC_RUND', expected one of SC_TRN "
              "SC_TRN_ZERO SC_RND SC_RND_MIN_INF SC_RND_ZERO SC_RND_INF SC_RND_CONV");
}

TEST(Format, RefusesWhatIsOutOfItsLimits) {
    EXPECT_EQ(refusal("s40.23"), "format 's40.23': a format of 64 bits in all, expected 1 to 63");
    EXPECT_EQ(refusal("u3.-3"), "format 'u3.-3': a format of 0 bits in all, expected 1 to 63");
    EXPECT_NE(refusal("s-100.127").find("127 fraction bits, expected -63 to 126"),
              std::string::npos);
    EXPECT_NE(refusal("s100.-64").find("-64 fraction bits"), std::string::npos);
    EXPECT_NE(refusal("u8.0 SC_TRN SC_WRAP_SM").find("expected a signed format"),
              std::string::npos);
    EXPECT_NE(refusal("u8.0 SC_TRN SC_WRAP 9").find("9 saturated bits, expected 0 to 8"),
              std::string::npos);
    Format format;
    format.overflow = Overflow::SC_SAT;
    format.saturated_bits = 1;
    EXPECT_FALSE(check_format(format));
}

TEST(Format, PrintsNoDefaultAtTheEnd) {
    EXPECT_EQ(to_string(parsed("s14.8 SC_TRN SC_WRAP 0")), "s14.8");
    EXPECT_EQ(to_string(parsed("s14.8 SC_RND SC_WRAP")), "s14.8 SC_RND");
    EXPECT_EQ(to_string(parsed("s14.8 SC_TRN SC_SAT")), "s14.8 SC_TRN SC_SAT");
    EXPECT_EQ(to_string(parsed("s14.8 SC_TRN SC_WRAP 3")), "s14.8 SC_TRN SC_WRAP 3");
}

RC_GTEST_PROP(Format, ParsesWhatItPrints, ()) {
    Format format;
    format.is_signed = *rc::gen::arbitrary<bool>();
    format.width = *rc::gen::inRange(1, kMaxWidth + 1);
    format.frac = *rc::gen::inRange(kMinFrac, kMaxFrac + 1);
    format.quantization = static_cast<Quantization>(*rc::gen::inRange(0, 7));
    format.overflow = static_cast<Overflow>(*rc::gen::inRange(0, format.is_signed ? 5 : 4));
    if (format.overflow == Overflow::SC_WRAP || format.overflow == Overflow::SC_WRAP_SM) {
        format.saturated_bits = *rc::gen::inRange(0, format.width + 1);
    }
    RC_ASSERT(static_cast<bool>(check_format(format)));
    const Result<Format> again = parse_format(to_string(format));
    RC_ASSERT(static_cast<bool>(again));
    RC_ASSERT(*again == format);
}

}  // namespace
}  // namespace repousse
