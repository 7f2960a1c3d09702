#pragma once

#include <string>
#include <utility>
#include <variant>

namespace repousse {

/// What an error means for the caller; the value is the program's exit status.
enum class ErrorKind {
    Mismatch = 1,     ///< two models disagree, or an invariant is broken
    Input = 2,        ///< bad usage, bad scene, bad file
    Environment = 3,  ///< disk, memory, a missing tool or package
};

/// The one kind of error in the project: what is wrong, where, what was expected, what to do.
/// `where` is `file:line:column` for text, `file: offset N` for binary input, a key or an option
/// otherwise; it may be empty. `expected` and `advice` may be empty, `what` never is.
struct Error {
    ErrorKind kind = ErrorKind::Input;
    std::string where;
    std::string what;
    std::string expected;
    std::string advice;

    /// `where: what, expected E; advice`, with the empty parts left out.
    std::string message() const {
        std::string text = where.empty() ? what : where + ": " + what;
        if (!expected.empty()) text += ", expected " + expected;
        if (!advice.empty()) text += "; " + advice;
        return text;
    }
};

/// A value or the Error that prevented it. Reading the wrong side is a programming mistake.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::move(value)) {}
    Result(Error error) : state_(std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() { return std::get<0>(state_); }
    const T& value() const { return std::get<0>(state_); }
    const Error& error() const { return std::get<1>(state_); }

    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, Error> state_;
};

/// The result of an action that has no value of its own.
using Status = Result<std::monostate>;

inline Status done() { return std::monostate{}; }

}  // namespace repousse
