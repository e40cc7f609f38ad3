#!/usr/bin/python3
"""check_schema.py SCHEMA GOOD [BAD]: compares a JSON Schema with case files.

The schema must be a valid one of draft 2020-12, accept every *.toml in the folder GOOD and refuse
every *.toml in the folder BAD. Files and schema are read by Python's own TOML reader and by the
package jsonschema, so that nothing of this program takes part. Exit code 77 without that package.
"""
import json
import pathlib
import sys
import tomllib

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)


def main(schema_file, good, bad=None):
    schema = json.loads(pathlib.Path(schema_file).read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    failures = 0
    for folder, valid in ((good, True), (bad, False)):
        files = sorted(pathlib.Path(folder).glob("*.toml")) if folder else []
        for file in files:
            data = tomllib.loads(file.read_text(encoding="utf-8"))
            errors = list(validator.iter_errors(data))
            if bool(errors) != valid:  # as it should be
                continue
            failures += 1
            reason = f"{errors[0].json_path}: {errors[0].message}" if errors else "accepted"
            print(f"{file}: {reason[:400]}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
