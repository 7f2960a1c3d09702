#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "datapath/error.h"

namespace repousse::host {

/// Splits a text file into tokens and remembers where each one stood, for messages of the form
/// file:line:column. Carriage returns are white space; a '#' starts a comment that ends with the
/// line; a backslash at the end of a line joins the next one (OBJ).
class TextReader {
public:
    TextReader(const std::string& bytes, std::string name) : text_(bytes), name_(std::move(name)) {}

    /// The next token of the current line; empty at its end.
    std::string_view in_line();
    /// The next token on this line or a later one; empty at the end of the file.
    std::string_view anywhere();
    /// Moves behind the end of the current line. False when the file ends before it.
    bool skip_line();

    /// A finite number as the next token of the line (or anywhere). The error names the token, or
    /// the end of the line, and says that `what` was expected ("the x of a vertex").
    Result<double> number(const std::string& what, bool same_line = true);
    /// An integer in low..high, likewise.
    Result<std::int64_t> integer(const std::string& what, std::int64_t low, std::int64_t high,
                                 bool same_line = true);

    /// An Input error at the token read last.
    Error error(std::string what, std::string expected = "") const;

    std::size_t bytes_left() const { return text_.size() - at_; }
    std::size_t offset() const { return at_; }

private:
    std::string_view take();
    void new_line();
    std::string_view expect(bool same_line);

    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    int line_ = 1;
    int token_line_ = 1;
    std::size_t token_column_ = 1;
};

/// The whole token as a double, with an optional sign; nothing when it is not a number or beyond
/// the range of double. "nan" and "inf" are numbers here.
std::optional<double> parse_double(std::string_view token);
/// The whole token as an integer.
std::optional<std::int64_t> parse_integer(std::string_view token);

}  // namespace repousse::host
