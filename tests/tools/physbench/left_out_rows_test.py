"""Preprocesses the rows of physbench that a build leaves out unless all are asked for, by the commands that would
compile them: a header that they do not find would else be missed until somebody runs `tools/dev run --all`."""
import json
import pathlib
import re
import shlex
import subprocess
import sys

TARGETS = ("physbench_double_rows", "physbench_cuda_rows")


def commands(build):
    """Of each file of the left-out rows: its path, and its command as a list of arguments."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        arguments = shlex.split(entry["command"])
        if any(f"CMakeFiles/{target}.dir/" in argument for target in TARGETS for argument in arguments) and "-o" in arguments:
            yield entry["file"], entry["directory"], arguments


def preprocess(arguments, directory):
    """What the preprocessor says of a file; None where it finds all headers."""
    place = arguments.index("-o")
    of_headers = [*arguments[:place], "-o", "/dev/null", *arguments[place + 2 :]]
    of_headers = ["-E" if argument in ("-c", "-x=cu") else argument for argument in of_headers]
    done = subprocess.run(of_headers, cwd=directory, capture_output=True, text=True, check=False)
    return None if done.returncode == 0 else done.stderr


def main():
    found = list(commands(pathlib.Path(sys.argv[1])))
    if not any(re.search(r"double_rows", file) for file, _, _ in found):
        sys.exit("compile_commands.json has no file of rows in double")
    failed = 0
    for file, directory, arguments in found:
        message = preprocess(arguments, directory)
        if message is not None:
            failed += 1
            print(f"{file} cannot be preprocessed:\n{message}")
    print(f"{len(found)} files, {failed} without a header")
    sys.exit(1 if failed else 0)


main()
