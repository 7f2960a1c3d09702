#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "testbench/study/filter.h"

namespace repousse::study {
namespace {

// One panel a map, side by side; x is the step, y the volume over the start's.
constexpr double kPanelWidth = 300, kPanelHeight = 230, kLeft = 52, kTop = 44, kGap = 24;
constexpr int kSteps = 48;  // a longer curve is cut here: it is level by then
constexpr double kLow = 0.45, kHigh = 1.0;
constexpr std::array kColours = {"#1b6ca8", "#2a9d5c", "#c98a1b", "#b5432f", "#6d4b9a"};

double x_of(double left, double step) { return left + step * kPanelWidth / kSteps; }
double y_of(double ratio) {
    return kTop + (kHigh - std::clamp(ratio, kLow, kHigh)) / (kHigh - kLow) * kPanelHeight;
}

std::string text_at(double x, double y, const char* anchor, const std::string& content) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                       content) +
           "\n";
}

std::string line(double x0, double y0, double x1, double y1, const char* style) {
    return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", x0, y0, x1,
                       y1, style) +
           "\n";
}

std::string panel(const FilteredMap& map, double left) {
    std::string svg;
    for (int percent = 50; percent <= 100; percent += 10) {
        const double y = y_of(percent / 100.0);
        const bool promised = percent == 70;
        svg += line(left, y, left + kPanelWidth, y,
                    promised ? R"(stroke="#444" stroke-dasharray="5 4")" : R"(stroke="#ddd")");
        if (left == kLeft) svg += text_at(left - 6, y + 4, "end", fmt::format("{} %", percent));
    }
    for (int step = 0; step <= kSteps; step += 16) {
        svg += text_at(x_of(left, step), kTop + kPanelHeight + 18, "middle", std::to_string(step));
    }
    svg += text_at(left + kPanelWidth / 2, kTop - 12, "middle", map.name);
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        const FilterLevelReport& level = map.levels[i];
        const char* colour = kColours[i % kColours.size()];
        std::string points;
        const std::size_t count = std::min<std::size_t>(level.curve.size(), kSteps + 1);
        for (std::size_t step = 0; step < count; ++step) {
            points += fmt::format("{:.1f},{:.1f} ", x_of(left, static_cast<double>(step)),
                                  y_of(level.curve[step]));
        }
        svg += fmt::format(R"(<polyline fill="none" stroke="{}" stroke-width="1.6" points="{}"/>)",
                           colour, points) +
               "\n";
    }
    return svg;
}

}  // namespace

std::string filter_figure(const FilterReport& report) {
    const double count = std::max<double>(1, static_cast<double>(report.maps.size()));
    const double width = kLeft + count * (kPanelWidth + kGap);
    const double height = kTop + kPanelHeight + 62;
    std::string svg =
        fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
                    R"(viewBox="0 0 {0:.0f} {1:.0f}" font-family="sans-serif" font-size="12">)",
                    width, height) +
        "\n" + R"(<rect width="100%" height="100%" fill="#fff"/>)" + "\n";
    double left = kLeft;
    for (const FilteredMap& map : report.maps) {
        svg += panel(map, left);
        left += kPanelWidth + kGap;
    }
    for (std::size_t i = 0; i < kColours.size(); ++i) {
        const double x = kLeft + 70 * static_cast<double>(i);
        const double y = height - 16;
        svg += line(x, y - 4, x + 18, y - 4,
                    fmt::format(R"(stroke="{}" stroke-width="2")", kColours[i]).c_str());
        svg += text_at(x + 23, y, "start", fmt::format("level {}", i + 1));
    }
    svg += text_at(kLeft + 370, height - 16, "start",
                   "difference volume over that of the average, by steps; dashed: 70 %");
    return svg + "</svg>\n";
}

}  // namespace repousse::study
