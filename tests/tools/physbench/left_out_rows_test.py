"""Preprocesses the rows of physbench that a build leaves out unless all are asked for, by the commands that would
compile them: a header that they do not find would else be missed until somebody runs `tools/dev run --all`. Files of one
command are preprocessed as one, since what takes time are the headers that all of them include."""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

TARGETS = ("physbench_double_rows", "physbench_cuda_rows")


def commands(build):
    """The files of the left-out rows by their command, which is (folder, arguments without the file and the output)."""
    files = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        arguments = shlex.split(entry["command"])
        if any(f"CMakeFiles/{target}.dir/" in argument for target in TARGETS for argument in arguments) and "-o" in arguments:
            place = arguments.index("-o")
            rest = [argument for argument in arguments[:place] + arguments[place + 2 :] if argument not in ("-c", entry["file"])]
            files.setdefault((entry["directory"], *rest), []).append(entry["file"])
    return files


def preprocess(directory, arguments, files, folder):
    """What the preprocessor says of files that are included one behind the other; None where it finds all headers."""
    all_files = folder / f"all{pathlib.Path(files[0]).suffix}"
    all_files.write_text("".join(f'#include "{file}"\n' for file in files))
    done = subprocess.run(
        [*arguments, "-E", str(all_files), "-o", "/dev/null"], cwd=directory, capture_output=True, text=True, check=False
    )
    return None if done.returncode == 0 else done.stderr


def main():
    found = commands(pathlib.Path(sys.argv[1]))
    names = [file for files in found.values() for file in files]
    if not any(re.search(r"double_rows", file) for file in names):
        sys.exit("compile_commands.json has no file of rows in double")
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for (directory, *arguments), files in found.items():
            message = preprocess(directory, arguments, files, pathlib.Path(folder))
            if message is not None:
                failed += 1
                print(f"of {', '.join(files)}, one cannot be preprocessed:\n{message}")
    print(f"{len(names)} files of {len(found)} commands, {failed} commands without a header")
    sys.exit(1 if failed else 0)


main()
