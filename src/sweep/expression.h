// Expressions in numbers, as muParser reads them: + - * / ^, comparisons, && ||, a ? b : c, min, max, abs, sqrt, sin,
// ...
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace cairn::sweep {

// What may stand in a plan as a variable, where its value is.
using Variables = std::function<double*(const std::string& name)>;

// One for each thread.
class Expression {
  public:
    // `variables` is asked once for each variable; it throws Error for what is not there. Names may have dots, numbers
    // in brackets, and parts in single quotes. Throws Error (invalid_value) whose field is the text.
    Expression(const std::string& text, const Variables& variables);
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    // Where something has no value (the root of -1, 0 / 0), it is not a number. Throws Error (invalid_value).
    double value() const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace cairn::sweep
