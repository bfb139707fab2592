#!/usr/bin/env python3
"""Makes from the table of the API (api/) what follows from it: the C API, the glue and types of Python and of the
npm package, and the commands of a world as bytes.

usage: tools/api.py           writes the files
       tools/api.py --check   writes nothing: exit status 1 if a file is not what would be written, or the table does not
                              agree with the public C++ headers (include/cairn)
"""
import sys

import api_c_fuzz
import api_c_header
import api_c_source
import api_c_wrong_calls
import api_commands
import api_python
import api_table
import api_web
import api_web_recorder
import api_web_types


def files(table):
    """(path, text) of all generated files."""
    for group in api_table.GROUPS:
        yield f"include/cairn/c/{group}.h", api_c_header.header(table, group)
    yield "include/cairn/c/cairn.h", api_c_header.umbrella()
    generated = "src/c_api/generated"
    yield f"{generated}/convert.h", api_c_source.convert_header(table)
    yield f"{generated}/defaults.cpp", api_c_source.defaults_source(table)
    for group in api_table.GROUPS:
        for name, make in ((f"convert_{group}", api_c_source.convert_source), (group, api_c_source.functions_source)):
            text = make(table, group)
            if text:
                yield f"{generated}/{name}.cpp", text
    yield f"{generated}/cairn_c.map", api_c_source.version_script(table)
    yield "tests/c_api/layout.c", api_c_source.layout_program(table)
    yield "tests/fuzz/c_api_calls.inc", api_c_fuzz.program(table)
    module = "python/module/generated"
    yield f"{module}/types.h", api_python.glue_types_header(table)
    for group in api_table.GROUPS:
        text = api_python.glue_types_source(table, group)
        if text:
            yield f"{module}/types_{group}.cpp", text
    yield f"{module}/docs.cpp", api_python.docs_source()
    yield f"{module}/world.cpp", api_python.glue_methods(table, "World")
    yield f"{module}/body.cpp", api_python.glue_methods(table, "Body")
    yield "python/cairn/_types/__init__.py", api_python.types_package(table)
    for group in api_table.GROUPS:
        text = api_python.types_module(table, group)
        if text:
            yield f"python/cairn/_types/{group}.py", text
    yield "python/cairn/_cairn.pyi", api_python.stubs(table)
    yield from api_web.files(table)
    yield "web/src/index.d.ts", api_web_types.types(table)
    yield "tests/web/generated/recorded_world.h", api_web_recorder.recorder(table)
    yield "tests/c_api/wrong_calls.c", api_c_wrong_calls.program(table)
    yield from api_commands.files(table)


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    table = api_table.Table()
    findings = [*api_table.disagreements(table), *api_commands.disagreements(table)]
    for path, text in files(table):
        file = api_table.ROOT / path
        if file.exists() and file.read_text(encoding="utf-8") == text:
            continue
        if sys.argv[1:]:
            findings.append(f"{path} is not what the table says: run tools/api.py")
        else:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
            print(f"wrote {path}")
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
