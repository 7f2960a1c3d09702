#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/host/view/picture.h"

namespace repousse::study {

/// A picture of a figure; its file is images/NAME.png beside the document.
struct FigurePicture {
    std::string name;
    host::Picture picture;
};

/// A figure of a paper, made again.
struct Figure {
    int number = 0;
    std::string text;  ///< Markdown, heading and tables included
    std::vector<FigurePicture> pictures;
};

struct FigureOptions {
    std::string scenes = "scenes";  ///< folder of the scene files
    bool draw = true;               ///< false: tables only, the same as with pictures
    std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// The figures that can be made: 9 to 11 of Doggett and Hirche, 18 and 19 of Gumhold and Huettner.
inline constexpr std::array kFigures = {9, 10, 11, 18, 19};

/// Makes a figure again with the bit-accurate units, from scenes whose maps fall back on procedural
/// ones when their files are absent; the text says which it was. The same inputs give the same
/// text and pictures. Errors: an unknown number, a scene that cannot be read.
Result<Figure> make_figure(int number, const FigureOptions& options);

/// The document that holds the figures.
std::string figures_markdown(const std::vector<Figure>& figures);

}  // namespace repousse::study
