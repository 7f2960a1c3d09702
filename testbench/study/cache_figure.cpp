#include <array>

#include <fmt/format.h>

#include "testbench/study/cache.h"

namespace repousse::study {
namespace {

// A row of panels a scene, a column a unit; x is the size of the cache, y the hit rate. Below them
// a row about ways and replacement.
constexpr double kPanelWidth = 250, kPanelHeight = 130, kLeft = 150, kTop = 44;
constexpr double kColumnGap = 26, kRowGap = 34;
constexpr std::array kUnits = {"displace", "bump", "height_test"};
constexpr std::array kColours = {"#b5432f", "#c98a1b", "#2a9d5c", "#1b6ca8"};
constexpr int kLeast = kLeastCacheBits, kMost = kMostCacheBits;

std::string text_at(double x, double y, const char* anchor, const std::string& content) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                       content) +
           "\n";
}

std::string line(double x0, double y0, double x1, double y1, const std::string& style) {
    return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", x0, y0, x1,
                       y1, style) +
           "\n";
}

std::string stroke(std::size_t colour, bool dashed) {
    return fmt::format(R"(stroke="{}" stroke-width="1.6"{})", kColours[colour],
                       dashed ? R"( stroke-dasharray="5 3")" : "");
}

/// One panel's place.
struct Panel {
    double left, top;

    double x(int size_bits) const {
        return left + kPanelWidth * (size_bits - kLeast) / (kMost - kLeast);
    }
    double y(double percent) const { return top + kPanelHeight * (1 - percent / 100); }

    std::string axes(bool labels_left) const {
        std::string svg;
        for (int percent = 0; percent <= 100; percent += 25) {
            svg += line(left, y(percent), left + kPanelWidth, y(percent), R"(stroke="#ddd")");
            if (labels_left)
                svg += text_at(left - 6, y(percent) + 4, "end", fmt::format("{} %", percent));
        }
        for (int bits = kLeast; bits <= kMost; bits += 2) {
            const std::string size =
                bits < 10 ? std::to_string(1 << bits) : fmt::format("{} K", 1 << (bits - 10));
            svg += text_at(x(bits), top + kPanelHeight + 15, "middle", size);
        }
        return svg;
    }

    std::string curve(const CacheUnit& unit, int line_bits, int ways, CacheReplacement replacement,
                      const std::string& style) const {
        std::string points;
        for (int bits = kLeast; bits <= kMost; ++bits) {
            const CacheResult* result = unit.at(bits, line_bits, ways, replacement);
            if (result == nullptr) continue;
            points += fmt::format("{:.1f},{:.1f} ", x(bits), y(result->hit_rate()));
        }
        return fmt::format(R"(<polyline fill="none" {} points="{}"/>)", style, points) + "\n";
    }
};

Panel panel(std::size_t row, std::size_t column) {
    return {kLeft + static_cast<double>(column) * (kPanelWidth + kColumnGap),
            kTop + static_cast<double>(row) * (kPanelHeight + kRowGap)};
}

const CacheUnit* unit_of(const CacheScene& scene, const std::string& name) {
    for (const CacheUnit& unit : scene.units) {
        if (unit.unit == name) return &unit;
    }
    return nullptr;
}

std::string lines_row(const CacheScene& scene, std::size_t row) {
    std::string svg = text_at(10, panel(row, 0).y(50) + 4, "start", scene.scene);
    bool labelled = false;
    for (std::size_t column = 0; column < kUnits.size(); ++column) {
        const CacheUnit* unit = unit_of(scene, kUnits[column]);
        if (unit == nullptr) continue;
        const Panel at = panel(row, column);
        svg += at.axes(!labelled);
        labelled = true;
        for (std::size_t i = 0; i < CacheReport::kLineBits.size(); ++i) {
            svg += at.curve(*unit, CacheReport::kLineBits[i], 4, CacheReplacement::LeastRecent,
                            stroke(i, false));
        }
    }
    return svg;
}

std::string ways_panel(const CacheScene& scene, const char* name, Panel at, bool labels_left) {
    const CacheUnit* unit = unit_of(scene, name);
    if (unit == nullptr) return {};
    std::string svg = at.axes(labels_left);
    svg += text_at(at.left + kPanelWidth / 2, at.top - 7, "middle",
                   fmt::format("{}, {}", scene.scene, name));
    std::size_t colour = 0;
    for (const int ways : {1, 2, 4}) {
        svg += at.curve(*unit, 3, ways, CacheReplacement::LeastRecent, stroke(colour, false));
        if (ways > 1) {
            svg += at.curve(*unit, 3, ways, CacheReplacement::Oldest, stroke(colour, true));
        }
        ++colour;
    }
    return svg;
}

std::string legend(double y, std::size_t at, std::size_t colour, bool dashed, const char* what) {
    const double x = kLeft + 150 * static_cast<double>(at);
    return line(x, y - 4, x + 18, y - 4, stroke(colour, dashed)) +
           text_at(x + 23, y, "start", what);
}

}  // namespace

std::string cache_figure(const CacheReport& report) {
    std::string svg;
    for (std::size_t column = 0; column < kUnits.size(); ++column) {
        svg +=
            text_at(panel(0, column).left + kPanelWidth / 2, kTop - 12, "middle", kUnits[column]);
    }
    std::size_t row = 0;
    for (const CacheScene& scene : report.scenes) {
        if (!scene.eager) svg += lines_row(scene, row++);
    }
    double y = panel(row, 0).top + 2;
    svg += legend(y, 0, 0, false, "lines of 1 word");
    svg += legend(y, 1, 1, false, "4 words");
    svg += legend(y, 2, 2, false, "8 words");
    svg += legend(y, 3, 3, false, "16 words");
    svg += text_at(kLeft + 600, y, "start", "4 ways, least recently used");

    const double top = y + 44;
    svg += text_at(10, top + kPanelHeight / 2 + 4, "start", "lines of 8 words");
    std::size_t column = 0;
    for (const CacheScene& scene : report.scenes) {
        const bool wanted =
            !scene.eager && scene.scene != "donut" && scene.scene != "terrain_sweep";
        if (!wanted || column == kUnits.size()) continue;
        const char* unit = scene.scene == "head" ? "height_test" : "displace";
        svg += ways_panel(scene, unit, {panel(0, column).left, top}, column == 0);
        ++column;
    }
    y = top + kPanelHeight + kRowGap + 6;
    svg += legend(y, 0, 0, false, "1 way");
    svg += legend(y, 1, 1, false, "2 ways");
    svg += legend(y, 2, 1, true, "2, oldest");
    svg += legend(y, 3, 2, false, "4 ways");
    svg += legend(y, 4, 2, true, "4, oldest");
    const double width = panel(0, kUnits.size()).left;
    const double height = y + 16;
    return fmt::format(
               R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
               R"(viewBox="0 0 {0:.0f} {1:.0f}" font-family="sans-serif" font-size="12">)",
               width, height) +
           "\n" + R"(<rect width="100%" height="100%" fill="#fff"/>)" + "\n" + svg + "</svg>\n";
}

}  // namespace repousse::study
