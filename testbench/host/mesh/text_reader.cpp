#include "testbench/host/mesh/text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace repousse::host {
namespace {

std::string_view without_plus(std::string_view token) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    return token;
}

template <class T>
std::optional<T> parse_whole(std::string_view token) {
    token = without_plus(token);
    T value{};
    const char* end = token.data() + token.size();
    const auto [stop, code] = std::from_chars(token.data(), end, value);
    if (code != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// A token for a message: at most 32 characters, nothing unprintable.
std::string shown(std::string_view token) {
    std::string text;
    for (const char c : token.substr(0, 32)) text += c >= ' ' && c <= '~' ? c : '?';
    return "\"" + text + (token.size() > 32 ? "...\"" : "\"");
}

}  // namespace

std::optional<double> parse_double(std::string_view token) { return parse_whole<double>(token); }

std::optional<std::int64_t> parse_integer(std::string_view token) {
    return parse_whole<std::int64_t>(token);
}

void TextReader::new_line() {
    ++at_;
    ++line_;
    line_start_ = at_;
}

std::string_view TextReader::in_line() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v') {
            ++at_;
        } else if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (c == '\\' && text_.substr(at_ + 1, 1) == "\n") {
            ++at_;
            new_line();
        } else if (c == '\\' && text_.substr(at_ + 1, 2) == "\r\n") {
            at_ += 2;
            new_line();
        } else {
            break;
        }
    }
    return take();
}

std::string_view TextReader::take() {
    token_line_ = line_;
    token_column_ = at_ - line_start_ + 1;
    const std::size_t start = at_;
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '#') {
            break;
        }
        ++at_;
    }
    return text_.substr(start, at_ - start);
}

std::string_view TextReader::anywhere() {
    std::string_view token = in_line();
    while (token.empty() && at_ < text_.size()) {
        new_line();
        token = in_line();
    }
    return token;
}

bool TextReader::skip_line() {
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ == text_.size()) return false;
    new_line();
    return true;
}

std::string_view TextReader::expect(bool same_line) { return same_line ? in_line() : anywhere(); }

Error TextReader::error(std::string what, std::string expected) const {
    return {ErrorKind::Input,
            name_ + ":" + std::to_string(token_line_) + ":" + std::to_string(token_column_),
            std::move(what), std::move(expected), ""};
}

Result<double> TextReader::number(const std::string& what, bool same_line) {
    const std::string_view token = expect(same_line);
    if (token.empty()) {
        return error(at_ == text_.size() ? "the file ends here" : "the line ends here", what);
    }
    const std::optional<double> value = parse_double(token);
    if (!value) return error(shown(token) + " is not a number", what);
    if (!std::isfinite(*value)) return error(shown(token) + " is not finite", what);
    return *value;
}

Result<std::int64_t> TextReader::integer(const std::string& what, std::int64_t low,
                                         std::int64_t high, bool same_line) {
    const std::string_view token = expect(same_line);
    if (token.empty()) {
        return error(at_ == text_.size() ? "the file ends here" : "the line ends here", what);
    }
    const std::optional<std::int64_t> value = parse_integer(token);
    const std::string range = what + " in " + std::to_string(low) + ".." + std::to_string(high);
    if (!value) return error(shown(token) + " is not an integer", range);
    if (*value < low || *value > high) return error(shown(token) + " is out of range", range);
    return *value;
}

}  // namespace repousse::host
