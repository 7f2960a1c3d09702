#include "testbench/study/figures.h"

#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {

Result<Figure> make_figure(int number, const FigureOptions& options) {
    switch (number) {
        case 9:
            return figure_9(options);
        case 10:
            return figure_10(options);
        case 11:
            return figure_11(options);
        case 18:
            return figure_18(options);
        case 19:
            return figure_19(options);
        default:
            return Error{ErrorKind::Input,
                         "figure " + std::to_string(number),
                         "cannot be made",
                         "9, 10, 11, 18 or 19",
                         {}};
    }
}

std::string figures_markdown(const std::vector<Figure>& figures) {
    std::string text =
        "# The papers' figures, made again\n\n" +
        paragraph(
            "Made by `repousse study figures -o docs/figures.md` (after `scenes/fetch.sh`), "
            "pictures too; `--only 18` makes one. All triangles come from the bit-accurate units "
            "at the default profile and are the same as `repousse sim` makes of the same scene "
            "and camera. `figures_test` fails when a table is stale.");
    for (const Figure& figure : figures) text += figure.text;
    while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
    return text;
}

}  // namespace repousse::study
