#!/usr/bin/env python3
"""separate_commands.py FOLDER: writes FOLDER/tidy/compile_commands.json, that of FOLDER with a command for each source that CMake
or physgen_join_cuda joins with others in one file (physgen_join), and prints the name of its folder."""
import json
import re
import sys
from pathlib import Path

folder = Path(sys.argv[1])
commands = []
for command in json.loads((folder / "compile_commands.json").read_text()):
    file = command["file"]
    if "/Unity/unity_" in file or "/joined/" in file:
        for source in re.findall('#include "(.*)"', Path(file).read_text()):
            commands.append({**command, "file": source, "command": command["command"].replace(file, source)})
    else:
        commands.append(command)
(folder / "tidy").mkdir(exist_ok=True)
(folder / "tidy/compile_commands.json").write_text(json.dumps(commands, indent=1))
print(folder / "tidy")
