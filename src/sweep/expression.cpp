#include "sweep/expression.h"

#include <cairn/error.h>

#include <muParser.h>

#include <exception>
#include <map>

namespace cairn::sweep {

namespace {

constexpr const char* name_letters = "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.[]#";

} // namespace

struct Expression::Parser {
    std::string text;
    const Variables* variables = nullptr;      // set while the expression is parsed
    std::map<std::string, std::string> quoted; // by the placeholders in muParser's text
    std::exception_ptr error;
    mu::Parser parser;

    // Replaces quoted names, which muParser's syntax does not allow, by placeholders.
    std::string unquoted() {
        std::string result;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const std::size_t end = text[i] == '\'' ? text.find('\'', i + 1) : std::string::npos;
            if (text[i] != '\'') {
                result += text[i];
                continue;
            }
            if (end == std::string::npos) fail("must have a closing '");
            const std::string name = "q" + std::to_string(quoted.size()) + "#";
            quoted[name] = text.substr(i, end - i + 1);
            result += name;
            i = end;
        }
        return result;
    }
    std::string as_written(std::string name) const {
        for (const auto& [stand_in, original] : quoted) {
            for (std::size_t at = name.find(stand_in); at != std::string::npos; at = name.find(stand_in))
                name.replace(at, stand_in.size(), original);
        }
        return name;
    }
    [[noreturn]] void fail(const std::string& why) const { throw Error(ErrorCode::invalid_value, text, {}, why); }
    [[noreturn]] void pass_on(const mu::Parser::exception_type& cause) const {
        std::string why = as_written(cause.GetMsg());
        while (!why.empty() && (why.back() == '.' || why.back() == ' ')) why.pop_back();
        fail("is not a valid expression: " + why);
    }

    static double* variable(const char* name, void* self) {
        Parser& parser = *static_cast<Parser*>(self);
        return (*parser.variables)(parser.as_written(name));
    }
};

Expression::Expression(const std::string& text, const Variables& variables) : parser_(std::make_unique<Parser>()) {
    parser_->text = text;
    parser_->variables = &variables;
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) parser_->fail("must be an expression, and is empty");
    try {
        mu::Parser& parser = parser_->parser;
        parser.DefineNameChars(name_letters);
        parser.SetVarFactory(&Parser::variable, parser_.get());
        parser.DefineConst("pi", 3.14159265358979323846);
        parser.SetExpr(parser_->unquoted());
        parser.Eval(); // parses the expression
        if (parser.GetNumResults() != 1) parser_->fail("must be one expression, not several with commas between them");
    } catch (const mu::Parser::exception_type& error) {
        parser_->pass_on(error);
    }
}
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::value() const {
    try {
        return parser_->parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
        parser_->pass_on(error);
    }
}

} // namespace cairn::sweep
