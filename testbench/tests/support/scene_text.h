#pragma once

#include <gtest/gtest.h>

#include <string>

#include "testbench/host/scene/scene.h"

namespace repousse::test {

/// A scene of an adaptive object, as a file has it.
inline const char* const kGoodScene = R"(title = "t"
[viewport]
width_px = 64
height_px = 48
[camera]
eye = [0, -1, 1]
target = [0, 0, 0]
[[object]]
name = "o"
method = "adaptive"
[object.mesh]
kind = "grid"
quads = [3, 3]
[object.map]
kind = "donut"
range = 0.12
[object.adaptive]
normal_threshold = 0.2
height_threshold_lsb = 4096
)";

/// The good scene with one line replaced (or, with an empty `from`, one added at its end).
inline std::string with(const std::string& from, const std::string& to) {
    std::string text = kGoodScene;
    if (from.empty()) return text + to + "\n";
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// The good scene, swept; `settings` is the content of [object.sweep], if any.
inline std::string swept(const std::string& settings) {
    std::string text = with("method = \"adaptive\"", "method = \"sweep\"");
    text.resize(text.find("[object.adaptive]"));
    return settings.empty() ? text : text + "[object.sweep]\n" + settings + "\n";
}

/// What parse_scene() says of a scene.
inline std::string message(const std::string& text) {
    const auto scene = host::parse_scene(text, "s.toml", "testbench/tests");
    return scene.ok() ? "(accepted)" : scene.error().message();
}

}  // namespace repousse::test
