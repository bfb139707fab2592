// Numeric expressions with the syntax of muParser: + - * / ^, comparisons, && ||, a ? b : c, min, max, abs, sqrt, sin,
// ...
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace cairn::sweep {

// Returns the address of the value of a variable.
using Variables = std::function<double*(const std::string& name)>;

// An expression; each thread needs one of its own.
class Expression {
  public:
    // `variables` is called once for each variable, and throws Error for unknown names. Names may contain dots, numbers
    // in brackets, and parts in single quotes. Throws Error (invalid_value) whose field is the text.
    Expression(const std::string& text, const Variables& variables);
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    // Evaluates the expression; undefined values (the root of -1, 0 / 0) are NaN. Throws Error (invalid_value).
    double value() const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace cairn::sweep
