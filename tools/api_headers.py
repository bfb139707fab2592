"""Reads the declarations of the public C++ headers, with which the table of the API (api/) must agree.

It relies on the style of this project's headers: one declaration per statement, no macros, documentation in `///`. It
is no general C++ parser.
"""
import pathlib
import re
from dataclasses import dataclass, field


@dataclass
class Variable:
    """A member of a struct, or a parameter."""
    name: str
    type: str
    default: str = ""
    doc: str = ""


@dataclass
class Function:
    name: str
    returns: str
    parameters: list
    is_const: bool
    doc: str = ""

    def signature(self):
        """The notation of the table: distinguishes overloads, without parameter names and defaults."""
        return f"{self.name}({', '.join(p.type for p in self.parameters)}){' const' if self.is_const else ''}"


@dataclass
class Headers:
    enums: dict = field(default_factory=dict)     # name: [(value, doc)]
    structs: dict = field(default_factory=dict)   # name: [Variable]
    classes: dict = field(default_factory=dict)   # public member functions
    functions: list = field(default_factory=list)  # outside of classes
    variants: dict = field(default_factory=dict)  # name: [type]


def _split(text, separator):
    """Splits a text at separators that are not inside brackets."""
    parts, depth, part = [], 0, ""
    for character in text:
        depth += (character in "([{<") - (character in ")]}>")
        if character == separator and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += character
    return [p for p in parts + [part.strip()] if p]


def _statements(body):
    """(documentation, statement) for each statement of a block; bodies of functions are skipped."""
    doc, statement, depth, last = [], "", 0, None
    found = []

    def close():
        nonlocal doc, statement, last
        text = re.sub(r"\s+", " ", statement).strip()
        if text:
            last = [doc, text]
            found.append(last)
        doc, statement = [], ""

    for line in body.split("\n"):
        code, _, comment = line.partition("//")
        if comment.startswith("/<") and not statement.strip() and not code.strip():
            last[0].append(comment[2:].strip())  # continues the comment of the previous line
            continue
        if comment.startswith("/<"):
            trailing = comment[2:].strip()
        else:
            trailing = ""
            if comment.startswith("/") and not code.strip():
                doc.append(comment[1:].strip())
            elif comment and not code.strip() and not statement.strip():
                doc = []
        for character in code:
            depth += (character in "({") - (character in ")}")
            if depth == 0 and character == ";":
                close()
            elif depth == 0 and character == "}" and ")" in statement.split("{")[0]:
                close()  # a function with a body
            else:
                statement += character
        statement += " "
        if trailing and (last is not None) and not statement.strip():
            last[0].append(trailing)
        elif trailing:
            doc.append(trailing)
    return [(" ".join(d), t) for d, t in found]


def _variables(doc, statement):
    statement = re.sub(r"^(static|inline|constexpr|mutable)\s+", "", statement)
    match = re.match(r"((?:const )?[\w:]+(?:<[^;{=]*>)?(?:\s*[&*])?)\s+(.*)", statement)
    if not match:
        return
    for declarator in _split(match[2], ","):
        name = re.match(r"(\w+)(\[\d+\])?", declarator)
        kind = match[1] + (name[2] or "")
        default = declarator[name.end():].strip()
        yield Variable(name[1], kind, default.removeprefix("=").strip(), doc)


def _function(doc, statement):
    match = re.match(r"(?:\[\[\w+\]\] )?(?:static |inline |constexpr |explicit )*(.*?)\b(~?\w+)\((.*)\)( const)?( noexcept)?", statement)
    if not match or "operator" in statement:
        return None
    parameters = []
    for parameter in _split(match[3], ","):
        before, _, default = parameter.partition("=")
        pieces = re.match(r"(.*?[\s&*>])(\w+)$", before.strip())
        kind, name = (pieces[1], pieces[2]) if pieces else (before, "")
        parameters.append(Variable(name, kind.strip(), default.strip()))
    return Function(match[2], match[1].strip(), parameters, bool(match[4]), doc)


def _block(text, start):
    """The text between the brace at `start` and the matching one."""
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return text[start + 1:i]
    raise ValueError("a brace is not closed")


def read(folder):
    """All public headers below a folder."""
    found = Headers()
    for path in sorted(pathlib.Path(folder).glob("*.h")):
        text = path.read_text(encoding="utf-8")
        for match in re.finditer(r"^( *)enum class (\w+)(?: : [\w:]+)? \{", text, re.M):
            body = _block(text, match.end() - 1)
            values, doc = [], ""
            for line in body.split("\n"):
                code, _, comment = line.partition("//")
                names = re.findall(r"\w+", code)
                if comment.startswith("/<") and not names and values:
                    values[-1] = (values[-1][0], values[-1][1] + " " + comment[2:].strip())
                elif comment.startswith("/") and not names:
                    doc = (doc + " " + comment[1:].strip()).strip()
                for name in names:
                    values.append((name, comment[2:].strip() if comment.startswith("/<") else doc))
                    doc = ""
            found.enums[match[2]] = values
        for match in re.finditer(r"^(struct|class) (\w+) (?:: [^{]*)?\{", text, re.M):
            body = _block(text, match.end() - 1)
            if match[1] == "class":
                body = body[body.find("public:") + 7:].split("private:")[0]
            body = re.sub(r"enum class \w+ : [\w:]+ \{.*?\};", "", body, flags=re.S)
            for doc, statement in _statements(body):
                head = re.split(r"[={]", statement)[0]
                if "(" in head or "operator" in statement:
                    function = _function(doc, statement)
                    if function:
                        found.classes.setdefault(match[2], []).append(function)
                elif match[1] == "struct":
                    found.structs.setdefault(match[2], []).extend(_variables(doc, statement))
            if match[1] == "struct":
                found.structs.setdefault(match[2], [])
        for match in re.finditer(r"^using (\w+) = std::variant<([^;]*)>;", text, re.M):
            found.variants[match[1]] = [re.sub(r"\s+", " ", t) for t in _split(match[2], ",")]
    return found
