#include "testbench/study/paragraph.h"

#include <algorithm>

namespace repousse::study {

std::string paragraph(const std::string& prose) {
    std::string text;
    std::size_t line = 0;
    for (std::size_t from = 0; from < prose.size();) {
        const std::size_t to = std::min(prose.find(' ', from), prose.size());
        const std::size_t word = to - from;
        if (line != 0 && line + 1 + word > 100) {
            text += '\n';
            line = 0;
        }
        if (line != 0) text += ' ', ++line;
        text += prose.substr(from, word);
        line += word;
        from = to + 1;
    }
    return text + "\n\n";
}

}  // namespace repousse::study
